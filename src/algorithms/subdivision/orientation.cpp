// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/subdivision/orientation.h"

#include <algorithm>
#include <cstdint>

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

enum class Turn : std::uint8_t { Unknown, Kept, Flipped };

class FloodFill {
 public:
  FloodFill(const PolyMesh& mesh, const EdgePairing& pairing)
      : mesh_(mesh), neighbours_(find_neighbours(mesh, pairing)), turn_(mesh.face_count(), Turn::Unknown) {}

  Orientation run() {
    result_.flipped.assign(mesh_.face_count(), false);
    for (Index face = 0; face < mesh_.face_count(); ++face) {
      if (turn_[face] == Turn::Unknown) fill_part(face);
    }
    return std::move(result_);
  }

 private:
  void fill_part(Index first) {
    contradicts_ = false;
    part_.assign(1, first);
    turn_[first] = Turn::Kept;
    for (std::size_t i = 0; i < part_.size(); ++i) visit_neighbours(part_[i]);
    const auto flipped = static_cast<std::size_t>(
        std::count_if(part_.begin(), part_.end(), [&](Index face) { return turn_[face] == Turn::Flipped; }));
    const Turn fewer = 2 * flipped <= part_.size() ? Turn::Flipped : Turn::Kept;
    for (const Index face : part_) result_.flipped[face] = turn_[face] == fewer;
  }

  void visit_neighbours(Index face) {
    const Index begin = mesh_.face_offsets[face], end = mesh_.face_offsets[face + std::size_t{1}];
    for (Index corner = begin; corner < end; ++corner) {
      const Index other = neighbours_.face[corner];
      if (other == no_index) continue;
      const bool flip = (turn_[face] == Turn::Flipped) != neighbours_.disagrees[corner];
      const Turn wanted = flip ? Turn::Flipped : Turn::Kept;
      if (turn_[other] == Turn::Unknown) {
        turn_[other] = wanted;
        part_.push_back(other);
      } else if (turn_[other] != wanted && !contradicts_) {
        contradicts_ = true;
        const Index next = corner + 1 == end ? begin : corner + 1;
        result_.contradictions.push_back({mesh_.corners[corner], mesh_.corners[next]});
      }
    }
  }

  const PolyMesh& mesh_;
  const Neighbours neighbours_;
  std::vector<Turn> turn_;
  std::vector<Index> part_;
  bool contradicts_ = false;
  Orientation result_;
};

}  // namespace

Orientation orient(const PolyMesh& mesh, const EdgePairing& pairing) { return FloodFill(mesh, pairing).run(); }

}  // namespace croquis::subdivision
