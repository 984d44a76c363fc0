// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QObject>
#include <QSize>
#include <QThread>
#include <memory>
#include <vector>

#include "croquis/render/camera.h"
#include "croquis/render/render_options.h"
#include "croquis/render/scene.h"

namespace croquis::render {
class OffscreenContext;
class Renderer;
}  // namespace croquis::render

namespace croquis::app {

/// Finished pictures without a window: thumbnails and exports. Drawn on a thread of its own, so that others wait for
/// them as well as the window's; its context is made there when the first picture is asked for.
class OffscreenPictures {
 public:
  OffscreenPictures();
  ~OffscreenPictures();

  /// Returns when the picture is there. Called from any thread.
  /// @throws Error (E_NO_GL, E_GL, E_PICTURE_SIZE)
  QImage draw(const std::vector<render::Shown<render::MeshItem>>& items, const render::Camera& camera,
              const render::RenderOptions& options, const QSize& size);

  /// The whole of the items from a named side, large ones with fewer triangles.
  QImage draw_small(const std::vector<render::Shown<render::MeshItem>>& items, render::NamedView view,
                    const QSize& size);

 private:
  QThread thread_;
  QObject in_thread_;                                  ///< lives in that thread, as the following do
  std::unique_ptr<render::OffscreenContext> context_;  ///< current there all the time
  std::unique_ptr<render::Renderer> renderer_;
};

/// The PNG file of a picture.
std::vector<std::uint8_t> png_bytes(const QImage& image);

}  // namespace croquis::app
