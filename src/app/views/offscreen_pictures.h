// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QSize>
#include <memory>
#include <vector>

#include "croquis/render/camera.h"
#include "croquis/render/mesh_item.h"
#include "croquis/render/render_options.h"

class QOffscreenSurface;
class QOpenGLContext;

namespace croquis::render {
class Renderer;
}

namespace croquis::app {

/// Finished pictures without a window: thumbnails and exports. Its context is made when the first one is asked for.
class OffscreenPictures {
 public:
  OffscreenPictures();
  ~OffscreenPictures();

  /// @throws Error (E_GL, E_PICTURE_SIZE)
  QImage draw(const std::vector<render::MeshItemPtr>& items, const render::Camera& camera,
              const render::RenderOptions& options, const QSize& size);

  /// The whole of the items from a named side.
  QImage draw(const std::vector<render::MeshItemPtr>& items, render::NamedView view, const QSize& size);

 private:
  void make_context();

  std::unique_ptr<QOffscreenSurface> surface_;
  std::unique_ptr<QOpenGLContext> context_;
  std::unique_ptr<render::Renderer> renderer_;
};

/// The PNG file of a picture.
std::vector<std::uint8_t> png_bytes(const QImage& image);

}  // namespace croquis::app
