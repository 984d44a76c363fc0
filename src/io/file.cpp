// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/io/file.h"

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "croquis/base/error.h"
#include "io/system_files.h"

namespace croquis {

std::string read_file(const std::string& path) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file.valid()) fail_reading(path, reading_reason(errno));
  struct stat status {};
  if (::fstat(file.get(), &status) != 0) fail_reading(path, reading_reason(errno));
  if (S_ISDIR(status.st_mode)) fail_reading(path, reading_reason(EISDIR));

  // One byte more than the size, so that the end is met without growing; pipes have no size and grow by doubling.
  std::string bytes(static_cast<std::size_t>(S_ISREG(status.st_mode) ? status.st_size + 1 : 65536), '\0');
  std::size_t used = 0;
  while (true) {
    if (used == bytes.size()) bytes.resize(2 * bytes.size());
    const ssize_t count = ::read(file.get(), bytes.data() + used, bytes.size() - used);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail_reading(path, reading_reason(errno));
    if (count == 0) break;
    used += static_cast<std::size_t>(count);
  }
  bytes.resize(used);
  return bytes;
}

std::string reading_reason(int error) {
  switch (error) {
    case ENOENT: return "there is no such file";
    case EACCES: return "you have no permission to read it";
    case EISDIR: return "it is a folder";
    case ENOTDIR: return "a part of its path is not a folder";
    default: return std::strerror(error);
  }
}

std::string writing_reason(int error) {
  switch (error) {
    case ENOENT: return "its folder does not exist";
    case ENOTDIR: return "a part of its path is not a folder";
    case EISDIR: return "it is a folder";
    case EACCES: return "you have no permission to write there";
    case ENOSPC: return "the disk is full";
    default: return std::strerror(error);
  }
}

void sync_folder_of(const std::filesystem::path& file) {
  const std::filesystem::path folder = file.parent_path();
  const Descriptor directory(::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (directory.valid()) ::fsync(directory.get());
}

void fail_reading(const std::string& path, const std::string& reason) {
  throw Error(make_error(Category::Malformed, "E_FILE_OPEN", "The file '" + path + "' can't be read: " + reason + ".",
                         {{SubjectKind::File, path, path, std::nullopt, {}}}));
}

void fail_writing(const std::string& path, const std::string& reason) {
  throw Error(make_error(Category::Io, "E_WRITE", "The file '" + path + "' can't be written: " + reason + ".",
                         {{SubjectKind::File, path, path, std::nullopt, {}}}));
}

}  // namespace croquis
