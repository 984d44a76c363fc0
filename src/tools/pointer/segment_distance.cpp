// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/pointer/segment_distance.h"

#include <algorithm>

#include "croquis/geometry/polyline.h"
#include "croquis/geometry/predicates.h"

namespace croquis {

double segment_distance(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  if (segments_cross(a, b, c, d)) return 0;
  return std::min({(nearest_on_segment(a, c, d) - a).norm(), (nearest_on_segment(b, c, d) - b).norm(),
                   (nearest_on_segment(c, a, b) - c).norm(), (nearest_on_segment(d, a, b) - d).norm()});
}

std::size_t segment_count(const Stroke& stroke) {
  const std::size_t count = stroke.samples.size();
  return count < 2 || stroke.closed ? count : count - 1;
}

const Vec2& segment_begin(const Stroke& stroke, std::size_t segment) { return stroke.samples[segment].position; }

const Vec2& segment_end(const Stroke& stroke, std::size_t segment) {
  return stroke.samples[segment + 1 == stroke.samples.size() ? 0 : segment + 1].position;
}

std::optional<std::pair<double, double>> part_in_box(const Vec2& a, const Vec2& b, const PickBox& box) {
  double enter = 0;
  double leave = 1;
  for (int axis = 0; axis < 2; ++axis) {
    const double step = b[axis] - a[axis];
    if (step == 0) {
      if (a[axis] < box.low[axis] || a[axis] > box.high[axis]) return std::nullopt;
      continue;
    }
    const double at_low = (box.low[axis] - a[axis]) / step;
    const double at_high = (box.high[axis] - a[axis]) / step;
    enter = std::max(enter, std::min(at_low, at_high));
    leave = std::min(leave, std::max(at_low, at_high));
  }
  if (enter > leave) return std::nullopt;
  return std::pair(enter, leave);
}

}  // namespace croquis
