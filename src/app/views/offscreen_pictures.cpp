// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/offscreen_pictures.h"

#include <QBuffer>
#include <QOffscreenSurface>
#include <QOpenGLContext>

#include "croquis/base/error.h"
#include "croquis/render/picture.h"
#include "croquis/render/renderer.h"

namespace croquis::app {
namespace {

/// The window's own context stays current for the caller.
class CurrentContext {
 public:
  CurrentContext(QOpenGLContext& context, QSurface& surface)
      : before_(QOpenGLContext::currentContext()),
        before_surface_(before_ != nullptr ? before_->surface() : nullptr),
        context_(context) {
    context_.makeCurrent(&surface);
  }
  CurrentContext(const CurrentContext&) = delete;
  CurrentContext& operator=(const CurrentContext&) = delete;

  ~CurrentContext() {
    context_.doneCurrent();
    if (before_ != nullptr) before_->makeCurrent(before_surface_);
  }

 private:
  QOpenGLContext* before_;
  QSurface* before_surface_;
  QOpenGLContext& context_;
};

}  // namespace

OffscreenPictures::OffscreenPictures() = default;

OffscreenPictures::~OffscreenPictures() {
  if (!renderer_) return;
  const CurrentContext current(*context_, *surface_);
  renderer_.reset();
}

void OffscreenPictures::make_context() {
  surface_ = std::make_unique<QOffscreenSurface>();
  surface_->create();
  context_ = std::make_unique<QOpenGLContext>();
  if (!context_->create()) {
    throw Error(make_error(Category::Internal, "E_GL", "No OpenGL context can be made: try --software-gl"));
  }
}

QImage OffscreenPictures::draw(const std::vector<render::MeshItemPtr>& items, const render::Camera& camera,
                               const render::RenderOptions& options, const QSize& size) {
  if (!context_) make_context();
  const CurrentContext current(*context_, *surface_);
  if (!renderer_) renderer_ = std::make_unique<render::Renderer>();
  const render::RenderedPicture picture =
      render::render_picture(*renderer_, items, camera, options, {size.width(), size.height()});
  return QImage(picture.rgba.data(), picture.width, picture.height, QImage::Format_RGBA8888).copy();
}

QImage OffscreenPictures::draw(const std::vector<render::MeshItemPtr>& items, render::NamedView view,
                               const QSize& size) {
  const double aspect = static_cast<double>(size.width()) / size.height();
  return draw(items, render::frame(render::points_of(items), render::view_direction(view), aspect),
              render::RenderOptions{}, size);
}

std::vector<std::uint8_t> png_bytes(const QImage& image) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  return {bytes.begin(), bytes.end()};
}

}  // namespace croquis::app
