// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "croquis/geometry/drawing.h"

/// A smooth curve through what the pen did, for display and for the handles that people drag. The samples stay as
/// they were drawn; the fit is made again from them whenever it is needed.
namespace croquis {

/// The four control points of a cubic Bézier curve, sketch units.
using CubicSegment = std::array<Vec2, 4>;

/// The curve's point at t in 0..1.
Vec2 point_at(const CubicSegment& segment, double t);

/// Where two segments meet, or an open stroke ends.
struct StrokeAnchor {
  Vec2 position = Vec2::Zero();  ///< sketch units
  std::size_t sample = 0;        ///< 0-based, of the stroke's samples: strictly increasing over the anchors
  bool corner = false;           ///< the stroke turns sharply here (the ends of an open stroke are no corners)
};

struct FitOptions {
  double units_per_pixel = 1;  ///< > 0; the lengths below are pixels of the view in which the stroke was drawn
  double tolerance = 0.3;      ///< pixels, largest RMS distance of a segment's smoothed samples to it
  int smoothing = 8;           ///< 0..20, passes of fairing against jitter before the fit; corners and ends stay
  double jitter = 0.8;         ///< pixels, the farthest that fairing moves a sample
  double corner_degrees = 50;  ///< 0..180, turns by more than this within `corner_reach` are corners
  double corner_reach = 8;     ///< pixels to either side
};

struct StrokeFit {
  std::vector<StrokeAnchor> anchors;   ///< at least one; of a closed stroke the first is not repeated
  std::vector<CubicSegment> segments;  ///< from each anchor to the next; #anchors when closed, else one less
  bool closed = false;
  double rms = 0;      ///< sketch units, of the smoothed samples' distances to the curve
  double raw_rms = 0;  ///< the same of the samples as drawn: jitter included
  double largest = 0;  ///< largest single distance of a sample as drawn
};

/// Fits a chain of cubics whose tangents agree at every anchor that is no corner: by least squares with chord-length
/// parameters, improved by Newton steps, and split until the tolerance is met, at the worst sample of the middle half
/// (the halving keeps it O(n log n) in the samples). Any number of samples, any repetition; a stroke at one place gives
/// one anchor and no segment.
/// Source: Schneider 1990, "An algorithm for automatically fitting digitized curves", Graphics Gems.
/// @throws Error (E_NO_STROKES) without samples, E_NOT_FINITE for positions that are not finite
StrokeFit fit_stroke(const Stroke& stroke, const FitOptions& options = {});

}  // namespace croquis
