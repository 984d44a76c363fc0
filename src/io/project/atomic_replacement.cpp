// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/project/atomic_replacement.h"

#include <cerrno>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "io/file_errors.h"

namespace croquis {
namespace {

namespace fs = std::filesystem;

constexpr int most_name_attempts = 10000;

[[noreturn]] void fail(const fs::path& path, int error) { fail_writing(path.string(), writing_reason(error)); }

/// ".NAME." and ".saving" round a number: hidden, and distinct from other programs' files.
std::string temporary_prefix(const fs::path& target) { return "." + target.filename().string() + "."; }
constexpr const char* temporary_ending = ".saving";

fs::path folder_of(const fs::path& target) {
  const fs::path folder = target.parent_path();
  return folder.empty() ? fs::path(".") : folder;
}

fs::path resolved(const fs::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) {
    if (errno != ENOENT) fail(path, errno);
    return path;
  }
  if (S_ISDIR(status.st_mode)) fail(path, EISDIR);
  if (!S_ISREG(status.st_mode)) fail_writing(path.string(), "it is a device or pipe");
  if (::access(path.c_str(), W_OK) != 0) fail(path, errno);
  std::error_code error;
  const fs::path canonical = fs::canonical(path, error);
  return error ? path : canonical;
}

/// Temporary files of processes that died are not locked any more.
void remove_remains(const fs::path& target) {
  const std::string prefix = temporary_prefix(target);
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder_of(target), error)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(prefix) || !name.ends_with(temporary_ending)) continue;
    const Descriptor file(::open(entry.path().c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC));
    if (file.valid() && ::flock(file.get(), LOCK_EX | LOCK_NB) == 0) ::unlink(entry.path().c_str());
  }
}

int open_temporary(const fs::path& target, const fs::path& path, fs::path& temporary) {
  for (int attempt = 0; attempt < most_name_attempts; ++attempt) {
    const std::string number = std::to_string(::getpid()) + "-" + std::to_string(attempt);
    temporary = folder_of(target) / (temporary_prefix(target) + number + temporary_ending);
    const int file = ::open(temporary.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file >= 0) return file;
    if (errno != EEXIST) fail(path, errno);
  }
  fail_writing(path.string(), "no temporary file could be made in its folder");
}

fs::path backup(const fs::path& target, int number) { return target.string() + "~" + std::to_string(number); }

/// Makes room for NAME~1. Only files that block the place move, so that a gap, left by a process that died between
/// two of these steps, costs no backup.
void move_backups_on(const fs::path& target, int count) {
  int gap = 1;
  while (gap < count && fs::exists(fs::symlink_status(backup(target, gap)))) ++gap;
  for (int number = gap; number > 1; --number) {
    ::rename(backup(target, number - 1).c_str(), backup(target, number).c_str());
  }
}

/// The old file gets a second name, so that the first one is never without a file.
void keep_backup(const fs::path& target, const fs::path& path, int count) {
  struct stat status {};
  if (count < 1 || ::stat(target.c_str(), &status) != 0) return;
  move_backups_on(target, count);
  const fs::path first = backup(target, 1);
  ::unlink(first.c_str());  // only there when a single backup is kept, or when it could not be moved
  if (::link(target.c_str(), first.c_str()) == 0) return;
  std::error_code error;  // file systems without hard links
  fs::copy_file(target, first, fs::copy_options::overwrite_existing, error);
  if (error) fail(path, error.value());
}

}  // namespace

AtomicReplacement::AtomicReplacement(const fs::path& path) : path_(path), target_(resolved(path)), held_(-1) {
  remove_remains(target_);
  held_ = Descriptor(open_temporary(target_, path_, temporary_));
  ::flock(held_.get(), LOCK_EX | LOCK_NB);
  struct stat status {};
  if (::stat(target_.c_str(), &status) == 0) ::fchmod(held_.get(), status.st_mode & 07777);
}

AtomicReplacement::~AtomicReplacement() {
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void AtomicReplacement::commit(int backups) {
  if (::fsync(held_.get()) != 0 && errno != EINVAL) fail(path_, errno);
  keep_backup(target_, path_, backups);
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail(path_, errno);
  temporary_.clear();
  // Makes the renames survive a power cut; not every file system can, so failure is no error.
  const Descriptor folder(::open(folder_of(target_).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.valid()) ::fsync(folder.get());
}

}  // namespace croquis
