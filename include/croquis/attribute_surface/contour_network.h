// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <numbers>

#include "croquis/base/finding.h"
#include "croquis/base/progress.h"
#include "croquis/geometry/attribute_network.h"
#include "croquis/geometry/drawing.h"

namespace croquis {

struct ContourNetworkOptions {
  double tolerance = 0.002;  ///< × the drawing's diagonal, > 0: how far curves may be from their strokes
  double join = 0.01;        ///< × the drawing's diagonal, >= 0: ends so near to each other, or to a stroke, meet
  double corner = 40 * std::numbers::pi / 180;  ///< radians, 0..pi: strokes that turn more have a corner there
};

struct ContourNetwork {
  AttributeNetwork network;
  Findings warnings;  ///< STROKE_LEFT_OUT, for each stroke that is no longer than the tolerance
};

/// The strokes of a drawing as curves of an attribute network, on the drawing's plane; it has no faces yet.
///
/// Strokes are cut at corners; those that come back to where they began, without being cut elsewhere, into 4 equal
/// parts. Ends that meet share a node, which is at the corner where they meet one, at the place on the stroke where
/// they meet that one away from its ends (it is cut there), or in their middle; strokes are moved by what their ends
/// move, less and less towards the other end. Curves are called as their strokes, parts of strokes "ID/1", "ID/2" ….
/// About linear in the samples, but for ends that meet nothing, each of which looks at all samples.
/// @param drawing finite, with an orthonormal plane
/// @throws Error (E_NO_STROKES) for a drawing of which nothing is left
/// @throws Cancelled
ContourNetwork network_of_contours(const Drawing& drawing, const ContourNetworkOptions& options, Progress& progress);

}  // namespace croquis
