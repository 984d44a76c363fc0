// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command.h"
#include "cli/commands/follow_ups.h"

namespace croquis::cli {

std::vector<Command> all_commands(const Registry& registry) {
  std::vector<Command> commands;
  for (const auto& operation : registry.operations()) {
    if (reads_files(operation->describe())) commands.push_back(operation_command(*operation, registry));
  }
  for (Command& command : std::vector{info_command(), check_command(), convert_command(), render_command(),
                                      run_command(registry), operations_command(registry), edits_command()})
    commands.push_back(std::move(command));
  return commands;
}

}  // namespace croquis::cli
