// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "algorithms/silhouette/strokes/polyline.h"
#include "croquis/base/finding.h"

namespace croquis::silhouette {

/// One drawn line: a stroke, or several whose gaps were joined. A cleaned copy; the strokes stay as they are.
struct CleanLine {
  Points points;               ///< smoothed samples, about a step apart
  std::vector<Index> stroke;   ///< per point: index into Drawing::strokes
  std::vector<Index> strokes;  ///< in the order along the line
  Points raw;                  ///< per point: where it was before it was smoothed
  std::string object;          ///< name of the object it was forced into, empty for none
  bool closed = false;
  bool bridged = false;  ///< closed over a gap that is more than what hands miss by
  bool tube = false;     ///< the outline of limbs that were drawn as one line
  bool led = false;      ///< into a line that it lay beside
  double size = 0;       ///< see `size_of`

  /// Out of what it crosses.
  bool grows() const { return tube || led; }
  Index segment_count() const { return static_cast<Index>(closed ? points.size() : points.size() - 1); }
  const Vec2& end(bool at_start) const { return at_start ? points.front() : points.back(); }
  Index end_stroke(bool at_start) const { return at_start ? stroke.front() : stroke.back(); }

  void reverse() {
    std::ranges::reverse(points);
    std::ranges::reverse(stroke);
    std::ranges::reverse(raw);
  }

  /// Drops all samples but those from `first` to before `last`.
  void keep(Index first, Index last) {
    points = {points.begin() + first, points.begin() + last};
    stroke = {stroke.begin() + first, stroke.begin() + last};
    if (!raw.empty()) raw = {raw.begin() + first, raw.begin() + last};
  }
};

/// Something wrong with certain lines: their part of the drawing can't be labelled, others can.
struct LineFinding {
  Finding finding;
  std::vector<Index> lines;
};

using LineFindings = std::vector<LineFinding>;

/// The lengths of the drawing stage in sketch units.
struct DrawingScale {
  double unit = 1;  ///< u
  double step = 6;
  double tiny = 12;
  double close = 8;
  double gap = 18;
  double snap = 10;
  double close_share = 0;  ///< of a stroke's length
  double aside_share = 0;  ///< of a stroke's length
  double reach_share = 0;  ///< of a line's size
  double jitter = 0;       ///< see `jitter_of`; 0 where tolerances don't go by size

  /// How far an end may miss a line when the larger of the two has this size.
  double reach(double size) const { return std::max(snap, reach_share * size); }

  /// How far two lines, the smaller of this size, may come beyond one another without being meant to cross: some u, and
  /// a share of the size where the hand was as unsteady as can be.
  double shallow(double size) const { return std::max(2 * unit, 0.05 * jitter * size); }
};

}  // namespace croquis::silhouette
