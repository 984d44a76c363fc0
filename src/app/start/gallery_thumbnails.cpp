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

GalleryThumbnails::~GalleryThumbnails() {
  stop();
  if (worker_.joinable()) worker_.join();
}

void GalleryThumbnails::start() {
  if (worker_.joinable() && !stopped_) return;
  if (worker_.joinable()) worker_.join();
  stopped_ = false;
  busy_ = true;
  worker_ = std::thread([this, first = done_] { make_pictures(first); });
}

void GalleryThumbnails::stop() {
  stopped_ = true;
  busy_ = false;
}

void GalleryThumbnails::make_pictures(std::size_t first) {
  const std::vector<Sample> all = samples();
  for (std::size_t i = first; i < all.size() && !stopped_; ++i) {
    QImage picture;
    try {
      picture = picture_of(all[i].name);
    } catch (const Cancelled&) {
      return;
    } catch (const Error&) {
      // Its tile keeps its name alone; opening it reports the error.
    }
    const auto show = [this, i, name = all[i].name, picture] {
      done_ = i + 1;
      if (!picture.isNull()) emit finished(name, picture);
    };
    QMetaObject::invokeMethod(this, show, Qt::QueuedConnection);
  }
  const auto rest = [this] { busy_ = busy_ && done_ < samples().size(); };
  QMetaObject::invokeMethod(this, rest, Qt::QueuedConnection);
}

QImage GalleryThumbnails::picture_of(const QString& sample) {
  Progress progress(nullptr, &stopped_);
  const std::vector<render::MeshItemPtr> items{render::make_mesh_item(*sample_surface(sample, registry_, progress))};
  const double aspect = static_cast<double>(picture_size.width()) / picture_size.height();
  render::ViewDirection direction = render::view_direction(render::NamedView::Perspective);
  // Screws lie along z, their heads in front of the collar that they are about.
  if (sample.startsWith("bolt"))
    direction.direction = {direction.direction.x, direction.direction.y, -direction.direction.z};
  const render::Camera camera = render::frame(render::points_of(items), direction, aspect);
  render::RenderOptions options;
  options.supersampling = 2;  // tiles show it smaller
  options.reduced = true;
  return pictures_.draw({items.begin(), items.end()}, camera, options, picture_size);
}

}  // namespace croquis::app
