// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/remeshing/remesh_backing.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "algorithms/remeshing/remesh_improvement.h"
#include "algorithms/remeshing/remesh_trimming.h"
#include "croquis/base/parallel.h"
#include "croquis/geometry/single_precision.h"
#include "croquis/geometry/triangle_fans.h"
#include "croquis/geometry/triangle_tree.h"

namespace croquis::remeshing {
namespace {

using namespace hole_filling;

constexpr double reach_of_hole = 0.75;        // × diameter
constexpr double area_of_hole = 4;            // × that of the flattest patch: half a sphere has 2
constexpr std::size_t most_rim_points = 256;  // of a hole: others between them are almost as near
constexpr std::size_t backing_grain = 4096;   // vertices per part
constexpr double view_gap = 3;                // × edge: views may be that far apart
constexpr double brought_within = 0.9;        // × what is near: rounding and smoothing may move it again

double triangle_area_of(const std::vector<Vec3>& at, Index a, Index b, Index c) {
  return 0.5 * (at[b] - at[a]).cross(at[c] - at[a]).norm();
}

std::vector<Vec3> places_at_seams(const PolyMesh& mesh, const RemeshPiece& piece, const std::vector<RimPlace>& rims) {
  std::vector<Vec3> places;
  for (const RimPlace& rim : rims)
    if (rim.fate == RimFate::Seam && std::ranges::binary_search(piece.vertices, rim.vertex))
      places.push_back(mesh.positions[rim.vertex]);
  return places;
}

/// Exact distances from places that are no farther than `far` from a piece, by a tree of the triangles near to them.
class NearTriangles {
 public:
  NearTriangles(const PolyMesh& mesh, const SurfaceView& view, const RemeshPiece& piece,
                const std::vector<Vec3>& places, double far, Progress& progress)
      : tree_(near_to(mesh, view, piece, implicit::PointTree(places), far), progress), far_(far) {}

  TriangleFoot nearest(const Vec3& place) const { return tree_.nearest(place, far_); }

 private:
  static std::vector<std::array<Vec3, 3>> near_to(const PolyMesh& mesh, const SurfaceView& view,
                                                  const RemeshPiece& piece, const implicit::PointTree& places,
                                                  double far) {
    std::vector<std::array<Vec3, 3>> triangles;
    for (const Index t : piece.triangles) {
      const auto& [a, b, c] = view.triangles[t];
      const std::array<Vec3, 3> corners = {mesh.positions[a], mesh.positions[b], mesh.positions[c]};
      implicit::Box box = implicit::bounds(corners);
      box.low.array() -= far;
      box.high.array() += far;
      if (places.holds_more_than(0, box)) triangles.push_back(corners);
    }
    return triangles;
  }

  TriangleTree tree_;
  double far_;
};

/// Marks vertices from which others of the same mark lead to a border.
std::vector<std::uint8_t> hanging_on_borders(const PolyMesh& surface, std::span<const LooseVertex> loose, int threads,
                                             Progress& progress) {
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
  return hangs;
}

/// Vertices that may be loose or strays are either, or neither, by their exact distances.
void measure_doubtful(const PolyMesh& surface, const NearTriangles& triangles, double near, int threads, Strays& strays,
                      std::span<const Index> doubtful, Progress& progress) {
  std::vector<TriangleFoot> feet(doubtful.size());
  for_each_part(feet.size(), backing_grain, threads, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) feet[i] = triangles.nearest(surface.positions[doubtful[i]]);
  });
  for (std::size_t i = 0; i < feet.size(); ++i) {
    strays.vertices[doubtful[i]] = feet[i].triangle == no_index ? 1 : 0;
    if (feet[i].triangle != no_index && feet[i].distance > near)
      strays.loose.push_back({doubtful[i], feet[i].point, feet[i].distance});
  }
}

}  // namespace

HoleReach::HoleReach(const PolyMesh& mesh, const HoleAnalysis& analysis, const RemeshPiece& piece,
                     const std::vector<RimPlace>& rims, std::span<const HoleRequest> requests, double edge,
                     std::span<const Index> failed)
    : seam_places_(places_at_seams(mesh, piece, rims)), seams_(seam_places_), seam_reach_(view_gap * edge) {
  std::vector<std::vector<Index>> groups = piece.groups;
  for (const Index cap : piece.caps) groups.push_back({cap});
  const auto has_failed = [&](const std::vector<Index>& group) {
    return std::ranges::find_first_of(group, failed) != group.end();
  };
  std::erase_if(groups, has_failed);
  for (const std::vector<Index>& group : groups) {
    Zone zone;
    double perimeter = 0, diameter = 0, area = 0;
    for (const Index id : group) {
      const Hole& hole = analysis.holes[id];
      const std::size_t stride = hole.vertices.size() / most_rim_points + 1;
      for (std::size_t i = 0; i < hole.vertices.size(); i += stride)
        zone.points.push_back(mesh.positions[hole.vertices[i]]);
      perimeter += hole.perimeter;
      area += hole.area;
      diameter = std::max(diameter, hole.diameter);
    }
    for (const HoleRequest& request : requests)
      if (std::ranges::find_first_of(request.holes, group) != request.holes.end())
        zone.points.insert(zone.points.end(), request.through.begin(), request.through.end());
    for (const Vec3& point : zone.points) zone.box.extend(point);
    // A band between rims may be as long as they are apart.
    area_ += area_of_hole * area + perimeter * (group.size() > 1 ? zone.box.diagonal().norm() : 0.25 * diameter);
    zone.reach = reach_of_hole * diameter;
    zone.box = {zone.box.min() - Vec3::Constant(zone.reach), zone.box.max() + Vec3::Constant(zone.reach)};
    zones_.push_back(std::move(zone));
  }
  std::ranges::stable_sort(zones_, std::greater(), &Zone::reach);
}

