// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/object_picker.h"

#include <limits>

namespace croquis::app {

MeshPicker& ObjectPicker::picker_of(const WorkObject& object) {
  Kept& kept = kept_[object.node];
  if (kept.mesh != object.shown()) {
    kept.mesh = object.shown();
    kept.picker = std::make_unique<MeshPicker>(kept.mesh, std::make_shared<const MeshTopology>(*kept.mesh));
  }
  return *kept.picker;
}

std::optional<Vec3> ObjectPicker::place_at(const std::vector<WorkObject>& objects, const ViewFrame& frame,
                                           const Vec2& pixel) {
  std::optional<Vec3> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (const WorkObject& object : objects) {
    if (!object.visible || !object.shown() || object.shown()->face_count() == 0) continue;
    const auto vertex = picker_of(object).at(frame, pixel, ComponentKind::Vertex);
    if (!vertex || vertex->distance >= least) continue;
    least = vertex->distance;
    nearest = vertex->place;
  }
  if (nearest) return nearest;
  const Hit hit = at(objects, frame, pixel);
  return hit.node == 0 ? std::nullopt : std::optional(hit.place);
}

ObjectPicker::Hit ObjectPicker::at(const std::vector<WorkObject>& objects, const ViewFrame& frame, const Vec2& pixel) {
  Hit nearest;
  double distance = std::numeric_limits<double>::infinity();
  const Ray ray = frame.ray(pixel);
  for (const WorkObject& object : objects) {
    if (!object.visible || !object.shown() || object.shown()->face_count() == 0) continue;
    const auto hit = picker_of(object).face_under(ray);
    if (!hit || hit->distance >= distance) continue;
    distance = hit->distance;
    nearest = {object.node, hit->place};
  }
  return nearest;
}

std::vector<NodeId> ObjectPicker::in_box(const std::vector<WorkObject>& objects, const ViewFrame& frame,
                                         const PickBox& box) {
  std::vector<NodeId> found;
  for (const WorkObject& object : objects) {
    if (!object.visible || !object.shown()) continue;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    PickBox seen{Vec2(infinity, infinity), Vec2(-infinity, -infinity)};
    for (const Vec3& place : object.shown()->positions) {
      const auto pixel = frame.project(place);
      if (!pixel) continue;
      seen.low = seen.low.cwiseMin(pixel->pixel);
      seen.high = seen.high.cwiseMax(pixel->pixel);
    }
    const bool touches = (seen.low.array() <= box.high.array()).all() && (seen.high.array() >= box.low.array()).all();
    if (touches) found.push_back(object.node);
  }
  return found;
}

}  // namespace croquis::app
