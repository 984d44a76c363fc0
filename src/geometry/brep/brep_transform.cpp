// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "croquis/geometry/brep.h"

namespace croquis {
namespace {

void map_cubics(std::vector<RationalCubic>& cubics, const Affine3& map) {
  for (RationalCubic& cubic : cubics) {
    for (Vec3& point : cubic.points) point = map(point);
  }
}

void map_patch(GregoryPatch& patch, const Affine3& map) {
  for (Vec3& point : patch.boundary) point = map(point);
  for (Vec3& point : patch.inner) point = map(point);
}

/// The plane's normal goes by the inverse transpose: what is outside stays outside.
void map_plane(BrepFace& face, const Affine3& map, const Eigen::Matrix3d& inverse_transpose) {
  const Vec3 normal = inverse_transpose * face.normal;
  face.origin = map(face.origin);
  face.flatness /= normal.norm();
  face.normal = normal.normalized();
}

/// The same patch with u and v exchanged: corner 0 stays, corner 1 becomes corner 3, and side i side 3 - i.
GregoryPatch exchanged(const GregoryPatch& patch) {
  GregoryPatch result;
  for (std::size_t i = 0; i < 12; ++i) result.boundary[i] = patch.boundary[(12 - i) % 12];
  for (std::size_t corner = 0; corner < 4; ++corner) {
    const std::size_t old = (4 - corner) % 4;
    result.inner[2 * corner] = patch.inner[2 * old + 1];
    result.inner[2 * corner + 1] = patch.inner[2 * old];
  }
  return result;
}

/// The same patch whose corner 0 is the old corner 1.
GregoryPatch begun_later(const GregoryPatch& patch) {
  GregoryPatch result = patch;
  std::rotate(result.boundary.begin(), result.boundary.begin() + 3, result.boundary.end());
  std::rotate(result.inner.begin(), result.inner.begin() + 2, result.inner.end());
  return result;
}

/// The patches of a face whose loop is turned round: its first half-edge stays the first one.
std::vector<GregoryPatch> turned(const std::vector<GregoryPatch>& patches) {
  if (patches.size() == 1) return {exchanged(begun_later(patches[0]))};
  std::vector<GregoryPatch> result;
  for (std::size_t i = 0; i < patches.size(); ++i) {
    result.push_back(exchanged(patches[(patches.size() + 1 - i) % patches.size()]));
  }
  return result;
}

/// Half-edges run the other way, the first of each loop stays its first.
void turn_loops(Brep& brep) {
  std::vector<Index> before(brep.half_edges.size());
  for (Index h = 0; h < brep.half_edges.size(); ++h) before[brep.half_edges[h].next] = h;
  for (Index h = 0; h < brep.half_edges.size(); ++h) {
    brep.half_edges[h].next = before[h];
    brep.half_edges[h].reversed = !brep.half_edges[h].reversed;
  }
  for (BrepEdge& edge : brep.edges) {
    std::swap(edge.half_edges[0], edge.half_edges[1]);
    for (Vec3& across : edge.across) across = -across;
  }
  for (BrepFace& face : brep.faces) {
    if (!face.patches.empty()) face.patches = turned(face.patches);
  }
}

}  // namespace

BoundingBox bounds_of(const Brep& brep) {
  Eigen::AlignedBox3d box;
  for (const BrepVertex& vertex : brep.vertices) box.extend(vertex.point);
  for (const BrepEdge& edge : brep.edges) {
    for (const std::vector<RationalCubic>* cubics : {&edge.pieces, &edge.fitted}) {
      for (const RationalCubic& cubic : *cubics) {
        for (const Vec3& point : cubic.points) box.extend(point);
      }
    }
  }
  for (const BrepFace& face : brep.faces) {
    for (const GregoryPatch& patch : face.patches) {
      for (const Vec3& point : patch.boundary) box.extend(point);
      for (const Vec3& point : patch.inner) box.extend(point);
    }
  }
  if (box.isEmpty()) return std::nullopt;
  return std::array<Vec3, 2>{box.min(), box.max()};
}

Brep transformed(const Brep& brep, const Affine3& map) {
  const Eigen::Matrix3d inverse_transpose = map.linear.inverse().transpose();
  Brep result = brep;
  for (BrepVertex& vertex : result.vertices) vertex.point = map(vertex.point);
  for (BrepEdge& edge : result.edges) {
    map_cubics(edge.pieces, map);
    map_cubics(edge.fitted, map);
    for (Vec3& across : edge.across) across = map.linear * across;
  }
  for (BrepFace& face : result.faces) {
    map_plane(face, map, inverse_transpose);
    for (GregoryPatch& patch : face.patches) map_patch(patch, map);
  }
  if (map.mirrors()) turn_loops(result);
  return result;
}

}  // namespace croquis
