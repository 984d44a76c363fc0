// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "croquis/io/file.h"
#include "io/system_files.h"

namespace croquis {
namespace {

namespace fs = std::filesystem;

constexpr int temporary_name_attempts = 10000;  // files of crashed runs may still be there

std::string sibling(const std::string& target, const char* ending, int attempt) {
  const fs::path path(target);
  std::string name = ".";
  name.append(path.filename().string()).append(1, '.').append(std::to_string(::getpid()));
  name.append(1, '-').append(std::to_string(attempt)).append(ending);
  return (path.parent_path() / name).string();
}

void write_all(int descriptor, const std::string& bytes, const std::string& path) {
  std::size_t written = 0;
  while (written < bytes.size()) {
    const ssize_t count = ::write(descriptor, bytes.data() + written, bytes.size() - written);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail_writing(path, writing_reason(errno));
    written += static_cast<std::size_t>(count);
  }
}

void write_directly(const std::string& path, const std::string& bytes) {
  Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (!file.valid()) fail_writing(path, writing_reason(errno));
  write_all(file.get(), bytes, path);
}

}  // namespace

OutputTransaction::~OutputTransaction() { roll_back(); }

void OutputTransaction::add(const std::string& path, std::string bytes) {
  const bool known = std::any_of(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.path == path; });
  if (known) fail_writing(path, "it is named for two different outputs");
  Entry entry;
  entry.path = path;
  entry.bytes = std::move(bytes);
  entries_.push_back(std::move(entry));
}

void OutputTransaction::commit() {
  try {
    for (Entry& entry : entries_) prepare(entry);
    for (Entry& entry : entries_) {
      if (!entry.direct) write_temporary(entry);
    }
    for (Entry& entry : entries_) {
      if (!entry.direct) keep_backup(entry);
    }
    rename_all();
    for (const Entry& entry : entries_) {
      if (entry.direct) write_directly(entry.path, entry.bytes);
    }
  } catch (...) {
    roll_back();
    throw;
  }
  for (const Entry& entry : entries_) {
    if (!entry.backup.empty()) ::unlink(entry.backup.c_str());
    if (!entry.direct) sync_folder_of(entry.target);
  }
  entries_.clear();
}

void OutputTransaction::prepare(Entry& entry) {
  entry.target = entry.path;
  struct stat status {};
  if (::stat(entry.path.c_str(), &status) != 0) {
    if (errno != ENOENT) fail_writing(entry.path, writing_reason(errno));
    return;
  }
  if (S_ISDIR(status.st_mode)) fail_writing(entry.path, writing_reason(EISDIR));
  if (::access(entry.path.c_str(), W_OK) != 0) fail_writing(entry.path, writing_reason(errno));
  entry.existed = true;
  entry.direct = !S_ISREG(status.st_mode);
  std::error_code error;
  const fs::path resolved = fs::canonical(entry.path, error);
  if (!error) entry.target = resolved.string();
}

void OutputTransaction::write_temporary(Entry& entry) {
  struct stat status {};
  const bool replaces = entry.existed && ::stat(entry.target.c_str(), &status) == 0;
  for (int attempt = 0; attempt < temporary_name_attempts; ++attempt) {
    const std::string name = sibling(entry.target, ".tmp", attempt);
    Descriptor file(::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (!file.valid() && errno == EEXIST) continue;
    if (!file.valid()) fail_writing(entry.path, writing_reason(errno));
    entry.temporary = name;
    if (replaces) ::fchmod(file.get(), status.st_mode & 07777);
    write_all(file.get(), entry.bytes, entry.path);
    if (::fsync(file.get()) != 0 && errno != EINVAL) fail_writing(entry.path, writing_reason(errno));
    if (!file.close()) fail_writing(entry.path, writing_reason(errno));
    return;
  }
  fail_writing(entry.path, "no temporary file could be made in its folder");
}

void OutputTransaction::keep_backup(Entry& entry) {
  for (int attempt = 0; attempt < temporary_name_attempts; ++attempt) {
    const std::string name = sibling(entry.target, ".old", attempt);
    if (::link(entry.target.c_str(), name.c_str()) == 0) {
      entry.backup = name;
      return;
    }
    // No file to keep, or a file system without hard links: then a later failure can't bring the old file back.
    if (errno != EEXIST) return;
  }
}

void OutputTransaction::rename_all() {
  for (Entry& entry : entries_) {
    if (entry.direct) continue;
    if (::rename(entry.temporary.c_str(), entry.target.c_str()) != 0) fail_writing(entry.path, writing_reason(errno));
    entry.temporary.clear();
    entry.renamed = true;
  }
}

void OutputTransaction::roll_back() noexcept {
  for (Entry& entry : entries_) {
    if (!entry.temporary.empty()) ::unlink(entry.temporary.c_str());
    if (entry.renamed && !entry.existed) ::unlink(entry.target.c_str());
    if (entry.renamed && !entry.backup.empty()) ::rename(entry.backup.c_str(), entry.target.c_str());
    if (!entry.renamed && !entry.backup.empty()) ::unlink(entry.backup.c_str());
  }
  entries_.clear();
}

}  // namespace croquis
