// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/subdivision/cage/face_cutting.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <Eigen/Geometry>

#include "algorithms/subdivision/cage/tag_changes.h"
#include "croquis/geometry/edge_channels.h"
#include "croquis/geometry/polygon_area.h"
#include "croquis/geometry/polygon_cut.h"

namespace croquis::subdivision {
namespace {

Vec3 centre(const PolyMesh& mesh, Index face) {
  Vec3 sum = Vec3::Zero();
  for (const Index vertex : mesh.face(face)) sum += mesh.positions[vertex];
  return sum / static_cast<double>(mesh.face(face).size());
}

}  // namespace

double relative_deviation(const PolyMesh& mesh, Index face) {
  const Vec3 origin = centre(mesh, face);
  const Vec3 normal = area_normal(mesh, face).normalized();
  double deviation = 0;
  double radius = 0;
  for (const Index vertex : mesh.face(face)) {
    deviation = std::max(deviation, std::abs((mesh.positions[vertex] - origin).dot(normal)));
    radius = std::max(radius, (mesh.positions[vertex] - origin).norm());
  }
  return radius > 0 ? deviation / (2 * radius) : 0;
}

FaceTriangles triangulated_face(const PolyMesh& mesh, const MeshTopology& topology, Index face) {
  return polygon_cut(mesh.positions, mesh.face(face),
                     [&](Index a, Index b) { return find_edge(topology, a, b) != no_index; });
}

CutMesh with_faces_cut(const PolyMesh& mesh, const std::map<Index, FaceTriangles>& cuts) {
  CutMesh result{mesh, {}};
  result.mesh.face_offsets = {0};
  result.mesh.corners.clear();
  std::vector<Index> source_corner;
  const auto add = [&](Index face, auto corners) {
    for (const Index corner : corners) {
      source_corner.push_back(mesh.face_offsets[face] + corner);
      result.mesh.corners.push_back(mesh.face(face)[corner]);
    }
    result.mesh.face_offsets.push_back(static_cast<Index>(result.mesh.corners.size()));
    result.source_face.push_back(face);
  };
  for (Index face = 0; face < mesh.face_count(); ++face) {
    if (const auto cut = cuts.find(face); cut != cuts.end()) {
      for (const auto& triangle : cut->second) add(face, triangle);
    } else {
      std::vector<Index> all(mesh.face(face).size());
      std::iota(all.begin(), all.end(), Index{0});
      add(face, all);
    }
  }
  for (AttributeChannel& channel : result.mesh.channels) {
    if (channel.domain == Domain::Face) channel = gathered(channel, result.source_face);
    if (channel.domain == Domain::Corner) channel = gathered(channel, source_corner);
  }
  renumber_edge_channels(mesh, {}, result.mesh);
  return result;
}

}  // namespace croquis::subdivision
