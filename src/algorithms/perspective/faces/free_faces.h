// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "algorithms/perspective/faces/plane_faces.h"
#include "algorithms/perspective/faces/solid_graph.h"
#include "croquis/base/progress.h"

namespace croquis {

struct FreeFaces {
  std::vector<FaceCandidate> candidates;
  bool cut_short = false;  ///< there are more loops than are looked at
};

/// Which loops are looked for: they have a curve at least, or straight edges alone.
enum class FreeFaceKind { WithCurves, AllStraight };

struct FreeFaceSearch {
  FreeFaceKind kind = FreeFaceKind::WithCurves;
  std::size_t max_sides = 8;
  const std::vector<std::uint8_t>* usable = nullptr;  ///< per edge, 1 for those that loops may have; null: all
};

/// Short simple loops that lie in none of the planes.
FreeFaces free_faces(const SolidGraph& graph, const std::vector<EdgePlane>& planes, const FreeFaceSearch& search,
                     Progress& progress);

}  // namespace croquis
