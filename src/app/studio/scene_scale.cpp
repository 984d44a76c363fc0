// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/scene_scale.h"

#include <cmath>
#include <utility>

#include "croquis/base/error.h"

namespace croquis::app {
namespace {

constexpr double far_off = 10;  // times larger or smaller

/// "300" or "12.5": as many figures as are worth reading.
QString times(double factor) { return QString::number(factor, 'f', factor < 100 ? 1 : 0); }

}  // namespace

SceneScale::Box SceneScale::box_of(const WorkObject& object) const {
  const BoundingBox box = studio_.bounds(object);
  return box ? Box((*box)[0], (*box)[1]) : Box();
}

SceneScale::Box SceneScale::box_of_rest(const WorkObject& object) const {
  Box rest;
  for (const WorkObject& other : studio_.objects()) {
    const bool is_seen = other.node != object.node && other.visible && other.shown();
    if (is_seen) rest.extend(box_of(other));
  }
  for (const Stroke& stroke : studio_.drawing().strokes) {
    for (const StrokeSample& sample : stroke.samples) rest.extend(Vec3(sample.position.x(), sample.position.y(), 0));
  }
  return rest;
}

std::optional<double> SceneScale::factor() const {
  const WorkObject* object = studio_.active();
  if (object == nullptr || !object->visible || !object->begins_with_mesh) return std::nullopt;
  const Box rest = box_of_rest(*object);
  const Box own = box_of(*object);
  if (rest.isEmpty() || own.isEmpty()) return std::nullopt;
  const double factor = rest.diagonal().norm() / own.diagonal().norm();
  if (!std::isnormal(factor)) return std::nullopt;
  return factor;
}

bool SceneScale::is_far_off() const {
  const auto by = factor();
  return by && (*by >= far_off || *by <= 1 / far_off);
}

QString SceneScale::sentence() const {
  const auto by = factor();
  if (!by || !is_far_off()) return {};
  const QString name = QString::fromStdString(studio_.active()->name);
  return *by > 1 ? QObject::tr("%1 is %2 times smaller than the rest").arg(name, times(*by))
                 : QObject::tr("%1 is %2 times larger than the rest").arg(name, times(1 / *by));
}

void SceneScale::apply() {
  const auto by = factor();
  if (!by) {
    throw Error(make_error(Category::Usage, "E_EMPTY",
                           "There is nothing to scale to: select a mesh while another object is visible"));
  }
  const WorkObject object = *studio_.active();
  const Box rest = box_of_rest(object);
  const Vec3 middle = box_of(object).center();
  const Vec3 goal = rest.contains(middle) ? middle : Vec3(rest.center());
  const Affine3 map{*by * Eigen::Matrix3d::Identity(), goal - *by * middle};
  studio_.session().edit(
      "Scale " + object.name + " to the scene",
      studio_.with_objects_placed(studio_.session().document(), {{object.node, moved(object.placement, map)}}));
}

}  // namespace croquis::app
