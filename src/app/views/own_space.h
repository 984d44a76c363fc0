// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "croquis/geometry/placement.h"
#include "croquis/render/scene.h"
#include "croquis/tools/mesh/mesh_pick.h"
#include "croquis/tools/pointer/view_frame.h"

namespace croquis::app {

// Objects are placed in the model; tools that work inside one see its own space, in which its meshes lie.

glm::dmat4 matrix_of(const Affine3& map);

/// A view as it is seen from a space that the map takes to the model's.
ViewFrame seen_from(const ViewFrame& frame, const Affine3& to_model);

/// Places all that is added to a scene while it lives.
class PlacedPart {
 public:
  PlacedPart(render::Scene& scene, const Affine3& to_model);
  ~PlacedPart();
  PlacedPart(const PlacedPart&) = delete;
  PlacedPart& operator=(const PlacedPart&) = delete;

 private:
  render::Scene& scene_;
  glm::dmat4 placement_;
  std::array<std::size_t, 4> before_;  ///< meshes, lines, marks, points
};

/// The box being spanned. @param box pixels of the view
void add_box(const PickBox& box, const ViewFrame& frame, render::Scene& scene);

}  // namespace croquis::app
