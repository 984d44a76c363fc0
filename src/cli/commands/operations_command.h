// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/command.h"

namespace croquis::cli {

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
