// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/studio/studio.h"

/// The filling of the active object's holes: an operation at the end of its chain, of which everything is a parameter.
/// Every change is one step of the history.
namespace croquis::app {

/// The operation's id.
inline const std::string filling_operation = "fill";

/// Of the active object, or null where its last operation isn't `fill`.
const Node* filling_node(const Studio& studio);

/// The active object has a mesh whose holes can be looked at.
bool can_fill(const Studio& studio);

/// Gives the active object the operation, with no hole chosen, unless it has it.
/// @throws Error (E_EMPTY) when there is no mesh
void start_filling(Studio& studio);

/// The value of a parameter of the node, else that of its preset, else the default.
ParameterValue filling_value(const Studio& studio, const Node& node, const std::string& parameter);

/// The document with other values of that node.
Document with_values(const Studio& studio, const Node& node, const ParameterValues& values);

}  // namespace croquis::app
