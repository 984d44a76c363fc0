// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/figure/drawn_cover.h"

#include <algorithm>

#include "croquis/geometry/polyline.h"

namespace croquis::silhouette {
namespace {

double spacing_of(const std::vector<CleanLine>& lines) {
  double longest = 0;
  for (const CleanLine& line : lines) longest = std::max(longest, (line.points[1] - line.points[0]).norm());
  return longest;
}

}  // namespace

int likely_side(const CleanLine& line) { return signed_area(line.points) >= 0 ? 1 : -1; }

DrawnCover::DrawnCover(const std::vector<CleanLine>& lines, const Junctions& junctions)
    : grid_(line_segments(lines), spacing_of(lines)) {
  for (Index line = 0; line < lines.size(); ++line) {
    const bool known = junctions.sides[line] != 0 || !lines[line].closed;
    sides_.push_back(known ? junctions.sides[line] : likely_side(lines[line]));
  }
}

int DrawnCover::missing(const Points& curve) const {
  struct Step {
    double fraction;
    int change;
  };
  int lowest = 0;
  int change = 0;
  std::vector<Step> steps;
  for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
    const Vec2& a = curve[i];
    const Vec2& b = curve[i + 1];
    const Vec2 low = a.cwiseMin(b);
    const Vec2 high = a.cwiseMax(b);
    steps.clear();
    grid_.near_box(low, high, [&](Index k) {
      const GridSegment& s = grid_.segments()[k];
      const bool apart =
          (s.a.cwiseMax(s.b).array() < low.array()).any() || (s.a.cwiseMin(s.b).array() > high.array()).any();
      if (apart || !cross_properly(a, b, s.a, s.b)) return;
      const int to_left = cross(s.b - s.a, b - a) > 0 ? 1 : -1;
      steps.push_back({crossing_fraction(a, b, s.a, s.b), to_left * sides_[s.line]});
    });
    std::sort(steps.begin(), steps.end(), [](const Step& x, const Step& y) { return x.fraction < y.fraction; });
    for (const Step& step : steps) {
      change += step.change;
      lowest = std::min(lowest, change);
    }
  }
  // What has fewer surfaces in front at its last end than at its first one went in between behind an edge that is
  // hidden itself, before it came to where it would lie in the open.
  return std::max(0, std::min(0, change) - lowest);
}

}  // namespace croquis::silhouette
