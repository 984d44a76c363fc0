// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/perspective/perspective_ink.h"

#include <cmath>
#include <numbers>

#include "croquis/geometry/polyline.h"
#include "croquis/tools/perspective/stroke_shape.h"

namespace croquis::test {

std::vector<Vec2> hand_drawn(const std::vector<PictureCubic>& pieces, Random& random, double miss) {
  const std::vector<Vec2> line = traced(pieces, false, 64);
  const double total = length(line, false);
  const auto off = [&] {
    const double angle = random.between(0, 2 * std::numbers::pi);
    return Vec2(miss * Vec2(std::cos(angle), std::sin(angle)));
  };
  const Vec2 start = off(), end = off();
  const double phase = random.between(0, 6), wave = random.between(0.2, 1.0);
  std::vector<Vec2> places;
  double along = 0, next = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (i > 0) along += (line[i] - line[i - 1]).norm();
    if (along < next && i + 1 < line.size()) continue;
    next = along + 2;
    const double t = along / total;
    const Vec2 waver(wave * std::sin(phase + 5 * t), wave * std::cos(phase + 4 * t));
    const Vec2 tremor(random.between(-0.3, 0.3), random.between(-0.3, 0.3));
    places.push_back(line[i] + (1 - t) * start + t * end + waver + tremor);
  }
  return places;
}

SolvedDrawing truth_of(const SolidDrawing& drawn, std::vector<std::string> open) {
  SolvedDrawing solved;
  solved.camera = drawn.camera;
  for (int axis = 0; axis < 3; ++axis)
    solved.vanishing_points[static_cast<std::size_t>(axis)] = drawn.camera.vanishing_point(axis);
  solved.network = drawn.network;
  solved.open_strokes = std::move(open);
  return solved;
}

SolidDrawing plain_drawing(const PerspectiveSolid& solid, const View& view) {
  SolidDrawingOptions options;
  options.vertex_ids = false;
  options.known = false;
  return drawn(solid, view, options);
}

}  // namespace croquis::test
