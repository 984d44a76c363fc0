// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/surface/uniform_ghost.h"

#include <QMetaObject>
#include <utility>

#include "croquis/attribute_surface/surface_tessellation.h"
#include "croquis/base/error.h"

namespace croquis::app {
namespace {

std::shared_ptr<const UniformGhost::Compared> compare(const ShownSurface& shown, Progress& progress) {
  auto made = std::make_shared<UniformGhost::Compared>();
  made->shown = shown;
  made->comparison = compare_with_uniform(shown.network(), shown.surface(), progress);
  made->measures = measure(made->comparison.network, made->comparison.surface);
  const SurfaceTessellation triangles = tessellate(made->comparison.network, made->comparison.surface, progress);
  if (triangles.mesh.face_count() == 0) return made;
  render::MeshItemOptions options;
  options.use_normal_channel = true;
  const Affine3 onward = composed(shown.to_world, inverse_of(shown.to_result));
  made->item = render::make_mesh_item(transformed(triangles.mesh, onward), options);
  return made;
}

}  // namespace

UniformGhost::UniformGhost() { thread_.setMaxThreadCount(1); }

UniformGhost::~UniformGhost() {
  if (running_) *running_ = true;
  thread_.waitForDone();
}

void UniformGhost::set_on(bool on) {
  on_ = on;
  if (on) {
    begin();
  } else {
    compared_.reset();
  }
  emit changed();
}

void UniformGhost::follow(const ShownSurface& shown) {
  wanted_ = shown;
  if (!shown) compared_.reset();
  begin();
}

void UniformGhost::begin() {
  const bool is_there =
      compared_ && compared_->shown.result == wanted_.result && compared_->shown.to_world == wanted_.to_world;
  if (!on_ || running_ || !wanted_ || is_there) return;
  running_ = std::make_shared<std::atomic<bool>>(false);
  thread_.start([this, shown = wanted_, stop = running_, alive = std::weak_ptr<bool>(alive_)] {
    Progress progress({}, stop.get());
    std::shared_ptr<const Compared> made;
    try {
      made = compare(shown, progress);
    } catch (const Cancelled&) {
      made.reset();
    } catch (const Error&) {
      made.reset();  // what is wrong with the network is told by its own surfaces
    }
    QMetaObject::invokeMethod(
        this,
        [this, made, alive] {
          if (!alive.expired()) take(made);
        },
        Qt::QueuedConnection);
  });
}

void UniformGhost::take(const std::shared_ptr<const Compared>& made) {
  running_.reset();
  if (on_ && made) compared_ = made;
  const bool is_old = on_ && made && made->shown.result != wanted_.result;
  emit changed();
  if (is_old) begin();
}

}  // namespace croquis::app
