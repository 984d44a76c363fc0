// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "croquis/base/report.h"
#include "croquis/geometry/poly_mesh.h"
#include "croquis/operators/subdivide_result.h"
#include "croquis/subdivision/chain_curve.h"
#include "croquis/subdivision/continuity.h"
#include "croquis/subdivision/edge_chain.h"
#include "operators/subdivision_plan.h"

namespace croquis {

/// Counts of the levels 0 to `last`.
std::vector<LevelCounts> level_counts(const SubdivisionPlan& plan, int last);

/// The tagged edges of the cage from which each chain of a level descends, sorted. In Catmull-Clark and Loop, two faces
/// that share several tagged edges count with all of them. Linear time.
/// @param chains of level k of the plan, 0 … its last one
std::vector<std::vector<CageEdge>> chain_origins(const SubdivisionPlan& plan, int k,
                                                 std::span<const subdivision::EdgeChain> chains,
                                                 const subdivision::Cage& cage);

/// What is known of the chains of a level. Linear time.
/// @param positions #V of the level
/// @param origins   per chain, the edges of the cage
std::vector<SharpChain> sharp_chains(const subdivision::Level& level, std::span<const subdivision::EdgeChain> chains,
                                     std::span<const Vec3> positions, std::span<const std::vector<CageEdge>> origins);

/// The greatest angle at untagged edges of the levels 0 to `last`, radians.
std::vector<double> continuity_angles(const subdivision::ContinuityReport& report, int last);

/// Counts of every level; of a result that was judged, chains with their angles (`dihedral_min`, `dihedral_max`),
/// `continuity` and `verdict`, too. Angles in degrees.
Report to_report(const SubdivideResult& result);

/// The curves as polylines, each an "object" of its own.
/// @param tolerance greatest distance of a chord from its curve, model units, > 0
PolyMesh curve_lines(std::span<const subdivision::ChainCurve> curves, double tolerance);

}  // namespace croquis
