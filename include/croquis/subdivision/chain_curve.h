// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "croquis/subdivision/doo_sabin.h"
#include "croquis/subdivision/edge_chain.h"
#include "croquis/subdivision/uniform_schemes.h"

namespace croquis::subdivision {

/// A B-spline curve.
struct ChainCurve {
  int degree = 2;
  std::vector<Vec3> control_points;  ///< #P
  std::vector<double> knots;         ///< #P + degree + 1, ascending; the curve lives on [knots[degree], knots[#P]]
  bool closed = false;               ///< ends where it begins, smoothly
  bool exact = true;                 ///< is the limit of the chain to rounding; else ends are near it only
};

/// The limit of a chain under Doo-Sabin: the uniform quadratic B-spline of its vertices (Chaikin 1974; Riesenfeld
/// 1975).
///
/// At corners it is clamped. At ends within the surface it begins in the middle of the first edge, where `retract`
/// draws it; smooth ends go on into the surface by less than half an edge, which no curve of the chain's own vertices
/// can decide: `exact` is false then, and for corners of the plain profile (Preset::Paper), which no B-spline with
/// finitely many pieces follows. Deeper levels halve the difference. Edges of finite sharpness are taken as infinite.
/// @param positions #V of the level the chain was found in, which is refined without bands (DooSabinPlan::banded)
ChainCurve doo_sabin_curve(const EdgeChain& chain, std::span<const Vec3> positions, const Rules& rules);

/// The same under Catmull-Clark and Loop: the uniform cubic B-spline, at corners with zero second derivative (Biermann,
/// Levin, Zorin 2000, section 2). Ends within the surface keep their place but for their last edge, where it is near
/// only.
ChainCurve cubic_curve(const EdgeChain& chain, std::span<const Vec3> positions);

/// The limit curves of all chains that stay sharp, read off the first level that gives them exactly or, where none
/// does, off the last one.
/// @param buffers of DooSabinPlan::positions
std::vector<ChainCurve> limit_curves(const DooSabinPlan& plan, const PositionBuffers& buffers, const Rules& rules);
std::vector<ChainCurve> limit_curves(const UniformPlan& plan, const PositionBuffers& buffers);

/// A point of the curve; de Boor's algorithm.
/// @param parameter in the curve's interval
Vec3 point_at(const ChainCurve& curve, double parameter);

/// Points on the curve, both ends included (the first point comes again at the end of a closed curve), so that chords
/// are nowhere further from the curve than the tolerance; at most 256 per piece.
/// @param tolerance model units, > 0
std::vector<Vec3> sampled(const ChainCurve& curve, double tolerance);

}  // namespace croquis::subdivision
