// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/command.h"

namespace croquis::cli {

/// `info`: what a mesh file holds.
class InfoCommand final : public Command {
 public:
  CommandDescription describe() const override;
  void run(const Invocation& invocation, CommandResult& result, Progress& progress) const override;
};

/// `check`: succeeds only for closed, manifold, oriented meshes without self-intersection.
class CheckCommand final : public Command {
 public:
  CommandDescription describe() const override;
  void run(const Invocation& invocation, CommandResult& result, Progress& progress) const override;
};

/// `convert`: from any mesh format to any other.
class ConvertCommand final : public Command {
 public:
  CommandDescription describe() const override;
  void run(const Invocation& invocation, CommandResult& result, Progress& progress) const override;
};

}  // namespace croquis::cli
