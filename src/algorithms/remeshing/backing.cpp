// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/remeshing/backing.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <numeric>

#include "algorithms/remeshing/improvement.h"
#include "algorithms/remeshing/surface_parts.h"
#include "croquis/base/parallel.h"
#include "croquis/geometry/disjoint_sets.h"
#include "croquis/geometry/polygon_area.h"
#include "croquis/geometry/single_precision.h"
#include "croquis/geometry/triangle_tree.h"

namespace croquis::remeshing {
namespace {

using namespace hole_filling;

constexpr double reach_of_hole = 0.75;        // × diameter
constexpr std::size_t most_rim_points = 256;  // of a hole: others between them are almost as near
constexpr double view_gap = 3;                // × edge: views may be that far apart
constexpr double rim_within = 2;              // × far: the border of what is far lies beside a rim
constexpr double brought_within = 0.9;        // × what is near: rounding and smoothing may move it again

/// Weights of the point of a triangle nearest to p (Ericson 2005, section 5.1.5: by the regions of its corners and
/// edges).
std::array<double, 3> nearest_in_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap), d3 = ab.dot(bp), d4 = ac.dot(bp), d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
  if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
  if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
  const double va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return {1 - d1 / (d1 - d3), d1 / (d1 - d3), 0};
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return {1 - d2 / (d2 - d6), 0, d2 / (d2 - d6)};
  const double along = d4 - d3, back = d5 - d6;
  if (va <= 0 && along >= 0 && back >= 0) return {0, back / (along + back), along / (along + back)};
  const double sum = va + vb + vc;
  return sum > 0 ? std::array{va / sum, vb / sum, vc / sum} : std::array{1.0, 0.0, 0.0};
}

/// A tree of those triangles that may be as near to some of the places as this.
TriangleTree tree_near_to(const PolyMesh& mesh, const SurfaceView& view, std::span<const Index> numbers,
                          const std::vector<Vec3>& places, double far, const Progress& progress) {
  const implicit::PointTree tree(places);
  std::vector<std::array<Vec3, 3>> triangles;
  for (const Index t : numbers) {
    const std::array<Vec3, 3> corners = places_of(mesh.positions, view.triangles[t]);
    implicit::Box box = implicit::bounds(corners);
    box.low.array() -= far;
    box.high.array() += far;
    if (tree.holds_more_than(0, box)) triangles.push_back(corners);
  }
  return TriangleTree(std::move(triangles), progress);
}

std::vector<Vec3> places_at_seams(const PolyMesh& mesh, const RemeshPiece& piece, const RemeshPieces& pieces) {
  std::vector<Vec3> places;
  pieces.for_each_rim(piece, [&](Index, const RimPlace& rim) {
    if (rim.rule == RimRule::Seam) places.push_back(mesh.positions[rim.vertex]);
  });
  return places;
}

/// Marks of vertices while their distances are looked at.
enum Mark : std::uint8_t {
  Near,
  Far,      ///< far from the mesh, and closes no hole
  InHole,   ///< far from the mesh, in the reach of a hole
  Doubtful  ///< not near to the triangles at the nearest point
};

/// The border of a part that is far from the mesh: vertices by the zone whose rim they lie along.
struct FarPart {
  std::map<Index, std::size_t> along;
  std::size_t elsewhere = 0;

  bool is_backed() const {
    std::size_t count = 0;
    for (const auto& [zone, vertices] : along) count += vertices;
    return count > 0 && count >= elsewhere;
  }
};

/// Of what lies far from the mesh in the reach of holes the parts that hang together, and their borders.
/// @param part_of is given, per vertex, the lowest of its part
std::map<Index, FarPart> parts_in_holes(const PolyMesh& surface, const HoleReach& holes,
                                        const std::vector<std::uint8_t>& marks, double far,
                                        std::vector<Index>& part_of) {
  const auto is_in_hole = [&](Index v) { return marks[v] == InHole; };
  DisjointSets sets(surface.vertex_count());
  std::vector<std::uint8_t> is_border(surface.vertex_count(), 0);
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    const auto face = surface.face(f);
    const auto first = std::ranges::find_if(face, is_in_hole);
    if (first == face.end()) continue;
    const bool is_inside = std::ranges::all_of(face, is_in_hole);
    for (const Index v : face) {
      if (is_in_hole(v)) sets.unite(*first, v);
      if (!is_inside) is_border[v] = is_in_hole(v) ? 1 : 0;
    }
  }
  part_of = sets.take_roots();
  std::map<Index, FarPart> parts;
  for (Index v = 0; v < is_border.size(); ++v) {
    if (is_border[v] == 0) continue;
    FarPart& part = parts[part_of[v]];
    const Index zone = holes.zone_along(surface.positions[v], rim_within * far);
    ++(zone == no_index ? part.elsewhere : part.along[zone]);
  }
  return parts;
}

