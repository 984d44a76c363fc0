// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "croquis/base/finding.h"
#include "croquis/tools/recording/step.h"

namespace croquis {

/// What the parts of a mesh tool tell each other about commands.
struct CommandLog {
  std::function<void()> begin;         ///< called before each command: a gesture under way is given up
  std::optional<recorded::Step> done;  ///< what the last Commit did
  Findings notes;                      ///< what the last edit lost or refused (warnings)
};

}  // namespace croquis
