// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/command.h"

namespace croquis::cli {

/// `run`: evaluates a project and writes its visible meshes that no other visible mesh is made of.
class RunCommand final : public Command {
 public:
  /// @param registry outlives the command
  explicit RunCommand(const Registry& registry) : registry_(registry) {}

  CommandDescription describe() const override;
  void run(const Invocation& invocation, CommandResult& result, Progress& progress) const override;

 private:
  const Registry& registry_;
};

}  // namespace croquis::cli
