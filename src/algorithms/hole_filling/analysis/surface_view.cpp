// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/hole_filling/surface_view.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "algorithms/hole_filling/analysis/analysis_steps.h"
#include "algorithms/hole_filling/triangulation/cancel_check.h"
#include "croquis/base/error.h"
#include "croquis/base/progress.h"
#include "croquis/geometry/disjoint_sets.h"
#include "croquis/geometry/face_orientation.h"
#include "croquis/geometry/polygon_cut.h"

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

/// Of each part that edges of two triangles join, turns the minority of its triangles (of two halves the one
/// without the lowest triangle) and numbers the components. Fills component, component_count, one_sided_components and
/// the `turned` flags; rewrites triangles and opposite where triangles are turned. Linear.
/// @param nonmanifold_corners see EdgePairing: they join components but decide no orientation
void orient_and_number(SurfaceView& view, std::span<const std::array<Index, 2>> nonmanifold_corners,
                       Progress& progress) {
  CancelCheck cancel(progress);
  if (!number_agreeing_parts(view, cancel)) turn_minorities(view, cancel);
  join_across_nonmanifold(view, nonmanifold_corners);
}

/// A triangle below this share of the squared diagonal is noise of its own coordinates.
constexpr double least_area = 1e-14;

/// Longest edge over height: beyond it a normal in double precision has no digit left for single-precision input.
constexpr double greatest_aspect = 1e6;

/// Corners are counted with 32 bits, and two values are reserved.
constexpr std::size_t most_triangles = nonmanifold_edge / 3 - 1;

void require_fillable(const PolyMesh& mesh) {
  Findings findings = validate(mesh);
  std::erase_if(findings, [](const Finding& f) { return f.code != "E_INDEX" && f.code != "E_NOT_FINITE"; });
  if (mesh.face_count() == 0 && findings.empty())
    findings.push_back(make_error(Category::Malformed, "E_NO_FACES",
                                  "The mesh has no faces, so it has no holes to fill: give a mesh with faces."));
  if (!findings.empty()) throw Error(std::move(findings));
}

[[noreturn]] void throw_degenerate() {
  throw Error(make_error(Category::Malformed, "E_DEGENERATE",
                         "The mesh has no area: all its faces lie on points or lines; check the scale of its export."));
}

void add_triangles(const PolyMesh& mesh, SurfaceView& view, Index face) {
  const auto corners = mesh.face(face);
  visit_triangles(mesh.positions, corners, [&](const std::array<Index, 3>& cut) {
    std::array<Index, 3> t{};
    for (std::size_t i = 0; i < 3; ++i) t[i] = view.representative_of(corners[cut[i]]);
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) {
      ++view.dropped_triangles;
      return;
    }
    view.triangles.push_back(t);
    view.face.push_back(face);
  });
}

void triangulate_faces(const PolyMesh& mesh, SurfaceView& view, Progress& progress) {
  const std::size_t count = mesh.corners.size() - std::min(mesh.corners.size(), 2 * mesh.face_count());
  if (count > most_triangles)
    throw Error(make_error(Category::Limit, "E_LIMIT", "The mesh has more triangles than can be numbered: split it."));
  view.triangles.reserve(count);
  view.face.reserve(count);
  CancelCheck cancel(progress);
  for (Index face = 0; face < mesh.face_count(); ++face) {
    cancel.step();
    add_triangles(mesh, view, face);
  }
  view.flags.assign(view.triangles.size(), 0);
}

double diagonal_of(const PolyMesh& mesh, const SurfaceView& view) {
  if (view.triangles.empty()) return 0;
  Vec3 low = mesh.positions[view.triangles.front()[0]];
  Vec3 high = low;
  for (const auto& triangle : view.triangles) {
    for (const Index vertex : triangle) {
      low = low.cwiseMin(mesh.positions[vertex]);
      high = high.cwiseMax(mesh.positions[vertex]);
    }
  }
  return (high - low).norm();
}

/// Flags the triangles without a usable normal or shape. @return the area of all
double flag_unsound(const PolyMesh& mesh, SurfaceView& view, Progress& progress) {
  const double area_limit = least_area * view.diagonal * view.diagonal;
  double area = 0;
  CancelCheck cancel(progress);
  for (std::size_t t = 0; t < view.triangles.size(); ++t) {
    cancel.step();
    const Vec3& a = mesh.positions[view.triangles[t][0]];
    const Vec3 ab = mesh.positions[view.triangles[t][1]] - a;
    const Vec3 ac = mesh.positions[view.triangles[t][2]] - a;
    const double twice_area = ab.cross(ac).norm();
    const double longest = std::max({ab.squaredNorm(), ac.squaredNorm(), (ac - ab).squaredNorm()});
    area += twice_area / 2;
    if (twice_area < 2 * area_limit) view.flags[t] |= SurfaceView::NoArea;
    if (twice_area * greatest_aspect < longest) view.flags[t] |= SurfaceView::Sliver;
    if ((view.flags[t] & (SurfaceView::NoArea | SurfaceView::Sliver)) != 0) ++view.unsound_triangles;
  }
  return area;
}

