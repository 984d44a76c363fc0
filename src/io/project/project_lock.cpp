// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/io/project_lock.h"

#include <array>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include <unistd.h>
#include <xxhash.h>

#include "io/file_errors.h"
#include "io/project/process_lock.h"

namespace croquis {
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