/// What lies far from the mesh in the reach of holes closes one of them, or is far for good.
void judge_holes(const PolyMesh& surface, const HoleReach& holes, double far, std::vector<std::uint8_t>& marks) {
  std::vector<Index> part_of;
  std::map<Index, FarPart> parts = parts_in_holes(surface, holes, marks, far, part_of);
  for (Index v = 0; v < part_of.size(); ++v) {
    if (marks[v] != InHole) continue;
    const FarPart& part = parts[part_of[v]];
    const auto holds = [&](const auto& zone) { return holes.contains(surface.positions[v], zone.first); };
    marks[v] = part.is_backed() && std::ranges::any_of(part.along, holds) ? Near : Far;
  }
}

}  // namespace

NearestScan::NearestScan(const PolyMesh& mesh, const SurfaceView& view, const TriangleFans& fans,
                         const RemeshPiece& piece, const RemeshPoints& points, int threads)
    : mesh_(mesh),
      view_(view),
      fans_(fans),
      piece_(piece),
      points_(points),
      tree_(points.positions, threads),
      threads_(threads) {}

NearestScanPlace NearestScan::nearest(const Vec3& place) const {
  NearestScanPlace found;
  found.point = tree_.nearest(place);
  found.distance = (place - points_.positions[found.point]).norm();
  const auto look_at = [&](Index triangle) {
    const auto& [a, b, c] = view_.triangles[triangle];
    const Vec3 &pa = mesh_.positions[a], &pb = mesh_.positions[b], &pc = mesh_.positions[c];
    const auto weights = nearest_in_triangle(place, pa, pb, pc);
    const double distance = (place - (weights[0] * pa + weights[1] * pb + weights[2] * pc)).norm();
    if (found.triangle != no_index && distance >= found.distance) return;
    found.triangle = triangle;
    found.weights = weights;
    found.distance = distance;
  };
  if (found.point >= piece_.vertices.size()) {
    look_at(points_.triangles[found.point - piece_.vertices.size()]);
  } else {
    for (const Index corner : fans_.at(piece_.vertices[found.point])) look_at(corner / 3);
  }
  return found;
}

HoleReach::HoleReach(const PolyMesh& mesh, const HoleAnalysis& analysis, const RemeshPiece& piece,
                     const RemeshPieces& pieces, std::span<const HoleRequest> requests, double edge,
                     std::span<const Index> open)
    : seam_places_(places_at_seams(mesh, piece, pieces)), seams_(seam_places_), seam_reach_(view_gap * edge) {
  std::vector<std::vector<Index>> groups = piece.groups;
  for (const Index cap : piece.caps) groups.push_back({cap});
  for (const std::vector<Index>& group : groups)
    if (std::ranges::find_first_of(group, open) == group.end())
      zones_.push_back(zone_of(mesh, analysis.holes, group, requests));
  std::ranges::stable_sort(zones_, std::greater(), &Zone::reach);
}

HoleReach::Zone HoleReach::zone_of(const PolyMesh& mesh, const std::vector<Hole>& holes,
                                   const std::vector<Index>& group, std::span<const HoleRequest> requests) {
  Zone zone;
  double diameter = 0;
  for (const Index id : group) {
    const Hole& hole = holes[id];
    const std::size_t stride = hole.vertices.size() / most_rim_points + 1;
    for (std::size_t i = 0; i < hole.vertices.size(); i += stride)
      zone.points.push_back(mesh.positions[hole.vertices[i]]);
    diameter = std::max(diameter, hole.diameter);
    zone.spacing = std::max(zone.spacing,
                            static_cast<double>(stride) * hole.perimeter / static_cast<double>(hole.vertices.size()));
  }
  zone.on_rim = zone.points.size();
  for (const HoleRequest& request : requests)
    if (std::ranges::find_first_of(request.holes, group) != request.holes.end())
      zone.points.insert(zone.points.end(), request.through.begin(), request.through.end());
  for (const Vec3& point : zone.points) zone.box.extend(point);
  zone.reach = reach_of_hole * diameter;
  zone.box = {zone.box.min() - Vec3::Constant(zone.reach), zone.box.max() + Vec3::Constant(zone.reach)};
  return zone;
}

