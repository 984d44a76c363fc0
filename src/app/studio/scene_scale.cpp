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

const SceneScale::Box& SceneScale::box_of(NodeId node, const std::shared_ptr<const PolyMesh>& mesh) {
  Measured& measured = measured_[node];
  if (measured.mesh.lock() == mesh) return measured.box;
  measured = {mesh, Box()};
  for (const Vec3& place : mesh->positions) measured.box.extend(place);
  return measured.box;
}

SceneScale::Box SceneScale::box_of_rest(const WorkObject& object) {
  Box rest;
  for (const WorkObject& other : studio_.objects()) {
    const bool is_seen = other.node != object.node && other.visible && other.shown();
    if (is_seen) rest.extend(box_of(other.node, other.shown()));
  }
  for (const Stroke& stroke : studio_.drawing().strokes) {
    for (const StrokeSample& sample : stroke.samples) rest.extend(Vec3(sample.position.x(), sample.position.y(), 0));
  }
  return rest;
}

std::optional<double> SceneScale::factor() {
  const WorkObject* object = studio_.active();
  if (object == nullptr || !object->visible || !object->cage_mesh) return std::nullopt;
  if (!source_mesh(studio_.session().document(), object->cage)) return std::nullopt;
  const Box rest = box_of_rest(*object);
  const Box& own = box_of(object->cage, object->cage_mesh);
  if (rest.isEmpty() || own.isEmpty()) return std::nullopt;
  const double factor = rest.diagonal().norm() / own.diagonal().norm();
  if (!std::isnormal(factor)) return std::nullopt;
  return factor;
}

bool SceneScale::is_far_off() {
  const auto by = factor();
  return by && (*by >= far_off || *by <= 1 / far_off);
}

QString SceneScale::sentence() {
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
  const Vec3 middle = box_of(object.cage, object.cage_mesh).center();
  const Vec3 goal = rest.contains(middle) ? middle : Vec3(rest.center());
  PolyMesh scaled = *object.cage_mesh;
  for (Vec3& place : scaled.positions) place = goal + *by * (place - middle);
  Node cage = *studio_.session().document().find(object.cage);
  cage.source = std::make_shared<const PolyMesh>(std::move(scaled));
  studio_.session().edit("Scale " + object.name + " to the scene", studio_.session().document().with(std::move(cage)));
}

}  // namespace croquis::app
