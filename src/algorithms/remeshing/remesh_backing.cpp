// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/remeshing/remesh_backing.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "croquis/base/parallel.h"

namespace croquis::remeshing {
namespace {

using namespace hole_filling;

constexpr double reach_of_hole = 0.75;        // × diameter
constexpr double area_of_hole = 4;            // × that of the flattest patch: half a sphere has 2
constexpr std::size_t most_rim_points = 256;  // of a hole: others between them are almost as near
constexpr std::size_t backing_grain = 4096;   // vertices per part

double triangle_area_of(const std::vector<Vec3>& at, Index a, Index b, Index c) {
  return 0.5 * (at[b] - at[a]).cross(at[c] - at[a]).norm();
}

}  // namespace

HoleReach::HoleReach(const PolyMesh& mesh, const HoleAnalysis& analysis, const RemeshPiece& piece,
                     std::span<const HoleRequest> requests) {
  std::vector<std::vector<Index>> groups = piece.groups;
  for (const Index cap : piece.caps) groups.push_back({cap});
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
  return std::ranges::any_of(zones_, [&](const Zone& zone) {
    return zone.box.contains(place) && std::ranges::any_of(zone.points, [&](const Vec3& point) {
             return (place - point).squaredNorm() <= zone.reach * zone.reach;
           });
  });
}

Strays find_strays(const PolyMesh& surface, const NearestSurface& given, const HoleReach& holes, double far,
                   int threads, Progress& progress) {
  constexpr std::uint8_t in_hole = 2;
  Strays strays;
  strays.vertices.assign(surface.vertex_count(), 0);
  for_each_part(strays.vertices.size(), backing_grain, threads, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      const Vec3& place = surface.positions[v];
      if (given.nearest(place).distance > far) strays.vertices[v] = holes.contains(place) ? in_hole : 1;
    }
  });
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
