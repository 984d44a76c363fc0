// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/sketches/sketch_layers.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "croquis/geometry/polyline.h"

namespace croquis::test {
namespace {

bool shows(const LayeredPart& part, const std::vector<LayeredPart>& parts) {
  return std::any_of(part.outline.begin(), part.outline.end(), [&](const Vec2& place) {
    return std::none_of(parts.begin(), parts.end(), [&](const LayeredPart& other) {
      return other.priority > part.priority && winding(other.outline, place) != 0;
    });
  });
}

}  // namespace

Sketch layered_sketch(std::vector<LayeredPart> parts) {
  std::vector<TrueContour> contours;
  for (LayeredPart& part : parts) {
    if (signed_area(part.outline) < 0) std::reverse(part.outline.begin(), part.outline.end());
    if (!shows(part, parts)) throw std::invalid_argument("a part of the sketch is covered completely");
    TrueContour contour;
    contour.component = static_cast<int>(contours.size());
    contour.height.assign(part.outline.size(), part.priority);
    contour.points = part.outline;
    contours.push_back(std::move(contour));
  }
  std::vector<int> euler(contours.size(), 1);
  return draw_visible(std::move(contours), std::move(euler));
}

std::vector<Vec2> circle_outline(const Vec2& centre, double radius, double spacing) {
  const int count = std::max(12, static_cast<int>(2 * std::numbers::pi * radius / spacing));
  std::vector<Vec2> outline;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.31) / count;  // no sample on an axis of symmetry
    outline.emplace_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return outline;
}

}  // namespace croquis::test
