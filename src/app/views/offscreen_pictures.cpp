// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/offscreen_pictures.h"

#include <QBuffer>
#include <exception>
#include <utility>

#include "croquis/render/offscreen_context.h"
#include "croquis/render/picture.h"
#include "croquis/render/renderer.h"

namespace croquis::app {
OffscreenPictures::OffscreenPictures() {
  in_thread_.moveToThread(&thread_);
  thread_.start();
}

OffscreenPictures::~OffscreenPictures() {
  const auto release = [this] {
    renderer_.reset();
    context_.reset();
  };
  QMetaObject::invokeMethod(&in_thread_, release, Qt::BlockingQueuedConnection);
  thread_.quit();
  thread_.wait();
}

QImage OffscreenPictures::draw(const std::vector<render::Shown<render::MeshItem>>& items, const render::Camera& camera,
                               const render::RenderOptions& options, const QSize& size) {
  QImage image;
  std::exception_ptr failure;
  const auto work = [&] {
    try {
      if (!context_) context_ = std::make_unique<render::OffscreenContext>();
      if (!renderer_) renderer_ = std::make_unique<render::Renderer>();
      render::Scene scene;
      scene.meshes = items;
      const render::RenderedPicture picture =
          render::render_picture(*renderer_, scene, camera, options, {size.width(), size.height()});
      image = QImage(picture.rgba.data(), picture.width, picture.height, QImage::Format_RGBA8888).copy();
    } catch (...) {
      failure = std::current_exception();
    }
  };
  QMetaObject::invokeMethod(&in_thread_, work, Qt::BlockingQueuedConnection);
  if (failure) std::rethrow_exception(failure);
  return image;
}

QImage OffscreenPictures::draw_small(const std::vector<render::Shown<render::MeshItem>>& items, render::NamedView view,
                                     const QSize& size) {
  render::RenderOptions options;
  options.reduced = true;
  const double aspect = static_cast<double>(size.width()) / size.height();
  render::Scene scene;
  scene.meshes = items;
  return draw(items, render::frame(render::points_of(scene), render::view_direction(view), aspect), options, size);
}

std::vector<std::uint8_t> png_bytes(const QImage& image) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  return {bytes.begin(), bytes.end()};
}

}  // namespace croquis::app
