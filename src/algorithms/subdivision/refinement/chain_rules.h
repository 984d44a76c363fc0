// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/subdivision/refinement/face_mask.h"
#include "algorithms/subdivision/refinement/special_faces.h"
#include "croquis/subdivision/rules.h"

namespace croquis::subdivision {

/// One point as weights of old vertices; a vertex may come more than once.
struct WeightedVertex {
  Index vertex;
  double weight;
};
using WeightRow = std::vector<WeightedVertex>;

void append_scaled(WeightRow& row, const WeightRow& other, double factor);

/// Points of chains: Chaikin's 3/4 + 1/4, and their ends.
///
/// Lee, Joo, Hong 2002, figure 11, intersect the line of two new points with the tagged edge: for quads, planar or not,
/// that is exactly (3 V + W)/4, so it is taken for all faces, and a chain depends on its own vertices alone.
class ChainRules {
 public:
  ChainRules(const Neighbourhood& near, const Rules& rules, const FaceMask& mask)
      : near_(near), rules_(rules), mask_(mask) {}

  /// The point of a sharp edge at its end `end`, as NewPoints::chain.
  WeightRow chain_point(Index line, std::size_t end) const;

 private:
  bool stays(Index line, std::size_t end) const;
  bool pinned_dart(Index vertex) const;
  WeightRow smooth_dart(Index line, std::size_t end) const;

  const Neighbourhood& near_;
  const Rules& rules_;
  const FaceMask& mask_;
};

}  // namespace croquis::subdivision
