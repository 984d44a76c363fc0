// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/command.h"

namespace croquis::cli {

/// `edits`: every edit with its parameters, and the reference page.
class EditsCommand final : public Command {
 public:
  CommandDescription describe() const override;
  void run(const Invocation& invocation, CommandResult& result, Progress& progress) const override;
};

}  // namespace croquis::cli
