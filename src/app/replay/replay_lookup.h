// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/studio/studio.h"
#include "croquis/tools/pointer/pointer_event.h"

/// What the names in recordings stand for.
namespace croquis::app {

/// @throws Error (E_REPLAY)
[[noreturn]] void refuse_replay(const std::string& sentence);

Modifiers modifiers_of(const std::vector<std::string>& names);

/// The view of that name: "sketch" or none, "front", "perspective", "top", "side", "comparison".
/// @throws Error (E_REPLAY) for others
int view_of(const std::string& name);

/// The object of that name, or one of whose nodes has it; the active one when the name is empty.
/// @throws Error (E_REPLAY) when there is none, or it shows no mesh
const WorkObject& object_named(const Studio& studio, const std::string& name);

/// The node of that name or operation, a step of a chain too. @throws Error (E_REPLAY)
NodeId node_named(const Studio& studio, const std::string& name);

}  // namespace croquis::app
