// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/project/process_lock.h"

#include <array>
#include <cerrno>
#include <fstream>
#include <sstream>
#include <string>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "io/file_errors.h"

namespace croquis {
namespace {

/// When the process began, in ticks since the machine did: field 22 of /proc/PID/stat (proc(5)). Empty when it's gone.
std::string start_of(const std::string& process) {
  std::ifstream stream("/proc/" + process + "/stat");
  std::string text;
  std::getline(stream, text);
  const auto name_end = text.rfind(')');  // the second field may hold anything
  if (name_end == std::string::npos) return "";
  std::istringstream fields(text.substr(name_end + 1));
  std::string field;
  for (int number = 3; number <= 22; ++number) fields >> field;
  return field;
}

std::string machine_start() {
  std::ifstream stream("/proc/sys/kernel/random/boot_id");
  std::string id;
  stream >> id;
  return id;
}

bool is_same_file(int file, const std::filesystem::path& path) {
  struct stat opened {};
  struct stat named {};
  return ::fstat(file, &opened) == 0 && ::stat(path.c_str(), &named) == 0 && opened.st_ino == named.st_ino &&
         opened.st_dev == named.st_dev;
}

bool is_owner_alive(int file) {
  std::array<char, 256> buffer{};
  const ssize_t count = ::pread(file, buffer.data(), buffer.size(), 0);
  std::istringstream text(std::string(buffer.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0))));
  std::string process, start, machine;
  text >> process >> start >> machine;
  return !start.empty() && start == start_of(process) && machine == machine_start();
}

}  // namespace

std::optional<ProcessLock> ProcessLock::take(const std::filesystem::path& path) {
  ProcessLock lock(::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600));
  if (!lock.file_.valid()) {
    if (errno == EEXIST) return std::nullopt;
    fail_writing(path.string(), writing_reason(errno));
  }
  ::flock(lock.file_.get(), LOCK_EX | LOCK_NB);
  // Another process that cleans up may have removed it before it was locked.
  if (!is_same_file(lock.file_.get(), path)) return std::nullopt;
  const std::string process = std::to_string(::getpid());
  const std::string text = process + " " + start_of(process) + " " + machine_start() + "\n";
  if (::write(lock.file_.get(), text.data(), text.size()) != static_cast<ssize_t>(text.size())) {
    const int error = errno;
    ::unlink(path.c_str());
    fail_writing(path.string(), writing_reason(error));
  }
  return lock;
}

bool is_process_alive(const std::filesystem::path& lock) {
  const Descriptor file(::open(lock.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file.valid()) return false;
  if (::flock(file.get(), LOCK_EX | LOCK_NB) == 0) return false;
  return errno == EWOULDBLOCK || is_owner_alive(file.get());
}

}  // namespace croquis
