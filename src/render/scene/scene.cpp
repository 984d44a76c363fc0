// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/render/scene.h"

#include "croquis/render/render_options.h"
#include "render/items/item_frame.h"

namespace croquis::render {
namespace {

template <typename Item>
void add_bounds(const std::vector<Shown<Item>>& items, Bounds& bounds) {
  for (const Shown<Item>& shown : items) {
    if (const Bounds box = bounds_of(shown); !box.empty()) bounds.add(box);
  }
}

template <typename Item, typename Vertex>
void add_points(const Shown<Item>& shown, const std::vector<Vertex>& vertices, std::vector<glm::dvec3>& points) {
  for (const Vertex& vertex : vertices) {
    points.push_back(glm::dvec3(shown.placement * glm::dvec4(to_model(*shown.item, vertex.position), 1)));
  }
}

}  // namespace

Bounds bounds_of(const Scene& scene) {
  Bounds bounds;
  add_bounds(scene.meshes, bounds);
  add_bounds(scene.lines, bounds);
  add_bounds(scene.marks, bounds);
  add_bounds(scene.points, bounds);
  return bounds;
}

std::vector<glm::dvec3> points_of(const Scene& scene) {
  std::vector<glm::dvec3> points;
  for (const Shown<MeshItem>& shown : scene.meshes) {
    if (!shown.item) continue;
    for (const glm::dvec3& point : points_of(std::vector<MeshItemPtr>{shown.item}))
      points.push_back(glm::dvec3(shown.placement * glm::dvec4(point, 1)));
  }
  for (const Shown<LineItem>& shown : scene.lines) {
    if (shown.item) add_points(shown, shown.item->corners, points);
  }
  for (const Shown<MarkItem>& shown : scene.marks) {
    if (shown.item) add_points(shown, shown.item->marks, points);
  }
  for (const Shown<PointItem>& shown : scene.points) {
    if (!shown.item) continue;
    for (const glm::vec3& place : shown.item->places)
      points.push_back(glm::dvec3(shown.placement * glm::dvec4(to_model(*shown.item, place), 1)));
  }
  return points;
}

RenderOptions RenderOptions::interactive() {
  RenderOptions options;
  options.supersampling = 1;
  options.occlusion = false;
  return options;
}

RenderOptions RenderOptions::paper() {
  RenderOptions options;
  options.background_top = options.background_bottom = {252, 251, 248, 255};
  options.grid.kind = GridKind::Dots;
  return options;
}

}  // namespace croquis::render
