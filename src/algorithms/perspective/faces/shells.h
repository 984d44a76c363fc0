// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "algorithms/perspective/faces/solid_graph.h"
#include "croquis/perspective/face_finding.h"

namespace croquis {

/// How faces must be turned so that neighbours run along their common edges in opposite directions.
struct FaceAgreement {
  bool possible = true;
  std::vector<std::uint8_t> turned;  ///< per chosen face; the first of each connected part isn't
  std::vector<Index> part;           ///< per chosen face: number of its connected part, by its lowest face
  Index parts = 0;
};

FaceAgreement agree_on_sides(const std::vector<FaceCandidate>& candidates, const std::vector<Index>& chosen);

inline bool can_agree(const std::vector<FaceCandidate>& candidates, const std::vector<Index>& chosen) {
  return agree_on_sides(candidates, chosen).possible;
}

/// The faces of a choice, turned outwards and put together to shells; shells inside others bound voids.
FaceSet make_shells(const SolidGraph& graph, const std::vector<FaceCandidate>& candidates,
                    const std::vector<Index>& chosen, double cost);

/// How many regions of planes lie inside the solid and were not chosen.
std::size_t count_internal(const SolidGraph& graph, const std::vector<FaceCandidate>& candidates,
                           const std::vector<Index>& chosen);

}  // namespace croquis
