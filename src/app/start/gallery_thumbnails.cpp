// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/start/gallery_thumbnails.h"

#include <QMetaObject>
#include <algorithm>

#include "app/start/gallery.h"
#include "app/views/offscreen_pictures.h"
#include "croquis/base/error.h"

namespace croquis::app {
namespace {

constexpr QSize picture_size(336, 252);  // twice a tile's, for screens of two pixels a point

}  // namespace

GalleryThumbnails::GalleryThumbnails(const Registry& registry, OffscreenPictures& pictures, QObject* parent)
    : QObject(parent), registry_(registry), pictures_(pictures) {}

GalleryThumbnails::~GalleryThumbnails() { stop(); }

void GalleryThumbnails::start() {
  if (worker_.joinable()) return;
  stopped_ = false;
  busy_ = true;
  worker_ = std::thread([this, first = done_] { make_pictures(first, stopped_); });
}

void GalleryThumbnails::stop() {
  stopped_ = true;
  busy_ = false;
  if (worker_.joinable()) worker_.join();
}

void GalleryThumbnails::make_pictures(std::size_t first, const std::atomic<bool>& stopped) {
  const std::vector<Sample> all = samples();
  for (std::size_t i = first; i < all.size() && !stopped; ++i) {
    std::shared_ptr<const PolyMesh> solid;
    try {
      Progress progress(nullptr, &stopped);
      solid = sample_surface(all[i].name, registry_, progress);
    } catch (const Cancelled&) {
      return;
    } catch (const Error&) {
      continue;  // its tile keeps its name alone; opening it reports the error
    }
    // Pictures belong to the window's thread, as its contexts do.
    QMetaObject::invokeMethod(
        this, [this, i, name = all[i].name, solid] { show(i, name, solid); }, Qt::QueuedConnection);
  }
  QMetaObject::invokeMethod(
      this, [this] { busy_ = false; }, Qt::QueuedConnection);
}

void GalleryThumbnails::show(std::size_t place, const QString& sketch, const std::shared_ptr<const PolyMesh>& solid) {
  done_ = std::max(done_, place + 1);
  try {
    const std::vector<render::MeshItemPtr> items{render::make_mesh_item(*solid)};
    // Screws lie along z, their heads in front of the collar that they are about.
    const bool from_behind = sketch.startsWith("bolt");
    const double aspect = static_cast<double>(picture_size.width()) / picture_size.height();
    render::ViewDirection direction = render::view_direction(render::NamedView::Perspective);
    if (from_behind) direction.direction = {direction.direction.x, direction.direction.y, -direction.direction.z};
    const render::Camera camera = render::frame(render::points_of(items), direction, aspect);
    emit finished(sketch, pictures_.draw(items, camera, render::RenderOptions{}, picture_size));
  } catch (const Error&) {
    stop();  // no context for pictures: the window reports it when it can't draw either
  }
}

}  // namespace croquis::app
