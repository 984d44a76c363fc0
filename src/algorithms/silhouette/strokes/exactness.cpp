// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/strokes/exactness.h"

#include <algorithm>
#include <cmath>

#include "algorithms/silhouette/strokes/segment_grid.h"
#include "croquis/geometry/polyline.h"

namespace croquis::silhouette {
namespace {

// Programs round places to a pixel of a thousand; of hands that miss by 2 % one end in twenty is so near.
constexpr double exact_miss = 1;  // u
constexpr double most_exact = 0.9;
// The part of the own stroke that an end doesn't lie on.
constexpr double own_part = 40;  // u
// Curves have less jitter, in steps, but for so many of their samples, which lie beside corners. Polylines of few
// points have corners everywhere.
constexpr double smooth_jitter = 0.01;
constexpr double samples_at_corners = 0.2;

}  // namespace

bool are_ends_exact(const std::vector<SampledStroke>& strokes, const DrawingScale& scale) {
  const double reach = exact_miss * scale.unit;
  const SegmentGrid grid(stroke_segments(strokes), scale.step, reach);
  const double spacing = scale.step / 2;
  int ends = 0, exact = 0;
  for (Index s = 0; s < strokes.size(); ++s) {
    const Points& points = strokes[s].points;
    if (strokes[s].closed) continue;
    for (const bool at_start : {true, false}) {
      const Vec2& place = at_start ? points.front() : points.back();
      const Vec2 around = Vec2::Constant(reach);
      bool touches = false;
      grid.near_box(place - around, place + around, [&](Index i) {
        const GridSegment& segment = grid.segments()[i];
        const auto last = static_cast<double>(points.size() - 2);
        const double from_end = spacing * (at_start ? segment.position : last - segment.position);
        if (segment.line == s && from_end < own_part * scale.unit) return;
        const double t = nearest_parameter(place, segment.a, segment.b);
        touches = touches || (segment.a + t * (segment.b - segment.a) - place).norm() <= reach;
      });
      ++ends;
      exact += touches ? 1 : 0;
    }
  }
  return ends > 0 && exact >= most_exact * ends;
}

bool are_smooth(const std::vector<SampledStroke>& strokes, const DrawingScale& scale) {
  std::vector<double> sizes;  // of the fourth differences of samples a step apart: cubic curves have none
  for (const SampledStroke& stroke : strokes) {
    const Points& p = stroke.points;
    for (std::size_t i = 8; i < p.size(); i += 2) {
      sizes.push_back((p[i - 8] - 4 * (p[i - 6] + p[i - 2]) + 6 * p[i - 4] + p[i]).norm() / 6);
    }
  }
  if (sizes.empty()) return true;
  const auto place = (1 - samples_at_corners) * static_cast<double>(sizes.size());
  const auto jitter = sizes.begin() + static_cast<std::ptrdiff_t>(place);
  std::ranges::nth_element(sizes, jitter);
  return *jitter < smooth_jitter * scale.step;
}

}  // namespace croquis::silhouette
