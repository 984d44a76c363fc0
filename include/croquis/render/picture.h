// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "croquis/render/renderer.h"

namespace croquis::render {

/// Largest width and height of a picture, in pixels.
inline constexpr int max_picture_size = 8192;

/// A finished picture, 8 bits per channel, opaque.
struct RenderedPicture {
  int width = 0;                   ///< pixels
  int height = 0;                  ///< pixels
  std::vector<std::uint8_t> rgba;  ///< 4 * width * height, top row first
};

/// Size of a picture in pixels, each in 1..max_picture_size.
struct PictureSize {
  int width = 800;
  int height = 600;
  double aspect() const { return static_cast<double>(width) / height; }
};

/// Draws a picture into a framebuffer of its own; large ones in tiles, so that the graphics card's memory is bounded.
/// @throws Error (E_PICTURE_SIZE, usage) for a size out of range, (E_GL) as Renderer::draw
RenderedPicture render_picture(Renderer& renderer, const Scene& scene, const Camera& camera,
                               const RenderOptions& options, const PictureSize& size);

/// The same of surfaces alone.
RenderedPicture render_picture(Renderer& renderer, const std::vector<MeshItemPtr>& items, const Camera& camera,
                               const RenderOptions& options, const PictureSize& size);

}  // namespace croquis::render
