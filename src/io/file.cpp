// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/io/file.h"

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "croquis/base/error.h"
#include "io/descriptor.h"

namespace croquis {
namespace {

[[noreturn]] void fail(const std::string& path, const std::string& reason) {
  throw Error(make_error(Category::Malformed, "E_FILE_OPEN", "The file '" + path + "' can't be read: " + reason + ".",
                         {{SubjectKind::File, path, path, std::nullopt, {}}}));
}

std::string reason_of(int error) {
  switch (error) {
    case ENOENT: return "there is no such file";
    case EACCES: return "you have no permission to read it";
    case EISDIR: return "it is a folder";
    case ENOTDIR: return "a part of its path is not a folder";
    default: return std::strerror(error);
  }
}

}  // namespace

std::string read_file(const std::string& path) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file.valid()) fail(path, reason_of(errno));
  struct stat status {};
  if (::fstat(file.get(), &status) != 0) fail(path, reason_of(errno));
  if (S_ISDIR(status.st_mode)) fail(path, reason_of(EISDIR));

  // One byte more than the size, so that the end is met without growing; pipes have no size and grow by doubling.
  std::string bytes(static_cast<std::size_t>(S_ISREG(status.st_mode) ? status.st_size + 1 : 65536), '\0');
  std::size_t used = 0;
  while (true) {
    if (used == bytes.size()) bytes.resize(2 * bytes.size());
    const ssize_t count = ::read(file.get(), bytes.data() + used, bytes.size() - used);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(path, reason_of(errno));
    if (count == 0) break;
    used += static_cast<std::size_t>(count);
  }
  bytes.resize(used);
  return bytes;
}

}  // namespace croquis
