// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "croquis/operators/subdivide_result.h"
#include "croquis/subdivision/edge_chain.h"
#include "operators/subdivision_plan.h"

namespace croquis {

/// The tagged edges of the cage from which each chain of a level descends, sorted. In Catmull-Clark and Loop, two faces
/// that share several tagged edges count with all of them. Linear time.
/// @param chains of level k of the plan, 0 … its last one
std::vector<std::vector<CageEdge>> chain_origins(const SubdivisionPlan& plan, int k,
                                                 std::span<const subdivision::EdgeChain> chains,
                                                 const subdivision::Cage& cage);

}  // namespace croquis
