// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "cli/command.h"
#include "croquis/base/error.h"

namespace croquis::cli {

/// How long one step of a command took.
struct StageTime {
  std::string name;
  double seconds = 0;
};

/// What the runner measured around a command.
struct RunFigures {
  std::string command;
  std::string input;
  std::string output;
  double seconds = 0;
  std::vector<StageTime> stages;
  std::int64_t peak_memory_bytes = 0;
};

/// The report of a command that succeeded: one line of JSON without a newline.
std::string success_json(const RunFigures& figures, const CommandResult& result);

/// The report of a command that failed, with whatever it had found out before.
std::string failure_json(const std::string& command, const Findings& errors, const CommandResult& result);

}  // namespace croquis::cli
