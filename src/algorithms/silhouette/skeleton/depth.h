// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <tuple>
#include <vector>

#include "algorithms/silhouette/skeleton/attachments.h"
#include "algorithms/silhouette/skeleton/skeleton.h"
#include "croquis/base/finding.h"
#include "croquis/base/members.h"
#include "croquis/base/progress.h"
#include "croquis/geometry/drawing.h"
#include "croquis/silhouette/labelled_figure.h"
#include "croquis/silhouette/options.h"
#include "croquis/solver/least_squares.h"

/// The depth problem: an edge from p_i to p_k carries a patch S = a x^2 + b x + c y^2 + d y + e x y + f through the
/// heights and gradients of its ends.
namespace croquis::silhouette {

/// The weights of one object; each is held to 1e-3..1, without which an object could float away or the problem would
/// lose its digits.
struct DepthWeights {
  double curvature = 1;
  double orientation = 0.1;
  double distance = 0.1;
};
constexpr auto members(const DepthWeights& options) {
  return std::tie(options.curvature, options.orientation, options.distance);
}
static_assert(lists_every_member<DepthWeights>);

struct DepthSettings {
  DepthOptions options;
  std::vector<DepthWeights> object_weights;  ///< per object of the figure; empty: the options' weights for all
  Attachments attachments;                   ///< pairs of objects that may sink into one another
  /// Per object of the figure how deep it is against its width, 0.05..4; empty: 1 for all.
  std::vector<double> thickness;

  /// Every object is as hard to move as any other, instead of by its width: where that makes the problem too unequal.
  bool equally_stiff = false;

  double thickness_of(Index object) const { return object < thickness.size() ? thickness[object] : 1; }
};
constexpr auto members(const DepthSettings& options) {
  return std::tie(options.options, options.object_weights, options.attachments, options.thickness,
                  options.equally_stiff);
}
static_assert(lists_every_member<DepthSettings>);

/// An object's own weights or the options', within their range.
DepthWeights depth_weights(const DepthSettings& settings, Index object);

/// A pair of nodes that couldn't be kept apart.
struct DepthCollision {
  Index upper = 0;
  Index lower = 0;
  double shortfall = 0;  ///< sketch units that are missing between them
};

struct DepthResult {
  std::size_t rows = 0;    ///< collision rows of the problem
  int iterations = 0;      ///< the most that one solve took
  int factorisations = 0;  ///< of all solves
  double residual = 0;     ///< largest primal or dual one, relative
  /// Per object, up to the last one with nodes, L: how far a height may still be from the optimum's; infinity where a
  /// solve gave up.
  std::vector<double> uncertainty;
  std::size_t split_chords = 0;  ///< chords that spanned places of opposite order and were split
  std::vector<DepthCollision> collisions;
};

/// Gives the skeleton's nodes heights and gradients: as little curved, tilted and far from the sketch plane as the
/// weights demand, smooth along every edge, and no two chords' circles meeting where one panel lies above another.
/// Cordier, Seo, Cho 2006, section 4.4, eq. 1.
///
/// Parts that no row couples are solved by themselves. Rows that can't hold together (a chord that spans places of
/// opposite order) are tried once more with such chords split at the panels' borders, which adds nodes; what still
/// falls short by more than 0.01 L is listed in the result.
/// @throws Error (E_SOLVER) for weights that aren't finite; Cancelled
DepthResult solve_depth(Skeleton& skeleton, const LabelledFigure& figure, const DepthSettings& settings,
                        Progress& progress);

/// One warning (W_COLLISION) for every place where parts couldn't be separated, with the strokes of both.
Findings depth_findings(const DepthResult& result, const Skeleton& skeleton, const LabelledFigure& figure,
                        const Drawing& drawing);

/// z[upper] - z[lower] >= bound keeps the circles of two chords apart.
struct CollisionRow {
  Index upper = 0;
  Index lower = 0;
  double bound = 0;
  double reach = 0;  ///< of joined objects: so far apart along z the two still sink into one another
};

/// For panels directly above one another, every node whose chord passes through the upper one against every node of the
/// lower one: with R = r_a + r_b + gap and plane distance l < R, z_a - z_b >= sqrt(R^2 - l^2).
/// Cordier, Seo, Cho 2006, section 4.4.1. Ordered by upper, then lower node, each pair once.
///
/// For attached objects R = kappa (r_a + r_b), and the upper one's rim, which is about as high as its axis, lies no
/// deeper than the lower one's front: there it is seen. Sinking into one another isn't transitive: in a figure with
/// attachments all panels of a stack get rows against one another, not only neighbours.
/// Where objects aren't as deep as they are wide, the two circles are ellipses.
std::vector<CollisionRow> collision_rows(const Skeleton& skeleton, const LabelledFigure& figure,
                                         const DepthSettings& settings = {});

/// A linear row of one skeleton edge: the coefficients of (z_i, gx_i, gy_i, z_k, gx_k, gy_k).
using EdgeRow = std::array<double, 6>;

/// A patch through both ends exists: [2 (z_k - z_i) - D.(g_i + g_k)] / l = 0, D = p_k - p_i, l = |D|.
///
/// The left null vector of the 6 by 6 interpolation matrix. Cordier, Seo, Cho 2006, section 4.4.2 print it divided by
/// y_i - y_k, which fails on horizontal edges.
/// @param along D, not zero
EdgeRow continuity_row(const Vec2& along);

/// Thin-plate energy of the patch over an area L l, least over the one coefficient that the ends leave free (curl
/// across the edge): the squares of the two rows, for D_f = 2.
/// Cordier, Seo, Cho 2006, section 4.4.3, in closed form:
/// E = L/l [(1 - nu^2) (t.(g_k - g_i))^2 + 2 (1 - nu) (m.(g_k - g_i))^2], t = D/l, m = t turned left.
/// The area L l in place of the paper's l^2 makes the energy independent of the number of nodes.
/// @param along D, not zero
/// @param scale L
/// @param poisson nu, 0..0.5
std::array<EdgeRow, 2> curvature_rows(const Vec2& along, double scale, double poisson = 0.5);

/// Nodes that edges and collision rows connect, directly or not: they can be solved without the others.
struct DepthPart {
  std::vector<Index> nodes;  ///< ascending
  std::vector<Index> edges;  ///< indices into Skeleton::edges
  std::vector<Index> rows;   ///< indices into the collision rows

  /// The place of a node among its nodes.
  Index local(Index node) const;
};

/// In the order of their first nodes.
std::vector<DepthPart> depth_parts(const Skeleton& skeleton, std::span<const CollisionRow> rows);

/// A part's least-squares problem; objects are pulled to Skeleton::rest, or to the sketch plane. Unknowns
/// (z/L, gx, gy) per node of the part: all lengths are measured in L, so that a drawing and its enlargement give the
/// same numbers.
/// @param rows of all parts
LeastSquaresProblem depth_problem(const Skeleton& skeleton, const DepthPart& part, std::span<const CollisionRow> rows,
                                  const DepthSettings& settings);

}  // namespace croquis::silhouette
