// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/subdivision/cage/orientation.h"

#include <algorithm>

#include "croquis/geometry/face_orientation.h"

namespace croquis::subdivision {
namespace {

/// The neighbour across each corner's edge, and whether both run the same way.
struct Neighbours {
  std::vector<Index> face;  ///< #C
  std::vector<bool> disagrees;
};

std::vector<Index> faces_of_corners(const PolyMesh& mesh) {
  std::vector<Index> faces(mesh.corners.size());
  for (Index face = 0; face < mesh.face_count(); ++face) {
    std::fill(faces.begin() + mesh.face_offsets[face], faces.begin() + mesh.face_offsets[face + std::size_t{1}], face);
  }
  return faces;
}

Neighbours find_neighbours(const PolyMesh& mesh, const EdgePairing& pairing) {
  const std::vector<Index> face_of = faces_of_corners(mesh);
  Neighbours neighbours{std::vector<Index>(mesh.corners.size(), no_index), std::vector<bool>(mesh.corners.size())};
  pairing.for_each_edge([&](std::span<const Index> corners) {
    if (corners.size() != 2) return;
    const auto [a, b] = std::pair(corners[0], corners[1]);
    neighbours.face[a] = face_of[b];
    neighbours.face[b] = face_of[a];
    neighbours.disagrees[a] = neighbours.disagrees[b] = mesh.corners[a] == mesh.corners[b];
  });
  return neighbours;
}

/// The vertices of the edge that begins at a corner.
std::array<Index, 2> ends_of(const PolyMesh& mesh, Index corner) {
  const auto after = std::upper_bound(mesh.face_offsets.begin(), mesh.face_offsets.end(), corner);
  const Index next = corner + 1 == *after ? *(after - 1) : corner + 1;
  return {mesh.corners[corner], mesh.corners[next]};
}

}  // namespace

Orientation orient(const PolyMesh& mesh, const EdgePairing& pairing) {
  const Neighbours neighbours = find_neighbours(mesh, pairing);
  const FaceOrientation found = orient_faces(mesh.face_count(), [&](Index face, auto&& visit) {
    for (Index corner = mesh.face_offsets[face]; corner < mesh.face_offsets[face + std::size_t{1}]; ++corner) {
      if (neighbours.face[corner] != no_index) visit(corner, neighbours.face[corner], neighbours.disagrees[corner]);
    }
  });
  Orientation orientation{{found.turned.begin(), found.turned.end()}, {}};
  for (const Index corner : found.conflict) {
    if (corner != no_index) orientation.contradictions.push_back(ends_of(mesh, corner));
  }
  return orientation;
}

}  // namespace croquis::subdivision