void list_rim_corners(SurfaceView& view) {
  for (Index corner = 0; corner < view.opposite.size(); ++corner) {
    if (view.opposite[corner] == no_index) view.rim_corners.push_back(corner);
  }
}

void count_turned_faces(SurfaceView& view) {
  Index last = no_index;
  for (std::size_t t = 0; t < view.triangles.size(); ++t) {
    if ((view.flags[t] & SurfaceView::Turned) == 0 || view.face[t] == last) continue;
    last = view.face[t];
    ++view.turned_faces;
  }
}

/// The view in which vertices count as one as given.
SurfaceView join_faces(const PolyMesh& mesh, std::vector<Index> representative, Progress& progress) {
  SurfaceView view;
  view.representative = std::move(representative);
  triangulate_faces(mesh, view, progress);
  view.diagonal = diagonal_of(mesh, view);
  if (!(view.diagonal > 0)) throw_degenerate();
  if (!(flag_unsound(mesh, view, progress) > 0)) throw_degenerate();
  progress.report(0.3);
  {
    EdgePairing pairing = pair_edges(view.triangles, mesh.vertex_count(), progress);
    progress.report(0.7);
    view.opposite = std::move(pairing.opposite);
    view.nonmanifold_edges = pairing.nonmanifold_edges;
    orient_and_number(view, pairing.nonmanifold_corners, progress);
  }
  list_rim_corners(view);
  count_turned_faces(view);
  progress.report(1);
  return view;
}

}  // namespace

SurfaceView view_surface(const PolyMesh& mesh, Progress& progress, double weld_tolerance) {
  require_fillable(mesh);
  progress.report(0.1);
  Welding identical = weld_identical(mesh, progress);
  progress.report(0.2);
  Progress joining = progress.step("join faces", 0.6);
  SurfaceView view = join_faces(mesh, std::move(identical.representative), joining);
  Welding near = weld_rims(mesh, view, weld_tolerance * view.diagonal, progress);
  if (near.welded > 0) {
    Progress again = progress.step("join faces", 0.2);
    view = join_faces(mesh, std::move(near.representative), again);
  }
  view.welded_vertices = identical.welded;
  view.nearly_welded_vertices = near.welded;
  view.widest_weld = near.widest_gap;
  progress.report(1);
  return view;
}

JoinedMesh joined(const PolyMesh& mesh, const SurfaceView& view) {
  JoinedMesh result;
  result.mesh.positions = mesh.positions;
  std::vector<Index> corners;
  for (const Index face : view.face) {
    if (!result.face.empty() && result.face.back() == face) continue;  // another triangle of it
    corners.clear();
    for (const Index vertex : mesh.face(face)) {
      const Index known = view.representative_of(vertex);
      if (corners.empty() || corners.back() != known) corners.push_back(known);
    }
    if (corners.back() == corners.front()) corners.pop_back();
    result.mesh.add_face(corners);
    result.face.push_back(face);
  }
  return result;
}

std::size_t count_seam_edges(const PolyMesh& mesh, const SurfaceView& view) {
  if (view.representative.empty()) return 0;
  std::size_t seams = 0;
  const auto vertex = [&](Index corner) { return mesh_vertex(view, mesh, corner); };
  for (Index corner = 0; corner < view.opposite.size(); ++corner) {
    if (!view.has_opposite(corner) || view.opposite[corner] < corner) continue;
    const Index other = view.opposite[corner];
    // Two triangles that agree run their edge in opposite directions, others in the same one.
    const bool is_reversed = view.origin(corner) == view.target(other);
    const Index from = is_reversed ? SurfaceView::next(other) : other;
    const Index to = is_reversed ? other : SurfaceView::next(other);
    if (vertex(corner) != vertex(from) || vertex(SurfaceView::next(corner)) != vertex(to)) ++seams;
  }
  return seams;
}

Index mesh_vertex(const SurfaceView& view, const PolyMesh& mesh, Index corner) {
  const Index wanted = view.origin(corner);
  if (view.representative.empty()) return wanted;
  for (const Index vertex : mesh.face(view.face[corner / 3])) {
    if (view.representative[vertex] == wanted) return vertex;
  }
  return wanted;
}

}  // namespace croquis::hole_filling
