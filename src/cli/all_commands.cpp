// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command.h"
#include "cli/commands/edits_command.h"
#include "cli/commands/mesh_commands.h"
#include "cli/commands/operation_command.h"
#include "cli/commands/operations_command.h"
#include "cli/commands/render_command.h"
#include "cli/commands/run_command.h"

namespace croquis::cli {

std::vector<std::unique_ptr<Command>> all_commands(const Registry& registry) {
  std::vector<std::unique_ptr<Command>> commands;
  for (const auto& operation : registry.operations()) {
    if (reads_files(operation->describe()))
      commands.push_back(std::make_unique<OperationCommand>(*operation, registry));
  }
  commands.push_back(std::make_unique<InfoCommand>());
  commands.push_back(std::make_unique<CheckCommand>());
  commands.push_back(std::make_unique<ConvertCommand>());
  commands.push_back(std::make_unique<RenderCommand>());
  commands.push_back(std::make_unique<RunCommand>(registry));
  commands.push_back(std::make_unique<OperationsCommand>(registry));
  commands.push_back(std::make_unique<EditsCommand>());
  return commands;
}

}  // namespace croquis::cli
