// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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
  /// Above so many collision rows, rows are added as they are needed. The result is the same.
  std::size_t lazy_rows = 20000;
  Attachments attachments;  ///< pairs of objects that may sink into one another
  /// Per object of the figure how deep it is against its width, 0.05..4; empty: 1 for all.
  std::vector<double> thickness;

  /// Every object is as hard to move as any other, instead of by its width: where that makes the problem too unequal.
  bool equally_stiff = false;

  double thickness_of(Index object) const { return object < thickness.size() ? thickness[object] : 1; }
};
constexpr auto members(const DepthSettings& options) {
  return std::tie(options.options, options.object_weights, options.lazy_rows, options.attachments, options.thickness,
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
  std::size_t rows = 0;       ///< collision rows of the problem
  std::size_t rows_used = 0;  ///< of them, handed to the solver
  int rounds = 0;             ///< solves of the part that took most; more than one when rows are added lazily
  int iterations = 0;         ///< the most that one solve took
  int factorisations = 0;     ///< of all solves
  double residual = 0;        ///< largest primal or dual one, relative
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

}  // namespace croquis::silhouette
