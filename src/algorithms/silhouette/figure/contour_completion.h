// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "algorithms/silhouette/strokes/visible_crossings.h"
#include "croquis/geometry/segment_grid.h"
#include "croquis/silhouette/options.h"

/// Candidates for hidden contours and what each costs (Cordier, Seo, Cho 2006, section 3; Williams 1994).
namespace croquis::silhouette {

/// Control points of a cubic Bezier curve.
using Cubic = std::array<Vec2, 4>;

/// The cubic that leaves two places along their outward tangents: straight ends give handles of a third of the
/// distance, a U-turn two thirds, which is a half circle to 1 %.
Cubic completion_curve(const Vec2& a, const Vec2& tangent_a, const Vec2& b, const Vec2& tangent_b);

/// How a hidden piece of contour may run between its ends, besides the plain curve.
struct CompletionShape {
  double handles = 1;        ///< those of the plain curve are longer or shorter by this factor
  double reach = 0;          ///< both ends go straight on first, by so many handles of the plain curve
  bool kept_behind = false;  ///< it stays behind the line that both of its ends pass behind
};

/// In the order in which they are tried: round, flatter, wider, deeper, nearly straight; then the plain curve, kept
/// behind its bar.
inline constexpr std::array<CompletionShape, 9> completion_shapes{
    {{1, 0}, {0.7, 0}, {0.4, 0}, {1.4, 0}, {1, 0.75}, {1, 1.5}, {1, 2.5}, {0.15, 0}, {1, 0, true}}};
inline constexpr std::uint8_t kept_behind_shape = completion_shapes.size() - 1;

/// The curve in a shape, as a polyline of so many pieces for its bent part; it isn't kept behind anything.
Points completion_chords(const Cubic& curve, const CompletionShape& shape, int pieces);

/// The curve in a shape, evenly sampled, both ends included.
/// @param bar what it is kept behind, with its surface on the left (+1) or right (-1)
/// O(#P) samples of the curve, each by all of the bar where it is kept behind that.
Points completion_points(const Cubic& curve, const CompletionShape& shape, double spacing, const CleanLine& bar,
                         int bar_side);

/// The angle (radians) by which a polyline turns to the left, all in all; a closed one turns by 2 pi times its turning
/// number.
/// @param points at least two
double turning_of(std::span<const Vec2> points, bool closed);

/// A hidden piece of contour that might join two ends. Its costs are dimensionless.
struct CompletionCandidate {
  Index a = 0;  ///< indices of ends, a < b
  Index b = 0;
  Index given = no_index;  ///< index into Junctions::given: then that piece counts instead of the curve, at no cost
  Cubic curve{Vec2::Zero(), Vec2::Zero(), Vec2::Zero(), Vec2::Zero()};  ///< from a to b, leaves both straight
  std::vector<std::uint8_t> shapes{0, 1, 2, 3, 4, 5, 6, 7};             ///< completion_shapes, the likeliest first

  double shape_cost = 0;                                  ///< of its length, bending, and lines on opposite sides
  double most = std::numeric_limits<double>::infinity();  ///< no more than that, for it closes a limb
  double strip = 1;                                       ///< factor of a side of a strip, see favour_strips
  double open = 0;                                        ///< of the surfaces that are missing in front of it

  double cost() const;
};

/// length / reference + weight * distance * integral of curvature², both free of scale: a half circle costs the same
/// bending at any size (Williams 1994 uses the two terms with dimensions, which favours long straight joins).
/// Bending away from the surface counts more: the hidden end of a limb is a cap, seldom the crotch between two limbs.
/// @param side where the surface lies along the curve: left (+1), right (-1), not known (0)
double completion_cost(const Cubic& curve, int side, double reference_length, const CompletionOptions& options);

/// All pairs of the given ends that may be joined: the surface lies on the same side of both lines as far as that is
/// known, neither is forced into another object, and the cost stays below the maximum. Ends that a known piece joins
/// have that one candidate.
/// @param lines carried on behind their bars
/// @param ends  subset of junctions.ends, as indices; candidates hold positions in this list
/// O(n² + l² #P) for n ends of l open lines, and O(N²) for all N ends of the drawing.
std::vector<CompletionCandidate> completion_candidates(const std::vector<CleanLine>& lines, const Junctions& junctions,
                                                       const std::vector<Index>& ends,
                                                       const CompletionOptions& options);

/// How many surfaces are missing in front of a hidden piece of contour where it lies in the open; 0 if it is covered
/// all along. Judged by what is drawn alone, before anything is labelled: that has nothing in front; so a hidden piece
/// passes behind every line that it crosses, and one surface more or less is in front of it from there on. Behind its
/// bar it starts with one. Near O(#P).
/// @param sides of the drawn lines: their surfaces lie on the left (+1) or right (-1), 0 where that isn't known
/// @param piece from one place behind a bar to another
int missing_surfaces(const SegmentGrid& drawn, const std::vector<int>& sides, const Points& piece);

}  // namespace croquis::silhouette
