// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "croquis/workspace/workspace.h"

/// What is known of the results of a workspace's nodes.
namespace croquis {

/// A finding and the node that it is about; an error with the step that has to be mended.
struct NodeFinding {
  NodeId node = 0;
  Finding finding;
};

/// The mesh that a node gives to the next one, as far as it is there: computed already, or a source's. Or null.
std::shared_ptr<const PolyMesh> mesh_at(const Workspace& workspace, NodeId node);

/// The mesh that a node of some document holds or gives, when it is computed to the end; never an older one. Or null.
std::shared_ptr<const PolyMesh> final_mesh(const Workspace& workspace, const Document& document, NodeId node);

/// Whether all that some document shows is known: it can be shown at once.
bool is_computed(const Workspace& workspace, const Document& document);

/// Computes a node of some document now: for a step that is about to be added after what is computed already, as one
/// more edit, so that everybody finds its result.
/// @throws Error what is wrong with the step
void compute(Workspace& workspace, const Document& document, NodeId node);

/// A value of a type that the object's chain gives on its way, nearest to its end, moved with the steps after it and
/// placed as the object is:
/// the camera of a drawing in perspective, say. Without content where there is none, or where what gives it isn't
/// computed to the end.
Value value_along(const Workspace& workspace, const WorkObject& object, ValueType type);

/// Whether value_along has content. Moves nothing: of large meshes that takes long.
bool has_value_along(const Workspace& workspace, const WorkObject& object, ValueType type);

/// Some object has elements that can be edited.
bool has_cage(const Workspace& workspace);

/// The box around own_bounds where the object stands.
BoundingBox placed_bounds(const Workspace& workspace, const WorkObject& object);

/// Model units that 1 of a node's parameter comes to where its object stands; 0 where that isn't known yet, or is none
/// of ParameterLength's that can be measured.
double length_of_one(const Workspace& workspace, const Node& node, const ParameterDescription& parameter);

/// Whether nothing is drawn yet in what the object begins with.
bool begins_empty(const Document& document, const WorkObject& object);

/// The step that has to be mended before this one can be computed: maybe itself.
NodeId failing_step(const Workspace& workspace, NodeId step);

/// The findings of the newest results, errors first. Of steps that wait for another one, that one's reasons.
std::vector<NodeFinding> findings_of(const Workspace& workspace);

/// Of steps of edits that don't fit their input now, and of all after them: for files.
KeptResults kept_results(const Workspace& workspace);

}  // namespace croquis