bool HoleReach::contains(const Vec3& place) const {
  if (!seam_places_.empty() && (place - seam_places_[seams_.nearest(place)]).norm() <= seam_reach_) return true;
  for (Index zone = 0; zone < zones_.size(); ++zone)
    if (contains(place, zone)) return true;
  return false;
}

bool HoleReach::contains(const Vec3& place, Index number) const {
  const Zone& zone = zones_[number];
  return zone.box.contains(place) && std::ranges::any_of(zone.points, [&](const Vec3& point) {
           return (place - point).squaredNorm() <= zone.reach * zone.reach;
         });
}

Index HoleReach::zone_along(const Vec3& place, double distance) const {
  Index nearest = no_index;
  double least = std::numeric_limits<double>::infinity();
  for (Index i = 0; i < zones_.size(); ++i) {
    const Zone& zone = zones_[i];
    const double most = std::min(distance + zone.spacing, least);
    if (zone.box.squaredExteriorDistance(place) > most * most) continue;
    for (const Vec3& point : std::span(zone.points).first(zone.on_rim)) {
      const double away = (place - point).norm();
      if (away > distance + zone.spacing || away >= least) continue;
      least = away;
      nearest = i;
    }
  }
  return nearest;
}

UnbackedVertices find_unbacked(const PolyMesh& surface, const NearestScan& given, const HoleReach& holes, double near,
                               double far, Progress progress) {
  UnbackedVertices found;
  found.is_far.assign(surface.vertex_count(), Near);
  const auto mark = [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      const Vec3& place = surface.positions[v];
      const double most = given.nearest(place).distance;
      if (most <= near) continue;
      const bool is_in_hole = holes.contains(place);
      if (!is_in_hole || most > far) found.is_far[v] = is_in_hole ? InHole : Doubtful;
    }
  };
  for_each_part(surface.vertex_count(), vertices_per_part, given.threads(), progress, mark);
  std::vector<Index> doubtful;
  std::vector<Vec3> places;
  for (Index v = 0; v < surface.vertex_count(); ++v) {
    if (found.is_far[v] != Doubtful) continue;
    doubtful.push_back(v);
    places.push_back(surface.positions[v]);
  }
  const TriangleTree tree = tree_near_to(given.mesh(), given.view(), given.piece().triangles, places, far, progress);
  std::vector<TriangleFoot> feet(places.size());
  for_each_part(feet.size(), vertices_per_part, given.threads(), progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) feet[i] = tree.nearest(places[i], far);
  });
  for (std::size_t i = 0; i < feet.size(); ++i) {
    const bool is_far = feet[i].triangle == no_index;
    found.is_far[doubtful[i]] = is_far ? Far : Near;
    if (!is_far && feet[i].distance > near) found.loose.push_back({doubtful[i], feet[i].point, feet[i].distance});
  }
  judge_holes(surface, holes, far, found.is_far);
  found.far_count = static_cast<std::size_t>(std::ranges::count(found.is_far, std::uint8_t{Far}));
  return found;
}

