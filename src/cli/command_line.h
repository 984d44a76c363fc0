// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "cli/command.h"

namespace croquis::cli {

/// The parsed arguments.
struct ParsedLine {
  const Command* command = nullptr;  ///< null when `text` is the whole output
  Invocation invocation;
  std::string text;  ///< help or version
};

/// Reads the arguments against the commands' own descriptions.
/// @throws Error (E_USAGE, E_PARAMETER; Category::Usage) naming the argument that can't be
ParsedLine parse_command_line(const std::vector<std::string>& arguments, const std::vector<Command>& commands);

}  // namespace croquis::cli
