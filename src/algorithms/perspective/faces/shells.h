// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/perspective/faces/face_candidate.h"
#include "algorithms/perspective/faces/solid_graph.h"
#include "croquis/perspective/face_finding.h"

namespace croquis {

/// The faces of a choice, turned outwards and put together to shells; shells inside others bound voids.
FaceSet make_shells(const SolidGraph& graph, const std::vector<FaceCandidate>& candidates,
                    const std::vector<Index>& chosen, double cost);

/// How many regions of planes lie inside the solid and were not chosen.
std::size_t count_internal(const SolidGraph& graph, const std::vector<FaceCandidate>& candidates,
                           const std::vector<Index>& chosen);

}  // namespace croquis
