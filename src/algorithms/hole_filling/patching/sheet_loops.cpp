// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/patching/sheet_loops.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include <Eigen/Geometry>

#include "algorithms/hole_filling/analysis/analysis_steps.h"
#include "algorithms/hole_filling/patching/near_scene.h"
#include "algorithms/hole_filling/triangulation/triangulations.h"
#include "croquis/geometry/mesh_part.h"
#include "croquis/geometry/mesh_topology.h"
#include "croquis/implicit/point_tree.h"

namespace croquis::hole_filling {
namespace {

PolyMesh with_faces(const PolyMesh& mesh, const std::vector<bool>& stays) {
  std::vector<bool> is_used(mesh.vertex_count(), false);
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    if (!stays[f]) continue;
    for (const Index v : mesh.face(f)) is_used[v] = true;
  }
  return part_of(mesh, is_used, stays).mesh;
}

/// Takes triangles away from the border, round by round: those with two border edges, and all around vertices where
/// borders touch. A round looks only at what the one before has changed.
void peel(const PolyMesh& mesh, std::vector<bool>& stays) {
  const MeshTopology topology(mesh);
  // Whether what stays ends at the edge of a corner whose face stays.
  const auto is_border = [&](Index corner) {
    const Index across = topology.opposite(corner);
    return across == no_index || !stays[topology.face(across)];
  };
  std::vector<Index> faces(topology.face_count()), vertices(topology.vertex_count()), peeled;
  std::iota(faces.begin(), faces.end(), Index{0});
  std::iota(vertices.begin(), vertices.end(), Index{0});
  do {
    peeled.clear();
    for (const Index face : faces) {
      if (stays[face] && is_border(3 * face) + is_border(3 * face + 1) + is_border(3 * face + 2) > 1)
        peeled.push_back(face);
    }
    for (const Index vertex : vertices) {
      const auto stays_at = [&](Index corner) { return stays[topology.face(corner)]; };
      const auto corners = topology.vertex_corners(vertex);
      if (std::ranges::count_if(corners, [&](Index c) { return stays_at(c) && is_border(c); }) < 2) continue;
      for (const Index corner : corners) {
        if (stays_at(corner)) peeled.push_back(topology.face(corner));
      }
    }
    faces.clear();
    vertices.clear();
    for (const Index face : peeled) {
      stays[face] = false;
      for (Index corner = 3 * face; corner < 3 * face + 3; ++corner) {
        vertices.push_back(topology.vertex(corner));
        const Index across = topology.opposite(corner);
        if (across != no_index) faces.push_back(topology.face(across));
      }
    }
  } while (!peeled.empty());
}

constexpr double farthest_rim = 3;  // × cell, of a border vertex that votes

/// A closed border of a piece of surface.
struct BorderLoop {
  std::vector<Index> vertices;  ///< in the direction of the triangles, which lie on their left
  Index component = 0;          ///< of MeshTopology
  Index hole = no_index;        ///< that most of its vertices are nearest to, if any is near
};

/// The borders of a sheet; each of their vertices votes for the rim that is nearest to it, within reach.
std::vector<BorderLoop> borders_at_rims(const HoleSite& site, const PolyMesh& sheet, double reach) {
  implicit::Box box = implicit::bounds(sheet.positions);
  box.low -= Vec3::Constant(reach);
  box.high += Vec3::Constant(reach);
  std::vector<Vec3> places;
  std::vector<Index> holes;  // per place
  for (const Hole& hole : site.analysis->holes) {
    for (const Index v : hole.vertices) {
      if (!box.contains(site.mesh->positions[v])) continue;
      places.push_back(site.mesh->positions[v]);
      holes.push_back(hole.id);
    }
  }
  const implicit::PointTree tree(places);
  const MeshTopology topology(sheet);
  std::vector<BorderLoop> loops;
  for (std::size_t i = 0; i < topology.boundary_loops().size(); ++i) {
    const auto loop = topology.boundary_loops()[i];
    std::map<Index, std::size_t> votes;
    for (const Index v : loop) {
      const Index nearest = tree.nearest(sheet.positions[v]);
      const bool is_near = nearest != no_index && (places[nearest] - sheet.positions[v]).norm() <= reach;
      ++votes[is_near ? holes[nearest] : no_index];
    }
    const Index hole = std::ranges::max_element(votes, {}, [](const auto& vote) { return vote.second; })->first;
    const Index corner = topology.vertex_corners(loop.front()).front();
    loops.push_back({{loop.begin(), loop.end()}, topology.component(topology.face(corner)), hole});
  }
  return loops;
}

/// One of the pieces of a sheet, without unused vertices; the order of vertices and faces stays.
PolyMesh component_of(const PolyMesh& sheet, Index component) {
  const MeshTopology topology(sheet);
  std::vector<bool> stays(sheet.face_count());
  for (Index f = 0; f < sheet.face_count(); ++f) stays[f] = topology.component(f) == component;
  return with_faces(sheet, stays);
}

/// The longest border for which something holds, the first of equals; null without any.
template <typename Holds>
const BorderLoop* longest_where(const std::vector<BorderLoop>& loops, const Holds& holds) {
  const BorderLoop* longest = nullptr;
  for (const BorderLoop& loop : loops) {
    if (holds(loop.hole) && (longest == nullptr || loop.vertices.size() > longest->vertices.size())) longest = &loop;
  }
  return longest;
}

/// Closes a hole of the sheet itself.
bool close(const std::vector<Index>& loop, PolyMesh& sheet, Progress& progress) {
  RimPolygon polygon;
  const std::vector<Index> order(loop.rbegin(), loop.rend());
  for (const Index v : order) polygon.points.push_back(sheet.positions[v]);
  polygon.loop_ends = {static_cast<Index>(order.size())};
  const auto found = triangulate_rim(polygon, progress);
  if (!found) return false;
  for (const auto& [a, b, c] : found->triangles) sheet.add_triangle(order[a], order[b], order[c]);
  return true;
}

constexpr double most_turned_over = 0.1;  // of the strip's area
constexpr double longest_ways = 2;        // from one side to the other, × the shortest there are

/// Both sides as the rims of a patch: the right one the other way round.
RimPolygon as_rims(const ZipSides& sides) {
  RimPolygon rims;
  rims.points = sides.left;
  rims.points.insert(rims.points.end(), sides.right.rbegin(), sides.right.rend());
  rims.loop_ends = {static_cast<Index>(sides.left.size()), static_cast<Index>(rims.points.size())};
  return rims;
}

/// Whether edges lead elsewhere than to what is near on the other side.
bool is_twisted(const ZipSides& sides, const Triangles& strip) {
  const auto first_right = static_cast<Index>(sides.left.size());
  std::vector<Vec3> places = sides.left;
  places.insert(places.end(), sides.right.begin(), sides.right.end());
  std::vector<double> way(places.size(), std::numeric_limits<double>::infinity());
  for (const Triangle& t : strip) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Index a = t[i], b = t[(i + 1) % 3];
      if ((a < first_right) == (b < first_right)) continue;
      const double length = (places[a] - places[b]).norm();
      way[a] = std::min(way[a], length);
      way[b] = std::min(way[b], length);
    }
  }
  const implicit::PointTree left(sides.left), right(sides.right);
  double taken = 0, shortest = 0;
  for (Index v = 0; v < places.size(); ++v) {
    const Vec3& other = v < first_right ? sides.right[right.nearest(places[v])] : sides.left[left.nearest(places[v])];
    taken += way[v];
    shortest += (other - places[v]).norm();
  }
  return !(taken <= longest_ways * shortest);
}

