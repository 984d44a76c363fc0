// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/object_picker.h"

#include <limits>

#include "app/views/own_space.h"

namespace croquis::app {

MeshPicker* MeshPickers::known(const WorkObject& object) const {
  const auto kept = kept_.find(object.node);
  return kept != kept_.end() && kept->second.mesh == object.shown() ? kept->second.picker.get() : nullptr;
}

MeshPicker& MeshPickers::of(const WorkObject& object) {
  if (MeshPicker* picker = known(object)) return *picker;
  Kept& kept = kept_[object.node];
  kept = {object.shown(), std::make_unique<MeshPicker>(object.shown())};
  return *kept.picker;
}

std::optional<Vec3> ObjectPicker::place_at(const std::vector<WorkObject>& objects, const ViewFrame& frame,
                                           const Vec2& pixel) {
  std::optional<Vec3> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (const WorkObject& object : objects) {
    if (!object.visible || !object.shown() || object.shown()->face_count() == 0) continue;
    const Affine3 to_model = object.placement.map();
    const auto vertex = pickers_.of(object).at(seen_from(frame, to_model), pixel, ComponentKind::Vertex);
    if (!vertex || vertex->distance >= least) continue;
    least = vertex->distance;
    nearest = to_model(vertex->place);
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
    const Affine3 to_model = object.placement.map();
    const Ray own_ray = seen_from(frame, to_model).ray(pixel);
    MeshPicker* picker = pickers_.known(object);
    const auto hit = picker != nullptr ? picker->face_under(own_ray) : face_under(*object.shown(), own_ray);
    const Vec3 place = hit ? to_model(hit->place) : Vec3();
    if (!hit || (place - ray.origin).norm() >= distance) continue;
    distance = (place - ray.origin).norm();
    nearest = {object.node, place};
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
    const ViewFrame own = seen_from(frame, object.placement.map());
    for (const Vec3& place : object.shown()->positions) {
      const auto pixel = own.project(place);
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
