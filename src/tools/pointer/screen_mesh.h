// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "croquis/geometry/mesh_topology.h"
#include "croquis/tools/pointer/pick_box.h"
#include "croquis/tools/pointer/view_frame.h"

namespace croquis {

/// Where a view shows an edge, or the part of it before the eye.
struct ScreenSegment {
  Projected a, b;
  double weight_a = 1, weight_b = 1;  ///< the clip coordinate w at both ends
  double from = 0, to = 1;            ///< the part of the edge

  /// What part of the edge a part 0..1 of the segment on the screen stands for.
  double on_edge(double on_screen) const;
  Projected at(double on_screen) const;
};

/// The edge from a place to another, cut at the near plane; nothing when all of it lies before that.
std::optional<ScreenSegment> project_segment(const ViewFrame& frame, const Vec3& a, const Vec3& b);

/// Whether some part of a segment lies in a box; the part if so.
std::optional<std::pair<double, double>> part_in_box(const Vec2& a, const Vec2& b, const PickBox& box);

/// All vertices of a mesh as a view shows them.
struct ScreenMesh {
  std::vector<Projected> vertices;  ///< #V
  std::vector<char> shown;          ///< #V, 0 before the near plane or behind the eye: then the place means nothing

  ScreenMesh(const PolyMesh& mesh, const ViewFrame& frame);

  /// Upright bounds of what is shown; nothing when nothing is.
  std::optional<PickBox> bounds() const;
};

/// A face as a view shows it, cut at the near plane: empty, or at least three corners.
void project_face(const PolyMesh& mesh, const ViewFrame& frame, const ScreenMesh& screen, Index face,
                  std::vector<Projected>& polygon);

}  // namespace croquis