bool turns_over(const ZipSides& sides, const Triangles& strip) {
  const auto first_right = static_cast<Index>(sides.left.size());
  const auto place = [&](Index v) { return v < first_right ? sides.left[v] : sides.right[v - first_right]; };
  const auto normal = [&](Index v) {
    return v < first_right ? sides.left_normals[v] : sides.right_normals[v - first_right];
  };
  double area = 0, turned_over = 0;
  for (const auto& [a, b, c] : strip) {
    const Vec3 twice_area = (place(b) - place(a)).cross(place(c) - place(a));
    area += twice_area.norm();
    if (twice_area.dot(normal(a) + normal(b) + normal(c)) < 0) turned_over += twice_area.norm();
  }
  return turned_over > most_turned_over * area;
}

constexpr double covering_reach = 2;  // × cell
constexpr double uncovered_beyond =
    0.45;                          // × cell: a strip of good triangles fits between the rim and what is uncovered
constexpr double opposite = -0.5;  // cosine between the two skins of a wall

std::vector<Index> triangles_in(const HoleSite& site, const implicit::Box& box) {
  const SurfaceView& view = site.analysis->view;
  std::vector<Index> near = triangles_near(site, {box.low, box.high});
  std::erase_if(near, [&](Index t) { return (view.flags[t] & (SurfaceView::NoArea | SurfaceView::Sliver)) != 0; });
  return near;
}

