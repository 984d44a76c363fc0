// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "croquis/geometry/vector.h"

namespace croquis {

/// Which faces are to be turned over so that neighbours agree.
struct FaceOrientation {
  std::vector<std::uint8_t> turned;  ///< #F; of each part the fewer faces, of two halves the one without its lowest
  std::vector<Index> part;           ///< #F, number of the part that neighbours join; parts by their lowest faces
  std::vector<Index> conflict;       ///< per part: the first corner whose faces can't agree, no_index where all can
};

/// Floods part by part from the lowest face; in parts with a conflict `turned` is what the flood has come to.
///
/// Linear in the neighbours.
/// @param visit_neighbours visit_neighbours(face, visit) calls visit(corner, other, disagrees) for each corner of the
///        face with exactly one other face across its edge, which disagrees where both run the edge the same way
template <typename VisitNeighbours>
FaceOrientation orient_faces(std::size_t face_count, const VisitNeighbours& visit_neighbours) {
  FaceOrientation result{std::vector<std::uint8_t>(face_count, 0), std::vector<Index>(face_count, no_index), {}};
  std::vector<Index> members;
  for (Index seed = 0; seed < face_count; ++seed) {
    if (result.part[seed] != no_index) continue;
    const auto number = static_cast<Index>(result.conflict.size());
    Index conflict = no_index;
    std::size_t turned = 0;
    members.assign(1, seed);
    result.part[seed] = number;
    for (std::size_t done = 0; done < members.size(); ++done) {
      const Index face = members[done];
      visit_neighbours(face, [&](Index corner, Index other, bool disagrees) {
        const std::uint8_t wanted = (result.turned[face] != 0) != disagrees ? 1 : 0;
        if (result.part[other] == no_index) {
          result.part[other] = number;
          result.turned[other] = wanted;
          turned += wanted;
          members.push_back(other);
        } else if (result.turned[other] != wanted && conflict == no_index) {
          conflict = corner;
        }
      });
    }
    if (2 * turned > members.size()) {
      for (const Index face : members) result.turned[face] ^= 1U;
    }
    result.conflict.push_back(conflict);
  }
  return result;
}

}  // namespace croquis
