// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/perspective/normal_jump.h"

#include <algorithm>
#include <utility>

namespace croquis {
namespace {

constexpr int places_per_edge = 32;  ///< spans; one place more

/// The place of a patch's side where a part t of the way from corner i to corner i+1 is done.
Vec3 normal_on_side(const GregoryPatch& patch, int side, double t) {
  switch (side) {
    case 0: return patch.at(t, 0).normal();
    case 1: return patch.at(1, t).normal();
    case 2: return patch.at(1 - t, 1).normal();
    default: return patch.at(0, 1 - t).normal();
  }
}

/// The outward normal of a face along one of its half-edges. @param t 0..1 on the half-edge's own way
Vec3 normal_along(const Brep& brep, Index half_edge, double t) {
  const BrepFace& face = brep.faces[brep.face_of(half_edge)];
  if (face.planar) return face.normal;
  const std::vector<Index> around = brep.around(face.loops.front());
  const auto i = static_cast<std::size_t>(std::ranges::find(around, half_edge) - around.begin());
  if (face.patches.size() == 1) return normal_on_side(face.patches.front(), static_cast<int>(i), t);
  if (t <= 0.5) return normal_on_side(face.patches[i], 0, 2 * t);
  return normal_on_side(face.patches[(i + 1) % around.size()], 3, 2 * t - 1);
}

double jump_across(const Brep& brep, const BrepEdge& edge) {
  double greatest = 0;
  for (int k = 0; k <= places_per_edge; ++k) {
    const double t = static_cast<double>(k) / places_per_edge;
    const Vec3 one = normal_along(brep, edge.half_edges[0], t), other = normal_along(brep, edge.half_edges[1], 1 - t);
    greatest = std::max(greatest, angle_between(one, other));
  }
  return greatest;
}

/// Patch i meets patch i+1 in the line from the middle of half-edge i to the middle of the face.
double jump_inside(const BrepFace& face) {
  double greatest = 0;
  for (std::size_t i = 0; face.patches.size() > 1 && i < face.patches.size(); ++i) {
    const GregoryPatch &patch = face.patches[i], &next = face.patches[(i + 1) % face.patches.size()];
    for (int k = 0; k <= places_per_edge; ++k) {
      const double t = static_cast<double>(k) / places_per_edge;
      greatest = std::max(greatest, angle_between(normal_on_side(patch, 1, t), normal_on_side(next, 2, 1 - t)));
    }
  }
  return greatest;
}

}  // namespace

double greatest_normal_jump(const Brep& brep) {
  double greatest = 0;
  for (const BrepEdge& edge : brep.edges) {
    const bool has_both = edge.half_edges[0] != no_index && edge.half_edges[1] != no_index;
    if (edge.smooth && has_both) greatest = std::max(greatest, jump_across(brep, edge));
  }
  for (const BrepFace& face : brep.faces) greatest = std::max(greatest, jump_inside(face));
  return greatest;
}

}  // namespace croquis
