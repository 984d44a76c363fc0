// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/holes/hole_sight.h"

#include <QMetaObject>
#include <utility>

namespace croquis::app {
namespace {

/// What lies so little before a hole's middle is its own rim, seen from the side. Share of the distance to the eye.
constexpr double slack = 0.01;

bool is_seen(MeshPicker& picker, const ViewFrame& frame, const Vec3& place) {
  const auto projected = frame.project(place);
  if (!projected) return false;
  const Ray ray = frame.ray(projected->pixel);
  const auto met = picker.face_under(ray);
  return !met || met->distance >= (1 - slack) * (place - ray.origin).dot(ray.direction);
}

}  // namespace

HoleSightMaker::HoleSightMaker(QObject* parent) : QObject(parent) { thread_.setMaxThreadCount(1); }

HoleSightMaker::~HoleSightMaker() { thread_.waitForDone(); }

void HoleSightMaker::follow(const std::shared_ptr<const PolyMesh>& scan) {
  if (scan == scan_) return;
  scan_ = scan;
  picker_.reset();
  if (!scan) return;
  thread_.start([this, scan] {
    const auto picker = std::make_shared<MeshPicker>(scan);
    picker->prepare();
    QMetaObject::invokeMethod(
        this,
        [this, scan, picker] {
          if (scan != scan_) return;
          picker_ = picker;
          emit changed();
        },
        Qt::QueuedConnection);
  });
}

HoleSight HoleSightMaker::sight() const {
  if (!picker_) return {};
  return [picker = picker_](const ViewFrame& frame, const Vec3& place) { return is_seen(*picker, frame, place); };
}

}  // namespace croquis::app
