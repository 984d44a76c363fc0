// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/silhouette/stroke_pick.h"

#include <algorithm>
#include <utility>

#include "croquis/geometry/polyline.h"
#include "tools/pointer/segment_distance.h"

namespace croquis {
namespace {

bool meets_box(const Stroke& stroke, const PickBox& box) {
  for (std::size_t i = 0; i < segment_count(stroke); ++i) {
    if (meets_box(segment_begin(stroke, i), segment_end(stroke, i), box)) return true;
  }
  return false;
}

}  // namespace

std::optional<PickedStroke> nearest_place(const Stroke& stroke, const Vec2& place, const PickReach& reach) {
  std::optional<PickedStroke> best;
  double limit = reach.units();
  for (std::size_t i = 0; i < segment_count(stroke); ++i) {
    const Vec2& begin = segment_begin(stroke, i);
    const Vec2& end = segment_end(stroke, i);
    const double t = nearest_parameter(place, begin, end);
    const Vec2 foot = begin + t * (end - begin);
    const double distance = (foot - place).norm();
    if (distance > limit || (best && distance == limit)) continue;
    best = {stroke.id, i, t, foot, distance};
    limit = distance;
  }
  return best;
}

std::optional<PickedStroke> nearest_stroke(const Drawing& drawing, const Vec2& place, const PickReach& reach) {
  std::optional<PickedStroke> best;
  for (const Stroke& stroke : drawing.strokes) {
    std::optional<PickedStroke> picked = nearest_place(stroke, place, reach);
    if (picked && (!best || picked->distance <= best->distance)) best = std::move(picked);
  }
  return best;
}

std::optional<std::size_t> nearest_anchor(std::span<const StrokeAnchor> anchors, const Vec2& place,
                                          const PickReach& reach) {
  std::optional<std::size_t> best;
  double limit = reach.units();
  for (std::size_t k = 0; k < anchors.size(); ++k) {
    const double distance = (anchors[k].position - place).norm();
    if (distance > limit || (best && distance == limit)) continue;
    best = k;
    limit = distance;
  }
  return best;
}

std::vector<std::string> strokes_in_box(const Drawing& drawing, const PickBox& box) {
  std::vector<std::string> ids;
  for (const Stroke& stroke : drawing.strokes) {
    if (meets_box(stroke, box)) ids.push_back(stroke.id);
  }
  return ids;
}

}  // namespace croquis