bool HoleReach::contains(const Vec3& place) const {
  if (!seam_places_.empty() && (place - seam_places_[seams_.nearest(place)]).norm() <= seam_reach_) return true;
  return std::ranges::any_of(zones_, [&](const Zone& zone) {
    return zone.box.contains(place) && std::ranges::any_of(zone.points, [&](const Vec3& point) {
             return (place - point).squaredNorm() <= zone.reach * zone.reach;
           });
  });
}

Strays find_strays(const PolyMesh& surface, const PolyMesh& mesh, const SurfaceView& view, const RemeshPiece& piece,
                   const NearestSurface& given, const HoleReach& holes, double near, double far, int threads,
                   Progress& progress) {
  constexpr std::uint8_t in_hole = 2, in_doubt = 3;
  Strays strays;
  strays.vertices.assign(surface.vertex_count(), 0);
  for_each_part(strays.vertices.size(), backing_grain, threads, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      const Vec3& place = surface.positions[v];
      const double most = given.nearest(place).distance;
      if (most <= near) continue;
      const bool is_in_hole = holes.contains(place);
      if (!is_in_hole || most > far) strays.vertices[v] = is_in_hole ? in_hole : in_doubt;
    }
  });
  std::vector<Index> doubtful;
  std::vector<Vec3> places;
  for (Index v = 0; v < strays.vertices.size(); ++v) {
    if (strays.vertices[v] != in_doubt) continue;
    doubtful.push_back(v);
    places.push_back(surface.positions[v]);
  }
  const NearTriangles triangles(mesh, view, piece, places, far, progress);
  measure_doubtful(surface, triangles, near, threads, strays, doubtful, progress);
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    const auto face = surface.face(f);
    if (std::ranges::any_of(face, [&](Index v) { return strays.vertices[v] == in_hole; }))
      strays.hole_area += triangle_area_of(surface.positions, face[0], face[1], face[2]);
  }
  for (std::uint8_t& vertex : strays.vertices) {
    if (vertex == in_hole) vertex = 0;
    strays.count += vertex;
  }
  strays.overfills = strays.hole_area > holes.area();
  return strays;
}

bool trim_loose(PolyMesh& surface, std::span<const LooseVertex> loose, int threads, Progress& progress) {
  const std::vector<std::uint8_t> hangs = hanging_on_borders(surface, loose, threads, progress);
  std::vector<std::uint8_t> removed(surface.face_count(), 0);
  for (std::size_t f = 0; f < removed.size(); ++f)
    removed[f] = std::ranges::all_of(surface.face(f), [&](Index v) { return hangs[v] != 0; }) ? 1 : 0;
  if (std::ranges::find(removed, 1) == removed.end()) return false;
  surface = sound_without(surface, removed);
  return true;
}

void bring_near(PolyMesh& surface, std::vector<LooseVertex>& loose, double near, Precision precision,
                Progress& progress) {
  std::vector<Vec3> before = surface.positions, moved;
  std::vector<Index> vertices;
  for (const LooseVertex& vertex : loose) {
    const Vec3 away = before[vertex.vertex] - vertex.foot;
    moved.push_back(vertex.foot + brought_within * near / vertex.distance * away);
    vertices.push_back(vertex.vertex);
  }
  if (precision == Precision::Single) round_to_single(moved);
  for (std::size_t i = 0; i < moved.size(); ++i) surface.positions[vertices[i]] = moved[i];
  undo_where_cut(surface, before, vertices, progress);
  std::vector<LooseVertex> left;
  for (std::size_t i = 0; i < loose.size(); ++i)
    if (surface.positions[vertices[i]] != moved[i]) left.push_back(loose[i]);
  loose = std::move(left);
}

double lost_share(const PolyMesh& mesh, const SurfaceView& view, const RemeshPiece& piece, const RemeshPoints& points,
                  std::span<const Index> lost) {
  std::vector<std::uint8_t> is_lost(points.positions.size(), 0);
  for (const Index point : lost) is_lost[point] = 1;
  std::vector<Index> torn;  // triangles with lost samples, ascending
  for (std::size_t p = piece.vertices.size(); p < is_lost.size(); ++p)
    if (is_lost[p] != 0) torn.push_back(points.triangles[p - piece.vertices.size()]);
  std::ranges::sort(torn);
  const auto vertex_is_lost = [&](Index v) {
    return is_lost[static_cast<std::size_t>(std::ranges::lower_bound(piece.vertices, v) - piece.vertices.begin())] != 0;
  };
  double whole = 0, gone = 0;
  for (const Index t : piece.triangles) {
    const auto& corners = view.triangles[t];
    const double area = triangle_area_of(mesh.positions, corners[0], corners[1], corners[2]);
    whole += area;
    if (std::ranges::count_if(corners, vertex_is_lost) > 1 || std::ranges::binary_search(torn, t)) gone += area;
  }
  return whole > 0 ? gone / whole : 0;
}

}  // namespace croquis::remeshing
