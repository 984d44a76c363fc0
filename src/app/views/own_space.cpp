// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/own_space.h"

#include "app/tools/scene_parts.h"
#include "app/views/render_color.h"
#include "app/window/theme.h"

namespace croquis::app {

glm::dmat4 matrix_of(const Affine3& map) {
  glm::dmat4 matrix(1);
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) matrix[column][row] = map.linear(row, column);
    matrix[3][column] = map.offset(column);
  }
  return matrix;
}

ViewFrame seen_from(const ViewFrame& frame, const Affine3& to_model) {
  if (to_model.is_identity()) return frame;
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.topLeftCorner<3, 3>() = to_model.linear;
  matrix.topRightCorner<3, 1>() = to_model.offset;
  return ViewFrame::of(frame.to_clip * matrix, frame.size);
}

PlacedPart::PlacedPart(render::Scene& scene, const Affine3& to_model)
    : scene_(scene),
      placement_(matrix_of(to_model)),
      before_{scene.meshes.size(), scene.lines.size(), scene.marks.size(), scene.points.size()} {}

PlacedPart::~PlacedPart() {
  const auto place = [&](auto& items, std::size_t before) {
    for (std::size_t i = before; i < items.size(); ++i) items[i].placement = placement_ * items[i].placement;
  };
  place(scene_.meshes, before_[0]);
  place(scene_.lines, before_[1]);
  place(scene_.marks, before_[2]);
  place(scene_.points, before_[3]);
}

void add_box(const PickBox& box, const ViewFrame& frame, render::Scene& scene) {
  // Between the planes near and far, where nothing cuts it off.
  constexpr double depth = -0.5;
  const auto place = [&](const Vec2& corner) { return to_glm(frame.unproject(corner, depth)); };
  const render::LinePath path = path_of(corners_of_box(box.low, box.high), place, true);
  scene.lines.emplace_back(render::make_line_item(path, {1, to_color(colors::accent), {4, 3, 0, 0}}));
}

}  // namespace croquis::app
