// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/live_item.h"

#include <QCoreApplication>
#include <QMetaObject>
#include <QThreadPool>
#include <utility>

#include "croquis/base/error.h"

namespace croquis::app {
namespace {

constexpr std::size_t corners_at_once = 200'000;  // of more, making an item causes a visible delay

bool same_options(const render::MeshItemOptions& a, const render::MeshItemOptions& b) {
  return a.shading == b.shading && a.crease_angle == b.crease_angle;
}

render::MeshItemPtr made(const render::MeshItemPtr& previous, const std::shared_ptr<const PolyMesh>& mesh,
                         const render::MeshItemOptions& options, const LiveItem::Paint& paint) {
  try {
    return render::update_mesh_item(previous, paint ? *paint(mesh) : *mesh, options);
  } catch (const Error&) {
    return nullptr;  // what can't be drawn is reported where the mesh is made
  }
}

}  // namespace

void LiveItem::show(const std::shared_ptr<const PolyMesh>& mesh, const render::MeshItemOptions& options,
                    const Paint& paint, int look) {
  const bool same = same_options(options_, options);
  if (mesh == wanted_ && same && look == look_) return;
  if (!same) {
    item_.reset();
    made_of_.reset();
  }
  wanted_ = mesh;
  options_ = options;
  paint_ = paint;
  look_ = look;
  if (!mesh || mesh->corners.size() <= corners_at_once) {
    item_ = mesh ? made(item_, mesh, options_, paint_) : nullptr;
    made_of_ = mesh;
    made_look_ = look;
  } else if (!making_) {
    begin();
  }
}

void LiveItem::begin() {
  making_ = true;
  threads_.start([this, alive = std::weak_ptr(alive_), mesh = wanted_, previous = item_, options = options_,
                  paint = paint_, look = look_] {
    const render::MeshItemPtr item = made(previous, mesh, options, paint);
    QMetaObject::invokeMethod(
        QCoreApplication::instance(),
        [this, alive, mesh, options, look, item] {
          if (!alive.expired()) take(mesh, options, look, item);
        },
        Qt::QueuedConnection);
  });
}

void LiveItem::take(const std::shared_ptr<const PolyMesh>& mesh, const render::MeshItemOptions& options, int look,
                    const render::MeshItemPtr& item) {
  making_ = false;
  if (!busy()) return;
  if (same_options(options, options_)) {
    item_ = item;
    made_of_ = mesh;
    made_look_ = look;
  }
  if (busy()) begin();
  emit ready();
}

}  // namespace croquis::app
