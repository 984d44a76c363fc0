// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "croquis/document/document.h"
#include "croquis/document/evaluation.h"
#include "croquis/document/registry.h"

namespace croquis::app {

/// How an object with a cage is shown (keys 1, 2, 3).
enum class SmoothView {
  Cage,  ///< the cage alone; nothing is computed
  Both,  ///< the smooth surface, the cage's edges over it
  Smooth
};

/// A mesh that the views show: the end of a chain of operations, or a mesh that none uses.
struct StudioObject {
  NodeId node = 0;   ///< gives the mesh
  NodeId cage = 0;   ///< the mesh source that the chain begins with, maybe `node` itself; 0: it begins elsewhere
  std::string name;  ///< of the cage where there is one
  bool visible = true;
  SmoothView view = SmoothView::Smooth;
  std::shared_ptr<const PolyMesh> cage_mesh;  ///< null without a cage
  std::shared_ptr<const PolyMesh> mesh;       ///< the newest result's; of a source its own. Null before the first
  std::shared_ptr<const Evaluation> result;   ///< of an operation; null for a source and before the first one
  Quality quality = Quality::Final;

  bool is_source() const { return node == cage; }

  /// What stands in the views as a surface: the cage, too, as long as it couldn't be refined.
  const std::shared_ptr<const PolyMesh>& shown() const {
    return (view == SmoothView::Cage || !mesh) && cage_mesh ? cage_mesh : mesh;
  }
};

/// The mesh of a source, or null.
std::shared_ptr<const PolyMesh> mesh_in(const Node& node);

/// The first mesh that an evaluation gives by the description of its operation, or null.
std::shared_ptr<const PolyMesh> mesh_of(const Evaluation& evaluation, const Operation& operation);

/// Every node of the document that gives a mesh and that no other node uses, in the document's order, without results.
std::vector<StudioObject> objects_of(const Document& document, const Registry& registry);

/// A name as people would write it: "Hex bolt" for "hex_bolt", the stem of a file. Others are as they are.
std::string readable_name(const std::string& name);

/// A name that no node has yet: the wanted one, or with a number behind.
std::string free_name(const Document& document, const std::string& wanted);

}  // namespace croquis::app
