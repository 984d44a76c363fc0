// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/subdivision/cage/face_cutting.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <Eigen/Geometry>

#include "croquis/geometry/edge_channels.h"
#include "croquis/geometry/polygon_area.h"
#include "croquis/geometry/polygon_cut.h"

namespace croquis::subdivision {
namespace {

std::array<Index, 2> sorted(std::array<Index, 2> vertices) {
  if (vertices[1] < vertices[0]) std::swap(vertices[0], vertices[1]);
  return vertices;
}

Vec3 centre(const PolyMesh& mesh, Index face) {
  Vec3 sum = Vec3::Zero();
  for (const Index vertex : mesh.face(face)) sum += mesh.positions[vertex];
  return sum / static_cast<double>(mesh.face(face).size());
}

}  // namespace

TagChanges::TagChanges(MeshTags& tags) : tags_(tags) {
  for (std::size_t i = 0; i < tags_.creases.size(); ++i) crease_of_[sorted(tags_.creases[i].vertices)] = i;
}

void TagChanges::add_crease(std::array<Index, 2> vertices) {
  vertices = sorted(vertices);
  const auto [place, is_new] = crease_of_.try_emplace(vertices, tags_.creases.size());
  if (is_new) {
    tags_.creases.push_back({vertices, infinite_sharpness});
    return;
  }
  if (tags_.creases[place->second].sharpness == infinite_sharpness) return;
  tags_.creases[place->second].sharpness = infinite_sharpness;
  for (CreaseSet& set : tags_.sets) std::erase(set.edges, vertices);  // members share the set's sharpness
}

void TagChanges::add_pin(Index vertex) { tags_.pins.push_back(vertex); }

void TagChanges::finish() {
  std::sort(tags_.pins.begin(), tags_.pins.end());
  tags_.pins.erase(std::unique(tags_.pins.begin(), tags_.pins.end()), tags_.pins.end());
}

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
