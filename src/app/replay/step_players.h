// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>

#include "croquis/tools/recording/step.h"

namespace croquis::app {

class MainWindow;

/// How the window does the steps of its tools, by their kind. Each throws Error when the step can't be done.
using StepPlayers = std::map<const recorded::StepKind*, std::function<void(MainWindow&, const recorded::Step&)>>;

/// One for every step of a tool in recorded::all_steps().
const StepPlayers& step_players();

}  // namespace croquis::app
