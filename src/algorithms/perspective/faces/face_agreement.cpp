// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/perspective/faces/face_agreement.h"

#include <map>

namespace croquis {
namespace {

struct EdgeUse {
  Index face;
  bool reversed;
};

std::map<Index, std::vector<EdgeUse>> sides_of_edges(const std::vector<FaceCandidate>& candidates,
                                                     const std::vector<Index>& chosen) {
  std::map<Index, std::vector<EdgeUse>> sides;
  for (Index f = 0; f < chosen.size(); ++f) {
    for (const std::vector<Index>& loop : candidates[chosen[f]].loops) {
      for (const Index half : loop) sides[half / 2].push_back({f, (half & 1U) != 0});
    }
  }
  return sides;
}

struct FaceNeighbour {
  Index face;
  bool turned;  ///< against each other
};

}  // namespace

FaceAgreement agree_on_sides(const std::vector<FaceCandidate>& candidates, const std::vector<Index>& chosen) {
  std::vector<std::vector<FaceNeighbour>> neighbours(chosen.size());
  for (const auto& [edge, sides] : sides_of_edges(candidates, chosen)) {
    if (sides.size() != 2) continue;
    const bool turned = sides[0].reversed == sides[1].reversed;
    neighbours[sides[0].face].push_back({sides[1].face, turned});
    neighbours[sides[1].face].push_back({sides[0].face, turned});
  }
  FaceAgreement result{true, std::vector<std::uint8_t>(chosen.size(), 0), std::vector<Index>(chosen.size(), no_index),
                       0};
  for (Index first = 0; first < chosen.size(); ++first) {
    if (result.part[first] != no_index) continue;
    std::vector<Index> pending = {first};
    result.part[first] = result.parts;
    while (!pending.empty()) {
      const Index f = pending.back();
      pending.pop_back();
      for (const FaceNeighbour& other : neighbours[f]) {
        const auto turned = static_cast<std::uint8_t>((result.turned[f] != 0) != other.turned);
        if (result.part[other.face] == no_index) {
          result.part[other.face] = result.parts;
          result.turned[other.face] = turned;
          pending.push_back(other.face);
        } else if (result.turned[other.face] != turned) {
          result.possible = false;
        }
      }
    }
    ++result.parts;
  }
  return result;
}

}  // namespace croquis
