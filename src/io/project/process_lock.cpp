// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/project/process_lock.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <xxhash.h>

#include "croquis/io/project_lock.h"
#include "io/system_files.h"

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

namespace {

namespace fs = std::filesystem;

constexpr int take_attempts = 16;  // each time another process was quicker

/// One name for a project, however it is reached.
fs::path lock_file(const fs::path& folder, const fs::path& project) {
  std::error_code error;
  fs::path whole = fs::weakly_canonical(project, error);
  if (error) whole = fs::absolute(project, error);
  const std::string name = whole.string();
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "open-%016llx.lock",
                static_cast<unsigned long long>(XXH3_64bits(name.data(), name.size())));
  return folder / text.data();
}

}  // namespace

struct ProjectLock::State {
  fs::path file;
  ProcessLock lock;

  ~State() { ::unlink(file.c_str()); }
};

ProjectLock::ProjectLock(std::unique_ptr<State> state) : state_(std::move(state)) {}
ProjectLock::ProjectLock(ProjectLock&&) noexcept = default;
ProjectLock& ProjectLock::operator=(ProjectLock&&) noexcept = default;
ProjectLock::~ProjectLock() = default;

std::optional<ProjectLock> ProjectLock::take(const fs::path& folder, const fs::path& project) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) fail_writing(folder.string(), writing_reason(error.value()));
  const fs::path file = lock_file(folder, project);
  for (int attempt = 0; attempt < take_attempts; ++attempt) {
    if (auto lock = ProcessLock::take(file)) {
      return ProjectLock(std::unique_ptr<State>(new State{file, std::move(*lock)}));
    }
    if (is_process_alive(file)) return std::nullopt;
    ::unlink(file.c_str());  // of a process that is gone
  }
  return std::nullopt;
}

}  // namespace croquis
