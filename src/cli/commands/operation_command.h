// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/command.h"

namespace croquis::cli {

/// The subcommand of an operation, made from its description: parameters become options, the first mesh output is -o,
/// every further output that can be a file is an option of its name, and the report output becomes `details`.
class OperationCommand final : public Command {
 public:
  explicit OperationCommand(const Operation& operation) : operation_(operation) {}

  CommandDescription describe() const override;
  void run(const Invocation& invocation, CommandResult& result, Progress& progress) const override;

 private:
  const Operation& operation_;
};

/// `operations`: every operation with its parameters, and the reference page.
class OperationsCommand final : public Command {
 public:
  explicit OperationsCommand(const Registry& registry) : registry_(registry) {}

  CommandDescription describe() const override;
  void run(const Invocation& invocation, CommandResult& result, Progress& progress) const override;

 private:
  const Registry& registry_;
};

}  // namespace croquis::cli
