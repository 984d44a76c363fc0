// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/render/scene.h"

#include "render/items/item_frame.h"

namespace croquis::render {
namespace {

template <typename Item>
void add_bounds(const std::vector<Shown<Item>>& items, Bounds& bounds) {
  for (const Shown<Item>& shown : items) {
    if (shown.item && !shown.item->bounds.empty()) bounds.add(shown.item->bounds);
  }
}

template <typename Item, typename Vertex>
void add_points(const Item& item, const std::vector<Vertex>& vertices, std::vector<glm::dvec3>& points) {
  for (const Vertex& vertex : vertices) points.push_back(to_model(item, vertex.position));
}

}  // namespace

Bounds bounds_of(const Scene& scene) {
  Bounds bounds;
  add_bounds(scene.meshes, bounds);
  add_bounds(scene.lines, bounds);
  add_bounds(scene.marks, bounds);
  for (const PointItemPtr& points : scene.points) {
    if (points && !points->bounds.empty()) bounds.add(points->bounds);
  }
  return bounds;
}

std::vector<glm::dvec3> points_of(const Scene& scene) {
  std::vector<MeshItemPtr> meshes;
  for (const Shown<MeshItem>& shown : scene.meshes) {
    if (shown.item) meshes.push_back(shown.item);
  }
  std::vector<glm::dvec3> points = points_of(meshes);
  for (const Shown<LineItem>& shown : scene.lines) {
    if (shown.item) add_points(*shown.item, shown.item->corners, points);
  }
  for (const Shown<MarkItem>& shown : scene.marks) {
    if (shown.item) add_points(*shown.item, shown.item->marks, points);
  }
  for (const PointItemPtr& item : scene.points) {
    if (!item) continue;
    for (const glm::vec3& place : item->places) points.push_back(to_model(*item, place));
  }
  return points;
}

}  // namespace croquis::render
