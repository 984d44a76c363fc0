// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "cli/command.h"

namespace croquis::cli {

/// Parses, runs one command within its limits, writes its files together, prints its report.
/// Never throws; returns the exit code.
int run(const std::vector<std::string>& arguments, const std::vector<Command>& commands);

}  // namespace croquis::cli
