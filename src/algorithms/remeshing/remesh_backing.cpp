// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/remeshing/remesh_backing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "algorithms/remeshing/remesh_improvement.h"
#include "algorithms/remeshing/remesh_trimming.h"
#include "croquis/base/parallel.h"
#include "croquis/geometry/disjoint_sets.h"
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
constexpr double rim_within = 2;              // × far: the border of what is far lies beside a rim
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
  NearTriangles(const PolyMesh& mesh, const SurfaceView& view, std::span<const Index> triangles,
                const std::vector<Vec3>& places, double far, Progress& progress)
      : tree_(near_to(mesh, view, triangles, implicit::PointTree(places), far), progress), far_(far) {}

  TriangleFoot nearest(const Vec3& place) const { return tree_.nearest(place, far_); }

 private:
  static std::vector<std::array<Vec3, 3>> near_to(const PolyMesh& mesh, const SurfaceView& view,
                                                  std::span<const Index> numbers, const implicit::PointTree& places,
                                                  double far) {
    std::vector<std::array<Vec3, 3>> triangles;
    for (const Index t : numbers) {
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

constexpr std::uint8_t in_hole = 2;  // of a vertex: far from the mesh, in the reach of a hole

/// What lies far from the mesh given in the reach of holes, in parts that hang together.
class HoleSurfaces {
 public:
  /// @param vertices marks; @param along how far from a rim a border may be that lies along it
  HoleSurfaces(const PolyMesh& surface, const HoleReach& holes, std::span<const std::uint8_t> vertices, double along)
      : surface_(surface), holes_(holes), vertices_(vertices), sets_(surface.vertex_count()) {
    std::vector<std::uint8_t> is_border(vertices.size(), 0);
    for (std::size_t f = 0; f < surface.face_count(); ++f) {
      Index known = no_index;
      for (const Index v : surface.face(f)) {
        if (!is_in_hole(v)) continue;
        if (known != no_index) sets_.unite(known, v);
        known = v;
      }
      if (known == no_index || std::ranges::all_of(surface.face(f), [&](Index v) { return is_in_hole(v); })) continue;
      for (const Index v : surface.face(f)) is_border[v] = is_in_hole(v) ? 1 : 0;
    }
    for (Index v = 0; v < is_border.size(); ++v) {
      if (is_border[v] == 0) continue;
      Part& part = parts_[sets_.root(v)];
      const Index zone = holes.zone_along(surface.positions[v], along);
      ++(zone == no_index ? part.elsewhere : part.along[zone]);
    }
  }

  /// Marks the vertices of strays, clears the other marks, and compares areas.
  void judge(Strays& strays) {
    std::vector<double> areas(holes_.zone_count(), 0);
    for (std::size_t f = 0; f < surface_.face_count(); ++f) {
      const auto face = surface_.face(f);
      const auto far = std::ranges::find_if(face, [&](Index v) { return is_in_hole(v); });
      if (far == face.end()) continue;
      const Part& part = parts_[sets_.root(*far)];
      if (part.is_backed()) areas[part.zone()] += triangle_area_of(surface_.positions, face[0], face[1], face[2]);
    }
    std::vector<std::uint8_t> marks(vertices_.begin(), vertices_.end());
    for (Index v = 0; v < marks.size(); ++v)
      if (marks[v] == in_hole) marks[v] = closes_hole(v) ? 0 : 1;
    strays.vertices = std::move(marks);
    for (Index zone = 0; zone < areas.size(); ++zone)
      strays.overfills = strays.overfills || areas[zone] > holes_.area(zone);
  }

 private:
  /// Vertices at the border of a part, by the zone whose rim they lie along.
  struct Part {
    std::map<Index, std::size_t> along;
    std::size_t elsewhere = 0;

    bool is_backed() const {
      std::size_t count = 0;
      for (const auto& [zone, vertices] : along) count += vertices;
      return count > 0 && count >= elsewhere;
    }
    Index zone() const {
      return std::ranges::max_element(along, {}, [](const auto& a) { return a.second; })->first;
    }
  };

  bool is_in_hole(Index v) const { return vertices_[v] == in_hole; }

  bool closes_hole(Index v) {
    const Part& part = parts_[sets_.root(v)];
    return part.is_backed() && std::ranges::any_of(part.along, [&](const auto& zone) {
             return holes_.contains(surface_.positions[v], zone.first);
           });
  }

  const PolyMesh& surface_;
  const HoleReach& holes_;
  std::span<const std::uint8_t> vertices_;
  DisjointSets sets_;
  std::map<Index, Part> parts_;  // by their roots
};

}  // namespace

HoleReach::HoleReach(const PolyMesh& mesh, const HoleAnalysis& analysis, const RemeshPiece& piece,
                     const std::vector<RimPlace>& rims, std::span<const HoleRequest> requests, double edge,
                     std::span<const Index> open)
    : seam_places_(places_at_seams(mesh, piece, rims)), seams_(seam_places_), seam_reach_(view_gap * edge) {
  std::vector<std::vector<Index>> groups = piece.groups;
  for (const Index cap : piece.caps) groups.push_back({cap});
  const auto is_open = [&](const std::vector<Index>& group) {
    return std::ranges::find_first_of(group, open) != group.end();
  };
  std::erase_if(groups, is_open);
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
      zone.spacing = std::max(zone.spacing,
                              static_cast<double>(stride) * hole.perimeter / static_cast<double>(hole.vertices.size()));
    }
    zone.on_rim = zone.points.size();
    for (const HoleRequest& request : requests)
      if (std::ranges::find_first_of(request.holes, group) != request.holes.end())
        zone.points.insert(zone.points.end(), request.through.begin(), request.through.end());
    for (const Vec3& point : zone.points) zone.box.extend(point);
    // A band between rims may be as long as they are apart.
    zone.area = area_of_hole * area + perimeter * (group.size() > 1 ? zone.box.diagonal().norm() : 0.25 * diameter);
    zone.reach = reach_of_hole * diameter;
    zone.box = {zone.box.min() - Vec3::Constant(zone.reach), zone.box.max() + Vec3::Constant(zone.reach)};
    zones_.push_back(std::move(zone));
  }
  std::ranges::stable_sort(zones_, std::greater(), &Zone::reach);
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

