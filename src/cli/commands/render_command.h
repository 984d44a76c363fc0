// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/command.h"

namespace croquis::cli {

/// `render`: a picture of a mesh, without any display.
class RenderCommand final : public Command {
 public:
  CommandDescription describe() const override;
  void run(const Invocation& invocation, CommandResult& result, Progress& progress) const override;
};

}  // namespace croquis::cli
