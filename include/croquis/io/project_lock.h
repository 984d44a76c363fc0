// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

namespace croquis {

/// Says to other windows and processes of one user that a project is open: a file beside the working copies, named
/// after the project. It ends with its process, however that ends, so nothing a crash leaves blocks anybody.
class ProjectLock {
 public:
  /// @param folder  where working copies lie; made when it isn't there
  /// @param project a path; links to one project are one project
  /// @return nothing when another window or process has it open
  /// @throws Error E_WRITE (Io) when the folder can't be written
  static std::optional<ProjectLock> take(const std::filesystem::path& folder, const std::filesystem::path& project);

  ProjectLock(ProjectLock&&) noexcept;
  ProjectLock& operator=(ProjectLock&&) noexcept;

  /// The project can be opened elsewhere.
  ~ProjectLock();

 private:
  struct State;
  explicit ProjectLock(std::unique_ptr<State> state);

  std::unique_ptr<State> state_;
};

}  // namespace croquis