Strays find_strays(const PolyMesh& surface, const PolyMesh& mesh, const SurfaceView& view, const RemeshPiece& piece,
                   const NearestSurface& given, const HoleReach& holes, double near, double far, int threads,
                   Progress& progress) {
  constexpr std::uint8_t in_doubt = 3;
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
  const NearTriangles triangles(mesh, view, piece.triangles, places, far, progress);
  measure_doubtful(surface, triangles, near, threads, strays, doubtful, progress);
  HoleSurfaces(surface, holes, strays.vertices, rim_within * far).judge(strays);
  strays.count = static_cast<std::size_t>(std::ranges::count(strays.vertices, 1));
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

std::vector<Index> far_from_scan(const PolyMesh& surface, const PolyMesh& mesh, const SurfaceView& view,
                                 double distance, int threads, Progress& progress) {
  std::vector<Index> far = far_points(mesh, surface.positions, distance, threads, progress);
  if (far.empty()) return far;  // vertices of large triangles may be far where these aren't
  std::vector<Vec3> places;
  for (const Index v : far) places.push_back(surface.positions[v]);
  std::vector<Index> all(view.triangles.size());
  std::iota(all.begin(), all.end(), Index{0});
  const NearTriangles triangles(mesh, view, all, places, distance, progress);
  std::erase_if(far, [&](Index v) { return triangles.nearest(surface.positions[v]).triangle != no_index; });
  return far;
}

double share_of_faces_at(const PolyMesh& surface, std::span<const Index> vertices) {
  double all = 0, there = 0;
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    const auto face = surface.face(f);
    const double area = triangle_area_of(surface.positions, face[0], face[1], face[2]);
    all += area;
    if (std::ranges::any_of(face, [&](Index v) { return std::ranges::binary_search(vertices, v); })) there += area;
  }
  return all > 0 ? there / all : 0;
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