std::array<Vec3, 3> corners_of(const HoleSite& site, Index triangle) {
  const auto& [a, b, c] = site.analysis->view.triangles[triangle];
  return {site.mesh->positions[a], site.mesh->positions[b], site.mesh->positions[c]};
}

/// The direction, unit, in which a triangle goes on across its edge.
Vec3 across_edge(const std::array<Vec3, 3>& t, std::size_t edge) {
  const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
  return (t[(edge + 1) % 3] - t[edge]).cross(normal).normalized();
}

}  // namespace

PolyMesh open_sheet(const PolyMesh& triangles, std::span<const std::uint8_t> left_out) {
  std::vector<bool> stays(triangles.face_count());
  for (std::size_t f = 0; f < stays.size(); ++f)
    stays[f] = std::ranges::none_of(triangles.face(f), [&](Index v) { return left_out[v] != 0; });
  peel(triangles, stays);
  return with_faces(triangles, stays);
}

/// Of the sheet's pieces the one with the longest border at one of the site's rims.
std::optional<MatchedSheet> match_loops(const HoleSite& site, PolyMesh sheet, double cell, Progress& progress) {
  if (sheet.face_count() == 0) return std::nullopt;
  const auto is_own = [&](Index hole) { return std::ranges::binary_search(site.holes, hole); };
  const std::vector<BorderLoop> all = borders_at_rims(site, sheet, farthest_rim * cell);
  const BorderLoop* const best = longest_where(all, is_own);
  if (best == nullptr) return std::nullopt;
  MatchedSheet matched;
  matched.sheet = component_of(sheet, best->component);
  const std::vector<BorderLoop> loops = borders_at_rims(site, matched.sheet, farthest_rim * cell);
  for (const BorderLoop& loop : loops) {
    if (loop.hole != no_index && !is_own(loop.hole)) matched.arrives_at.push_back(loop.hole);
  }
  std::ranges::sort(matched.arrives_at);
  matched.arrives_at.erase(std::unique(matched.arrives_at.begin(), matched.arrives_at.end()), matched.arrives_at.end());
  if (!matched.arrives_at.empty()) return matched;
  std::vector<Index> order = site.holes;  // as the site's polygon has them
  std::ranges::stable_sort(order, std::greater(), [&](Index hole) { return site.analysis->holes[hole].diameter; });
  std::set<const BorderLoop*> taken;
  for (const Index id : order) {
    const BorderLoop* const loop = longest_where(loops, [&](Index hole) { return hole == id; });
    if (loop == nullptr) return std::nullopt;
    matched.loops.push_back(loop->vertices);
    taken.insert(loop);
  }
  for (const BorderLoop& loop : loops) {
    if (!taken.contains(&loop) && !close(loop.vertices, matched.sheet, progress)) return std::nullopt;
  }
  return matched;
}

