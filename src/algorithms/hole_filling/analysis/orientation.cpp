// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/analysis/orientation.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "algorithms/hole_filling/triangulation/cancel_check.h"
#include "croquis/geometry/disjoint_sets.h"
#include "croquis/geometry/face_orientation.h"

namespace croquis::hole_filling {
namespace {

/// Both corners start at one end: their triangles run the common edge the same way.
bool run_alike(const SurfaceView& view, Index corner, Index other) { return view.origin(corner) == view.origin(other); }

/// Where a corner's edge is once the last two corners of turned triangles have changed places.
Index corner_after_turning(const SurfaceView& view, Index corner) {
  if (corner >= nonmanifold_edge || (view.flags[corner / 3] & SurfaceView::Turned) == 0) return corner;
  constexpr std::array<Index, 3> place = {2, 1, 0};
  return corner - corner % 3 + place[corner % 3];
}

void apply_turns(SurfaceView& view) {
  for (Index& other : view.opposite) other = corner_after_turning(view, other);
  for (Index t = 0; t < view.triangles.size(); ++t) {
    if ((view.flags[t] & SurfaceView::Turned) == 0) continue;
    std::swap(view.triangles[t][1], view.triangles[t][2]);
    std::swap(view.opposite[3 * t], view.opposite[3 * t + 2]);
  }
}

/// Joins the triangles on both sides of each edge, in the order of memory: nearly all meshes agree already, and a flood
/// would jump about in the larger ones. Numbers the parts by their lowest triangles.
/// @return whether all triangles agree; if not, nothing is changed
bool number_agreeing_parts(SurfaceView& view, CancelCheck& cancel) {
  DisjointSets parts(view.triangles.size());
  for (Index corner = 0; corner < view.opposite.size(); ++corner) {
    cancel.step();
    const Index other = view.opposite[corner];
    if (other > corner) continue;  // there is none, or the pair is met there
    if (run_alike(view, corner, other)) return false;
    parts.unite(corner / 3, other / 3);
  }
  view.component_count = parts.number(view.component);
  return true;
}

/// Turns minorities. Numbers the parts as number_agreeing_parts does.
void turn_minorities(SurfaceView& view, CancelCheck& cancel) {
  FaceOrientation found = orient_faces(view.triangles.size(), [&](Index triangle, auto&& visit) {
    cancel.step();
    for (Index corner = 3 * triangle; corner < 3 * triangle + 3; ++corner) {
      if (!view.has_opposite(corner)) continue;
      const Index other = view.opposite[corner];
      visit(corner, other / 3, run_alike(view, corner, other));
    }
  });
  bool any_turned = false;
  for (Index triangle = 0; triangle < view.triangles.size(); ++triangle) {
    // No orientation of a one-sided part is better than the one given.
    if (found.turned[triangle] == 0 || found.conflict[found.part[triangle]] != no_index) continue;
    view.flags[triangle] |= SurfaceView::Turned;
    any_turned = true;
  }
  if (any_turned) apply_turns(view);
  view.one_sided_components =
      found.conflict.size() - static_cast<std::size_t>(std::ranges::count(found.conflict, no_index));
  view.component_count = static_cast<Index>(found.conflict.size());
  view.component = std::move(found.part);
}

/// Joins parts across non-manifold edges; numbers stay those of the lowest triangles.
void join_across_nonmanifold(SurfaceView& view, std::span<const std::array<Index, 2>> nonmanifold_corners) {
  if (nonmanifold_corners.empty()) return;
  DisjointSets sets(view.component_count);
  for (const auto& [a, b] : nonmanifold_corners) sets.unite(view.component[a / 3], view.component[b / 3]);
  std::vector<Index> number;
  view.component_count = sets.number(number);
  for (Index& component : view.component) component = number[component];
}

}  // namespace

void orient_and_number(SurfaceView& view, std::span<const std::array<Index, 2>> nonmanifold_corners,
                       Progress& progress) {
  CancelCheck cancel(progress);
  if (!number_agreeing_parts(view, cancel)) turn_minorities(view, cancel);
  join_across_nonmanifold(view, nonmanifold_corners);
}

}  // namespace croquis::hole_filling
