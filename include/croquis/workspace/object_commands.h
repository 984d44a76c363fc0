// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "croquis/workspace/workspace.h"

/// What people do to whole objects of a workspace: each command is one step of the history.
namespace croquis {

/// An object and where it stands or is to stand.
struct PlacedObject {
  NodeId node = 0;
  Placement placement;
};

/// The objects that are selected as wholes, or some step of theirs, in the document's order: their nodes.
std::vector<NodeId> picked(const Workspace& workspace);
std::vector<NodeId> picked_or_active(const Workspace& workspace);  ///< where none is selected, the active one

/// These objects and all that share a group with one of them, in the document's order.
std::vector<NodeId> with_groups(const Workspace& workspace, const std::vector<NodeId>& objects);

/// The document with these objects placed so; those that share their first node go together.
Document with_objects_placed(const Workspace& workspace, Document document, const std::vector<PlacedObject>& objects);

/// Adds a value as an object, and selects it. The first one of an empty document is no step of the history.
/// @return its node
NodeId add_source(Workspace& workspace, const std::string& name, Value value);

void remove_objects(Workspace& workspace,
                    const std::vector<NodeId>& objects);  ///< with all that they alone are made of
/// The copies stand beside them along x, as far as all of them reach and a tenth more, and are selected.
void copy_objects(Workspace& workspace, const std::vector<NodeId>& objects);
void rename_object(Workspace& workspace, NodeId node, const std::string& name);
void show_objects(Workspace& workspace, const std::vector<NodeId>& objects, bool visible);
/// @throws Error (E_PARAMETER) for no valid place
void place_objects(Workspace& workspace, const std::vector<PlacedObject>& objects);
void group_objects(Workspace& workspace, const std::vector<NodeId>& objects);  ///< they leave the groups they were in
void ungroup_objects(Workspace& workspace, const std::vector<NodeId>& objects);
void rename_group(Workspace& workspace, const std::string& group, const std::string& name);

}  // namespace croquis
