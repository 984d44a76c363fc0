// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "croquis/document/document.h"
#include "croquis/document/evaluation.h"
#include "croquis/document/registry.h"

namespace croquis {

/// What of a chain stands in the views.
enum class ChainView {
  Cage,  ///< the cage alone; nothing is computed
  Both,  ///< the result, the cage's edges over it
  Result
};

/// What is known of a step.
enum class StepState {
  Source,          ///< nothing is computed here
  Fresh,           ///< computed, of the document as it is
  Computing,       ///< not computed yet
  Waiting,         ///< nothing is drawn yet
  Stale,           ///< failed, and goes on showing its last good result
  NeedsAttention,  ///< its edits were made for a mesh whose faces were joined in another way
  Held,            ///< waits for a step before it that can't be computed; goes on showing its last good result
  Failed,
  Off
};

/// One node of a chain.
struct ChainStep {
  NodeId node = 0;
  std::string name;
  std::string title;  ///< of its operation; empty for a source
  StepState state = StepState::Source;
  std::string problem;    ///< the first error's sentence; empty without one
  std::string waits_for;  ///< title of the step that has to be mended first; empty unless it is held
};

/// One thing that people work on: a chain of nodes, of which the last gives what is seen. A source that nothing uses is
/// a chain of one.
struct WorkObject {
  NodeId node = 0;            ///< the end of the chain
  std::vector<NodeId> chain;  ///< from the first node to the end
  NodeId editable = 0;        ///< the node whose elements can be edited; see Workspace::set_edits_elements
  NodeId cage = 0;            ///< that node, maybe `node` itself; 0: none, or only in element modes
  std::string name;           ///< of the source that the chain begins with, where there is one
  std::string group;          ///< the name that it shares with the objects it is handled with; empty for none
  Placement placement;        ///< from the space that its meshes and results lie in to the model's
  bool begins_with_mesh = false;
  bool visible = true;  ///< false as well while others are isolated
  ChainView view = ChainView::Result;
  std::shared_ptr<const PolyMesh> cage_mesh;  ///< null without a cage
  std::shared_ptr<const PolyMesh> mesh;       ///< the newest result's; of a source its own. Null before the first
  std::shared_ptr<const Evaluation> result;   ///< of an operation; null for a source and before the first one
  Quality quality = Quality::Final;

  /// Nothing is computed after the cage.
  bool is_source() const { return node == cage; }

  /// What stands in the views as a surface: the cage, too, as long as it couldn't be refined.
  const std::shared_ptr<const PolyMesh>& shown() const {
    return (view == ChainView::Cage || !mesh) && cage_mesh ? cage_mesh : mesh;
  }
};

/// The mesh of a source, or null.
std::shared_ptr<const PolyMesh> mesh_in(const Node& node);

/// The mesh that a node's operation gives to the next step, or null.
std::shared_ptr<const PolyMesh> mesh_of(const Evaluation& evaluation, const OperationDescription& operation);

/// The node whose elements people edit in a chain: the first one that gives a mesh, or the last of the steps directly
/// after it that edit their input (OperationDescription::edits_input).
/// @param chosen a step of the chain, or 0. Chosen, it is about the mesh that it is made from, with such steps;
///               about its own when it edits its input. The end is only chosen when it does
/// @return 0 when there is no mesh
NodeId editable_node(const Document& document, const Registry& registry, const std::vector<NodeId>& chain,
                     NodeId chosen = 0);

/// Whether the node's operation edits its input.
bool edits_input(const Node& node, const Registry& registry);

/// Every chain whose end gives a mesh and is used by no other node, in the document's order of their ends, without
/// results.
std::vector<WorkObject> objects_of(const Document& document, const Registry& registry);

}  // namespace croquis
