// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cli/command.h"
#include "cli/commands/follow_ups.h"

namespace croquis::cli {

/// The subcommand of an operation, made from its description: parameters become options, the first output is -o, every
/// further output is an option of its name that writes a file, but for the report "details". Outputs that have no file
/// format are what follow-ups go on from, whose outputs and parameters are options as well. The first input is the
/// command's; every report among the further ones is an option of its name that reads a JSON file.
class OperationCommand final : public Command {
 public:
  /// @param registry where follow-ups are found; outlives the command
  OperationCommand(const Operation& operation, const Registry& registry);

  CommandDescription describe() const override;
  void run(const Invocation& invocation, CommandResult& result, Progress& progress) const override;

 private:
  const Operation& operation_;
  std::vector<FollowUp> follow_ups_;
};

}  // namespace croquis::cli