bool trim_loose(PolyMesh& surface, std::span<const LooseVertex> loose, int threads, Progress& progress) {
  std::vector<std::uint8_t> is_loose(surface.vertex_count(), 0), hangs(surface.vertex_count(), 0);
  for (const LooseVertex& vertex : loose) is_loose[vertex.vertex] = 1;
  const TriangleFans fans(surface.vertex_count(), surface.corners);
  const std::vector<TriangleFans::Link> links = fans.links(threads, progress);
  std::vector<Index> pending;
  const auto reach = [&](Index v) {
    if (is_loose[v] == 0 || hangs[v] != 0) return;
    hangs[v] = 1;
    pending.push_back(v);
  };
  for (const LooseVertex& vertex : loose)
    if (links[vertex.vertex] == TriangleFans::Link::Path) reach(vertex.vertex);
  while (!pending.empty()) {
    const Index v = pending.back();
    pending.pop_back();
    for (const Index corner : fans.at(v)) {
      reach(fans.next(corner));
      reach(fans.previous(corner));
    }
  }
  std::vector<std::uint8_t> removed(surface.face_count(), 0);
  for (std::size_t f = 0; f < removed.size(); ++f)
    removed[f] = std::ranges::all_of(surface.face(f), [&](Index v) { return hangs[v] != 0; }) ? 1 : 0;
  if (std::ranges::find(removed, 1) == removed.end()) return false;
  surface = sound_without(surface, std::move(removed));
  return true;
}

void bring_near(PolyMesh& surface, std::vector<LooseVertex>& loose, double near, Precision precision,
                Progress& progress) {
  const std::vector<Vec3> before = surface.positions;
  std::vector<Vec3> moved;
  std::vector<Index> vertices;
  for (const LooseVertex& vertex : loose) {
    const Vec3 away = before[vertex.vertex] - vertex.foot;
    moved.push_back(vertex.foot + brought_within * near / vertex.distance * away);
    vertices.push_back(vertex.vertex);
  }
  if (precision == Precision::Single) round_to_single(moved);
  for (std::size_t i = 0; i < moved.size(); ++i) surface.positions[vertices[i]] = moved[i];
  undo_where_cut(surface, before, vertices, progress.step("look for cuts", 1));
  std::vector<LooseVertex> left;
  for (std::size_t i = 0; i < loose.size(); ++i)
    if (surface.positions[vertices[i]] != moved[i]) left.push_back(loose[i]);
  loose = std::move(left);
}

std::vector<Index> far_from_scan(const PolyMesh& surface, const PolyMesh& mesh, const SurfaceView& view,
                                 double distance, int threads, Progress& progress) {
  std::vector<Index> far =
      far_points(mesh, surface.positions, distance, threads, progress.step("compare with the scan", 1));
  if (far.empty()) return far;  // vertices of large triangles may be far where these aren't
  std::vector<Vec3> places;
  for (const Index v : far) places.push_back(surface.positions[v]);
  std::vector<Index> all(view.triangles.size());
  std::iota(all.begin(), all.end(), Index{0});
  const TriangleTree tree = tree_near_to(mesh, view, all, places, distance, progress);
  std::erase_if(far, [&](Index v) { return tree.nearest(surface.positions[v], distance).triangle != no_index; });
  return far;
}

double share_of_faces_at(const PolyMesh& surface, std::span<const Index> vertices) {
  double all = 0, there = 0;
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    const double area = area_normal(surface, f).norm();
    all += area;
    if (std::ranges::any_of(surface.face(f), [&](Index v) { return std::ranges::binary_search(vertices, v); }))
      there += area;
  }
  return all > 0 ? there / all : 0;
}

double lost_share(const PolyMesh& mesh, const SurfaceView& view, const RemeshPiece& piece, const RemeshPoints& points,
                  std::span<const Index> lost) {
  const std::size_t own = piece.vertices.size();
  std::vector<std::uint8_t> is_lost(own, 0);
  std::vector<Index> torn;  // triangles with lost samples, ascending
  for (const Index point : lost) {
    if (point < own)
      is_lost[point] = 1;
    else
      torn.push_back(points.triangles[point - own]);
  }
  std::ranges::sort(torn);
  const auto vertex_is_lost = [&](Index v) {
    return is_lost[static_cast<std::size_t>(std::ranges::lower_bound(piece.vertices, v) - piece.vertices.begin())] != 0;
  };
  double whole = 0, gone = 0;
  for (const Index t : piece.triangles) {
    const double area = area_normal(mesh.positions, view.triangles[t]).norm();
    whole += area;
    if (std::ranges::count_if(view.triangles[t], vertex_is_lost) > 1 || std::ranges::binary_search(torn, t))
      gone += area;
  }
  return whole > 0 ? gone / whole : 0;
}

}  // namespace croquis::remeshing
