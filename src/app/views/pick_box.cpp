// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/pick_box.h"

#include "app/views/render_color.h"
#include "app/window/theme.h"

namespace croquis::app {

void add_box(const PickBox& box, const ViewFrame& frame, render::Scene& scene) {
  // Between the planes near and far, where nothing cuts it off.
  constexpr double depth = -0.5;
  render::LinePath path;
  path.closed = true;
  const std::vector<Vec2> corners{box.low, {box.high.x(), box.low.y()}, box.high, {box.low.x(), box.high.y()}};
  for (const Vec2& corner : corners) {
    const Vec3 place = frame.unproject(corner, depth);
    path.points.push_back({glm::dvec3(place.x(), place.y(), place.z()), 1, {}});
  }
  scene.lines.emplace_back(
      render::make_line_item(path, {1, to_color(colors::accent), {4, 3, 0, 0}, render::LineDepth::OnTop}));
}

}  // namespace croquis::app
