// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gallery_thumbnails.h"

#include <QMetaObject>
#include <algorithm>

#include "app/gallery.h"
#include "app/offscreen_pictures.h"
#include "croquis/base/error.h"

namespace croquis::app {
namespace {

constexpr QSize picture_size(336, 252);  // twice a tile's, for screens of two pixels a point

std::shared_ptr<const PolyMesh> make_solid(const Registry& registry, const QString& sketch,
                                           const std::atomic<bool>& stopped) {
  Progress progress(nullptr, &stopped);
  Context context{progress, Quality::Draft};
  const Values inputs{{"drawing", std::make_shared<const Drawing>(load_gallery_sketch(sketch))}};
  const OperationResult result = run(*registry.find("inflate"), inputs, {}, context);
  return std::get<std::shared_ptr<const PolyMesh>>(result.outputs.at("mesh"));
}

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
  const std::vector<GallerySketch> sketches = gallery_sketches();
  for (std::size_t i = first; i < sketches.size() && !stopped; ++i) {
    std::shared_ptr<const PolyMesh> solid;
    try {
      solid = make_solid(registry_, sketches[i].name, stopped);
    } catch (const Cancelled&) {
      return;
    } catch (const Error&) {
      continue;  // its tile keeps its name alone; opening it says what is wrong
    }
    // Pictures belong to the window's thread, as its contexts do.
    QMetaObject::invokeMethod(
        this, [this, i, name = sketches[i].name, solid] { show(i, name, solid); }, Qt::QueuedConnection);
  }
  QMetaObject::invokeMethod(
      this, [this] { busy_ = false; }, Qt::QueuedConnection);
}

void GalleryThumbnails::show(std::size_t place, const QString& sketch, const std::shared_ptr<const PolyMesh>& solid) {
  done_ = std::max(done_, place + 1);
  try {
    const std::vector<render::MeshItemPtr> items{render::make_mesh_item(*solid)};
    emit finished(sketch, pictures_.draw(items, render::NamedView::Perspective, picture_size));
  } catch (const Error&) {
    stop();  // no context for pictures: the window says so when it can't draw either
  }
}

}  // namespace croquis::app
