// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "algorithms/perspective/faces/face_candidate.h"
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

/// Short simple loops that lie in none of the planes.
FreeFaces free_faces(const SolidGraph& graph, const std::vector<EdgePlane>& planes, FreeFaceKind kind,
                     std::size_t max_sides, Progress& progress);

}  // namespace croquis
