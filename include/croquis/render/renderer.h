// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "croquis/render/camera.h"
#include "croquis/render/render_options.h"
#include "croquis/render/scene.h"

namespace croquis::render {

/// The part of a larger picture that is being drawn, in its pixels from the lower left corner.
struct PictureCrop {
  int picture_width = 0;
  int picture_height = 0;
  int left = 0;
  int bottom = 0;
};

/// The rectangle of the framebuffer that receives the picture, in pixels from the lower left corner.
struct PixelRect {
  int x = 0;
  int y = 0;
  int width = 0;                    ///< > 0
  int height = 0;                   ///< > 0
  std::optional<PictureCrop> crop;  ///< it shows this part; without it the whole picture
};

/// What went to the graphics card since the renderer was made: buffers of items, not those of views.
struct UploadCount {
  std::size_t bytes = 0;
  std::size_t transfers = 0;
};

/// Draws items with OpenGL 3.3 core into whatever framebuffer its host has bound; opens nothing by itself.
///
/// Its host makes a context current before construction, before every call and before destruction; libepoxy finds the
/// functions of that context, so none are handed in. Objects on the graphics card are kept per item for as long as
/// somebody holds the item and one renderer draws it. One thread, one context (or contexts that share objects).
class Renderer {
 public:
  /// @throws Error (E_GL) when the context is older than OpenGL 3.3 or a shader does not compile, in the driver's words
  Renderer();
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  /// Fills the viewport of the framebuffer bound for drawing with the picture.
  ///
  /// Nothing outside the viewport changes, nor do depth and stencil of that framebuffer. OpenGL's state is put back
  /// but for program, vertex array, array buffer and the 2D textures of the first eight units, which are set to none.
  /// The same scene, camera, options and size give the same pixels on the same driver.
  /// @throws Error (E_GL) when the driver reports an error or can't make a buffer of that size
  void draw(const Scene& scene, const Camera& camera, const RenderOptions& options, const PixelRect& viewport);

  /// The same of surfaces alone.
  void draw(const std::vector<MeshItemPtr>& items, const Camera& camera, const RenderOptions& options,
            const PixelRect& viewport);

  /// Whether the last drawing left something out, for `RenderOptions::upload_budget`: draw again, soon. Views that
  /// share a renderer each have to ask after their own drawing.
  bool pending() const;

  UploadCount uploaded() const;

  /// Of all buffers that pictures with surfaces were drawn in and that are kept for the next ones of their sizes.
  std::size_t kept_samples() const;

  /// Of filled or covering surfaces in the last drawing.
  std::size_t triangles_drawn() const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace croquis::render
