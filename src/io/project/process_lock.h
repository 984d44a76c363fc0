// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include "io/system_files.h"

namespace croquis {

/// A file that shows that its process runs. The system's lock ends with the process, however it ends; where a file
/// system has no locks, the file's text decides: process, its start and the machine's.
class ProcessLock {
 public:
  /// @return nothing when the name is taken
  /// @throws Error E_WRITE when the file can't be made
  static std::optional<ProcessLock> take(const std::filesystem::path& path);

  ProcessLock(ProcessLock&& other) noexcept : file_(-1) { file_ = std::move(other.file_); }
  ProcessLock& operator=(ProcessLock&&) noexcept = default;

 private:
  explicit ProcessLock(int file) : file_(file) {}

  Descriptor file_;
};

/// Whether the process that took the lock still runs. False when there is no such file.
bool is_process_alive(const std::filesystem::path& lock);

}  // namespace croquis
