// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace croquis::bench {

/// Runs a program that PATH finds, without its output, and waits for it.
/// @return processor time of it and of the processes that it waited for, in ms; nothing when it can't be run or fails
std::optional<double> cpu_ms_of(const std::vector<std::string>& command);

/// What a program took altogether.
struct ChildUse {
  double cpu_ms = 0;
  double mebibytes = 0;  ///< held by the largest of its processes at its peak
};

/// The same, with its memory.
std::optional<ChildUse> use_of(const std::vector<std::string>& command);

bool is_installed(const std::string& program);

}  // namespace croquis::bench
