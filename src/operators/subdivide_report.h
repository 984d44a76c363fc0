// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "croquis/base/report.h"
#include "croquis/geometry/poly_mesh.h"
#include "croquis/subdivision/chain_curve.h"
#include "croquis/subdivision/continuity.h"
#include "croquis/subdivision/edge_chain.h"
#include "operators/chain_origins.h"
#include "operators/subdivision_plan.h"

namespace croquis {

/// Counts of the levels 0 to `last`: vertices, edges, faces, boundary_edges, sharp_edges.
Report level_counts(const SubdivisionPlan& plan, int last);

/// What is known of the chains of a level: edges, closed, ends, least and greatest angle (`dihedral_min`,
/// `dihedral_max`, degrees), length, deviation from a plane, the greatest angles on both sides. Linear time.
/// @param positions #V of the level
/// @param origins   per chain, for `cage_edges`
Report chain_list(const subdivision::Level& level, std::span<const subdivision::EdgeChain> chains,
                  std::span<const Vec3> positions, std::span<const std::vector<CageEdge>> origins);

/// The greatest angle at untagged edges of the levels 0 to `last`, in degrees.
Report continuity_list(const subdivision::ContinuityReport& report, int last);

/// The curves as polylines, each an "object" of its own.
/// @param tolerance greatest distance of a chord from its curve, model units, > 0
PolyMesh curve_lines(std::span<const subdivision::ChainCurve> curves, double tolerance);

}  // namespace croquis
