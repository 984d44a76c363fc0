// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/surface/network_paths.h"

#include <algorithm>
#include <cmath>

#include "app/views/render_color.h"
#include "app/window/theme.h"

namespace croquis::app {

glm::dvec3 world_place(const Vec3& place) { return {place.x(), place.y(), place.z()}; }

render::LinePath path_through(const std::vector<Vec3>& places, const Affine3& to_world, bool closed) {
  render::LinePath path;
  path.closed = closed;
  path.points.reserve(places.size());
  for (const Vec3& place : places) path.points.push_back({world_place(to_world(place)), 1, {}});
  return path;
}

render::LinePath curve_path(const AttributeNetwork& network, Index curve, const Affine3& to_world) {
  return path_through(traced_curve(network, curve), to_world);
}

render::Mark place_mark(const Vec3& world, render::MarkShape shape, float size, const QColor& color) {
  render::Mark mark;
  mark.position = world_place(world);
  mark.shape = shape;
  mark.size = size;
  mark.color = to_color(color);
  return mark;
}

render::LineItemPtr lines_of(const std::vector<render::LinePath>& paths, const render::LineStyle& style) {
  return paths.empty() ? nullptr : render::make_line_item(paths, style);
}

render::MarkItemPtr marks_of(const std::vector<render::Mark>& marks) {
  return marks.empty() ? nullptr : render::make_mark_item(marks);
}

render::LineItemPtr ground_lines(const render::Bounds& drawn, const Affine3& to_world) {
  constexpr int squares = 10;         // on either side of the middle
  constexpr double least_size = 200;  // model units: as far as an empty view shows
  constexpr int line_alpha = 60, axis_alpha = 130;
  const double reach = drawn.empty() ? least_size : std::max(glm::length(drawn.max - drawn.min), 1e-6);
  const double step = std::pow(5, std::round(std::log(reach / squares) / std::log(5)));
  std::vector<render::LinePath> lines;
  for (int k = -squares; k <= squares; ++k) {
    const double at = k * step, end = squares * step;
    lines.push_back(path_through({Vec3(at, -end, 0), Vec3(at, end, 0)}, to_world));
    lines.push_back(path_through({Vec3(-end, at, 0), Vec3(end, at, 0)}, to_world));
    for (auto line = lines.end() - 2; k == 0 && line != lines.end(); ++line)
      for (render::LinePoint& point : line->points) point.color = to_color(colors::guide, axis_alpha);
  }
  return lines_of(lines, {1, to_color(colors::guide, line_alpha), {}, render::LineDepth::Tested});
}

Vec3 middle_of(const AttributeNetwork& network, Index curve, const Affine3& to_world) {
  const std::vector<Vec3> places = traced_curve(network, curve, 2);
  return to_world(places.size() == 2 ? Vec3((places[0] + places[1]) / 2) : places[places.size() / 2]);
}

Vec3 middle_of_face(const AttributeNetwork& network, Index face, const Affine3& to_world) {
  Vec3 sum = Vec3::Zero();
  for (const AttributeSide& side : network.faces[face].loop) sum += start_place(network, side);
  const std::size_t corners = network.faces[face].loop.size();
  return to_world(corners == 0 ? sum : Vec3(sum / static_cast<double>(corners)));
}

}  // namespace croquis::app
