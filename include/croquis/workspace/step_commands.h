// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "croquis/workspace/workspace.h"

/// Steps of the chains of a workspace, and what people do to them: each command is one step of the history.
namespace croquis {

/// The first operation whose chain goes on from that type of value; null for none.
const OperationDescription* first_operation_on(const Registry& registry, ValueType type);

/// All that can be the next step after a node and gives a mesh, in the registry's order.
std::vector<const OperationDescription*> operations_on(const Workspace& workspace, NodeId node);

/// The step of an object that is selected by itself; 0 for none.
NodeId chosen_step(const Session& session, const WorkObject& object);

/// The step that panels are about: the selected one of the active object, else its last one. 0 without an object.
NodeId active_step(const Workspace& workspace);

/// That step, when it is an operation; or null.
const Node* active_operation(const Workspace& workspace);

/// The last step of the object that has this operation, or null.
const Node* step_with(const Workspace& workspace, const WorkObject& object, const std::string& operation);

/// A node of a chain with what is known of it; it is in the document.
ChainStep step_at(const Workspace& workspace, NodeId node);

/// The steps of an object, its first node first.
std::vector<ChainStep> steps_of(const Workspace& workspace, const WorkObject& object);

/// On top of an object, or after the step of it that is selected. Selects it. @return its node
/// @throws Error (E_STEP)
NodeId add_step(Workspace& workspace, NodeId after, const std::string& operation,
                const ParameterValues& parameters = {});
void remove_step(Workspace& workspace, NodeId step);  ///< @throws Error (E_STEP), as do the following
void enable_step(Workspace& workspace, NodeId step, bool enabled);
void move_step(Workspace& workspace, NodeId step, int by);  ///< 1 later, -1 earlier
void copy_step(Workspace& workspace, NodeId step);
void freeze_step(Workspace& workspace, NodeId step);  ///< what it gave, or gave last, becomes a source

/// Makes a step of edits fit the mesh that it is given now. By number: its lines stay as they are.
/// @throws Error (E_STEP) when the mesh isn't computed yet, and (E_EDIT, E_INPUT …) when it lacks an element
void reapply_step(Workspace& workspace, NodeId step);
/// By position: each line's elements become those nearest to where its elements were.
/// @throws Error (E_STEP) as well when the mesh that the edits were made for isn't kept any more
void reapply_step_by_position(Workspace& workspace, NodeId step);

}  // namespace croquis
