// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/surface/mirror_halves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "croquis/geometry/mesh_part.h"
#include "croquis/geometry/mesh_report.h"

namespace croquis::silhouette {
namespace {

/// A vertex nearer to the plane than this share of its shortest edge is moved onto it: else there were thin triangles.
constexpr double snap_share = 0.2;

std::vector<double> shortest_edges(const PolyMesh& mesh) {
  std::vector<double> shortest(mesh.vertex_count(), std::numeric_limits<double>::infinity());
  for (Index face = 0; face < mesh.face_count(); ++face) {
    const auto corners = mesh.face(face);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Index a = corners[k], b = corners[(k + 1) % corners.size()];
      const double length = (mesh.positions[a] - mesh.positions[b]).norm();
      shortest[a] = std::min(shortest[a], length);
      shortest[b] = std::min(shortest[b], length);
    }
  }
  return shortest;
}

/// The left half of a mesh, then both halves.
struct Halves {
  PolyMesh mesh;
  std::vector<std::int32_t> objects;  ///< per face
  std::map<std::array<Index, 2>, Index> cuts;

  /// Where an edge goes through the plane. @param from, to numbers and places of its ends
  Index cut(std::pair<Index, Vec3> from, std::pair<Index, Vec3> to, double axis) {
    if (to.first < from.first) std::swap(from, to);
    const auto [place, added] = cuts.try_emplace({from.first, to.first}, static_cast<Index>(mesh.vertex_count()));
    if (added) {
      const double t = (axis - from.second.x()) / (to.second.x() - from.second.x());
      Vec3 at = from.second + t * (to.second - from.second);
      at.x() = axis;
      mesh.positions.push_back(at);
    }
    return place->second;
  }

  void add(const std::vector<Index>& polygon, std::int32_t object) {
    const auto add_triangle = [&](Index a, Index b, Index c) {
      mesh.add_face({{a, b, c}});
      objects.push_back(object);
    };
    if (polygon.size() == 3) return add_triangle(polygon[0], polygon[1], polygon[2]);
    const auto length = [&](std::size_t a, std::size_t b) {
      return (mesh.positions[polygon[a]] - mesh.positions[polygon[b]]).squaredNorm();
    };
    const std::size_t k = length(0, 2) <= length(1, 3) ? 0 : 1;
    add_triangle(polygon[k], polygon[k + 1], polygon[k + 2]);
    add_triangle(polygon[k], polygon[k + 2], polygon[(k + 3) % 4]);
  }
};

/// What of the mesh lies on the left. Vertices keep their numbers.
Halves left_half(const PolyMesh& mesh, double axis) {
  Halves half;
  half.mesh.positions = mesh.positions;
  const std::vector<double> shortest = shortest_edges(mesh);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    double& x = half.mesh.positions[v].x();
    if (std::abs(x - axis) < snap_share * shortest[v]) x = axis;
  }
  const auto& objects = std::get<std::vector<std::int32_t>>(mesh.channel("object", Domain::Face)->data);
  std::vector<Index> polygon;
  for (Index face = 0; face < mesh.face_count(); ++face) {
    polygon.clear();
    const auto corners = mesh.face(face);
    const auto at = [&](std::size_t k) { return std::pair(corners[k % 3], half.mesh.positions[corners[k % 3]]); };
    bool reaches_left = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto from = at(k), to = at(k + 1);
      const double here = from.second.x() - axis, there = to.second.x() - axis;
      reaches_left = reaches_left || here < 0;
      if (here <= 0) polygon.push_back(from.first);
      if (here * there < 0) polygon.push_back(half.cut(from, to, axis));
    }
    if (reaches_left) half.add(polygon, objects[face]);
  }
  return half;
}

void add_mirror_image(Halves& half, double axis, std::span<const std::int32_t> twins) {
  PolyMesh& mesh = half.mesh;
  const Index count = static_cast<Index>(mesh.vertex_count());
  std::vector<Index> image(count);
  for (Index v = 0; v < count; ++v) {
    image[v] = v;
    if (mesh.positions[v].x() == axis) continue;
    image[v] = static_cast<Index>(mesh.vertex_count());
    Vec3 place = mesh.positions[v];
    place.x() = 2 * axis - place.x();
    mesh.positions.push_back(place);
  }
  const Index faces = static_cast<Index>(mesh.face_count());
  for (Index face = 0; face < faces; ++face) {
    const auto corners = mesh.face(face);
    mesh.add_face({{image[corners[2]], image[corners[1]], image[corners[0]]}});
    half.objects.push_back(twins[static_cast<std::size_t>(half.objects[face])]);
  }
}

}  // namespace

std::optional<PolyMesh> with_mirrored_half(const PolyMesh& mesh, double axis, std::span<const std::int32_t> twins,
                                           Progress& progress) {
  Halves half = left_half(mesh, axis);
  add_mirror_image(half, axis, twins);
  AttributeChannel channel = *mesh.channel("object", Domain::Face);
  channel.data = std::move(half.objects);
  half.mesh.channels.push_back(std::move(channel));
  std::vector<bool> used(half.mesh.vertex_count(), false);
  for (const Index vertex : half.mesh.corners) used[vertex] = true;
  PolyMesh result = part_of(half.mesh, used, std::vector<bool>(half.mesh.face_count(), true)).mesh;
  Progress quiet = progress.silent();
  const MeshReport before = inspect(mesh, false, quiet), after = inspect(result, true, quiet);
  const bool is_sound = after.closed && after.oriented && after.nonmanifold_vertices == 0 &&
                        after.self_intersections == 0 && after.euler_characteristic == before.euler_characteristic;
  return is_sound ? std::optional(std::move(result)) : std::nullopt;
}

}  // namespace croquis::silhouette
