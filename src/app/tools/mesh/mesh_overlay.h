// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/studio/studio.h"
#include "app/tools/scene_parts.h"
#include "croquis/render/edge_item.h"
#include "croquis/render/scene.h"
#include "croquis/tools/mesh/mesh_tool.h"

namespace croquis::app {

/// What lies over the mesh that is worked on: its tags by sharpness, its chains' limit curves, what is selected and
/// under the pointer. Kept until what it shows changes.
class MeshOverlay {
 public:
  /// @param object the one worked on; null shows nothing. @param cage made ready, or null
  /// @param shows_cage its tags are shown while its elements are picked
  void follow(MeshTool& tool, const ComponentSelection& selection, const WorkObject* object,
              const render::MeshItemPtr& cage, bool shows_cage);

  /// What is under the pointer; cheap enough for every event.
  void follow_hover(MeshTool& tool, const render::MeshItemPtr& cage);

  /// Adds to a view's scene. @param with_chains also the limit curves, which are one scheme's
  void add_to(render::Scene& scene, bool with_chains) const;

  /// Tags are shown: the legend belongs beside them.
  bool shows_tags() const { return tags_.clear != nullptr; }

  /// Of the selected elements; of everything when none are.
  render::Bounds selection_bounds() const { return selection_bounds_; }

 private:
  void show_tags(MeshTool& tool, const WorkObject& object);
  void show_chains(const WorkObject& object);
  void show_selection(MeshTool& tool, const ComponentSelection& selection, const render::MeshItemPtr& cage);

  void show_selected_edges(const MeshTool& tool, const MeshTopology& topology, const Elements& chosen, float width);
  static SeenThrough edges(const MeshTool& tool, std::vector<render::StyledEdge> styled);

  SeenThrough tags_;
  render::LineItemPtr chains_;
  render::MarkItemPtr dots_;  ///< pins, corners and ends of chains
  render::PointItemPtr vertices_;
  render::PointItemPtr selected_vertices_;
  SeenThrough selected_edges_;
  render::LineItemPtr selected_casing_;  ///< a dark border, so that they differ from any surface
  std::vector<render::FaceHighlightPtr> faces_;
  SeenThrough hovered_edge_;
  render::PointItemPtr hovered_vertex_;
  render::FaceHighlightPtr hovered_face_;
  render::LineItemPtr cut_;
  render::Bounds selection_bounds_;
};

/// A manipulator's lines and handles, as it is shown in one view.
void add_handles(const ManipulatorPicture& picture, render::Scene& scene);

}  // namespace croquis::app