std::optional<Triangles> zip(const ZipSides& sides, Progress& progress) {
  const RimPolygon rims = as_rims(sides);
  auto strip = band_triangulation(rims, BandCost::Length, progress);
  if (!strip) return std::nullopt;
  const auto first_right = static_cast<Index>(sides.left.size());
  const auto last = static_cast<Index>(rims.points.size() - 1);
  for (Triangle& t : *strip) {
    for (Index& v : t) v = v < first_right ? v : first_right + (last - v);
  }
  if (is_twisted(sides, *strip) || turns_over(sides, *strip)) return std::nullopt;
  return strip;
}

Covering::Covering(const HoleSite& site, const implicit::Box& box, const Progress& progress)
    : site_(site), triangles_(triangles_in(site, box)) {
  std::vector<std::array<Vec3, 3>> corners;
  corners.reserve(triangles_.size());
  for (const Index t : triangles_) {
    corners.push_back(corners_of(site, t));
    normals_.push_back(triangle_normal(site, t).normalized());
  }
  tree_.emplace(std::move(corners), progress);
  const SurfaceView& view = site.analysis->view;
  for (const Index corner : view.rim_corners) {
    const Vec3 direction = across_edge(corners_of(site, corner / 3), corner % 3);
    for (const Index end : {view.origin(corner), view.target(corner)})
      at_rim_.try_emplace(end, Vec3::Zero()).first->second += direction;
  }
}

/// The direction in which the surface goes on from a foot on a rim, or zero where there is surface on all sides.
Vec3 Covering::onwards(const TriangleFoot& foot) const {
  const SurfaceView& view = site_.analysis->view;
  const Index first_corner = 3 * triangles_[foot.triangle];
  if (foot.edge >= 0) {
    const bool is_rim = view.opposite[first_corner + static_cast<Index>(foot.edge)] == no_index;
    if (!is_rim) return Vec3::Zero();
    return across_edge(corners_of(site_, triangles_[foot.triangle]), static_cast<std::size_t>(foot.edge));
  }
  if (foot.corner < 0) return Vec3::Zero();
  const Index vertex = view.origin(first_corner + static_cast<Index>(foot.corner));
  const auto found = at_rim_.find(vertex);
  return found == at_rim_.end() ? Vec3(Vec3::Zero()) : found->second.normalized();
}

void Covering::mark(const implicit::Field& field, double cell, std::span<const Vec3> places,
                    std::span<std::uint8_t> covered) const {
  std::vector<std::size_t> near;  // most places have nothing nearby, and need no gradient
  std::vector<Vec3> near_places;
  for (std::size_t i = 0; i < places.size(); ++i) {
    covered[i] = 0;
    if (tree_->nearest(places[i], covering_reach * cell).triangle == no_index) continue;
    near.push_back(i);
    near_places.push_back(places[i]);
  }
  std::vector<double> values(near.size());
  std::vector<Vec3> gradients(near.size());
  field(near_places, values, gradients);
  const double least_agreement = std::cos(greatest_group_angle);
  for (std::size_t k = 0; k < near.size(); ++k) {
    const Vec3 normal = gradients[k].normalized();
    const TriangleFoot foot = tree_->nearest(near_places[k], covering_reach * cell,
                                             [&](Index t) { return normals_[t].dot(normal) >= least_agreement; });
    if (foot.triangle == no_index) continue;
    const Vec3 direction = onwards(foot);
    const bool is_under = direction.isZero() || (near_places[k] - foot.point).dot(direction) < uncovered_beyond * cell;
    covered[near[k]] = is_under ? 1 : 0;
  }
}

double Covering::wall(double farthest) const {
  const SurfaceView& view = site_.analysis->view;
  for (const Index id : site_.holes) {
    for (const Index corner : site_.analysis->holes[id].corners) {
      const Vec3 normal = triangle_normal(site_, corner / 3).normalized();
      const TriangleFoot foot = tree_->nearest(site_.mesh->positions[view.origin(corner)], farthest,
                                               [&](Index t) { return normals_[t].dot(normal) < opposite; });
      if (foot.triangle != no_index) farthest = foot.distance;
    }
  }
  return farthest;
}

}  // namespace croquis::hole_filling
