// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/render/picture.h"

#include <algorithm>
#include <string>

#include <epoxy/gl.h>

#include "croquis/base/error.h"
#include "render/gl/gl_handle.h"

namespace croquis::render {
namespace {

/// Pixels of a tile's side: with border and samples some hundred megabytes on the graphics card.
constexpr int tile_size = 1024;

void require_size(const PictureSize& size) {
  Findings findings;
  const auto require = [&](int length, const char* name) {
    if (length >= 1 && length <= max_picture_size) return;
    findings.push_back(make_error(Category::Usage, "E_PICTURE_SIZE",
                                  "The picture's " + std::string(name) + " is " + std::to_string(length) +
                                      " pixels, but it must be from 1 to " + std::to_string(max_picture_size) + ".",
                                  {{SubjectKind::Parameter, "size", {}, {}, {}}}));
  };
  require(size.width, "width");
  require(size.height, "height");
  if (!findings.empty()) throw Error(std::move(findings));
}

/// A framebuffer to draw into while the host's own one waits.
class PictureTarget {
 public:
  PictureTarget(int width, int height)
      : color_(make_texture(GL_RGBA8, width, height)), framebuffer_(make_framebuffer()) {
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &draw_);
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color_.name(), 0);
  }
  ~PictureTarget() {
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(draw_));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read_));
  }
  PictureTarget(const PictureTarget&) = delete;
  PictureTarget& operator=(const PictureTarget&) = delete;

 private:
  GlHandle color_, framebuffer_;
  GLint draw_ = 0;
  GLint read_ = 0;
};

/// Copies the target's lower left corner into its place of the picture; OpenGL's rows come from below.
void read_tile(const PixelRect& tile, RenderedPicture& picture) {
  const auto row_bytes = 4 * static_cast<std::size_t>(tile.width);
  std::vector<std::uint8_t> pixels(row_bytes * static_cast<std::size_t>(tile.height));
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, tile.width, tile.height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  for (int y = 0; y < tile.height; ++y) {
    const auto row = static_cast<std::size_t>(picture.height - 1 - tile.crop->bottom - y);
    const auto first = 4 * (row * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(tile.crop->left));
    std::copy_n(pixels.data() + static_cast<std::size_t>(y) * row_bytes, row_bytes, picture.rgba.data() + first);
  }
}

}  // namespace

RenderedPicture render_picture(Renderer& renderer, const Scene& scene, const Camera& camera,
                               const RenderOptions& options, const PictureSize& size) {
  require_size(size);
  RenderedPicture picture{size.width, size.height, {}};
  picture.rgba.resize(4 * static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
  RenderOptions complete = options;
  complete.upload_budget = 0;  // a finished picture shows everything
  const PictureTarget target(std::min(size.width, tile_size), std::min(size.height, tile_size));
  for (int bottom = 0; bottom < size.height; bottom += tile_size) {
    for (int left = 0; left < size.width; left += tile_size) {
      const PixelRect tile{0, 0, std::min(tile_size, size.width - left), std::min(tile_size, size.height - bottom),
                           PictureCrop{size.width, size.height, left, bottom}};
      renderer.draw(scene, camera, complete, tile);
      read_tile(tile, picture);
    }
  }
  check_gl("reading a picture back");
  return picture;
}

RenderedPicture render_picture(Renderer& renderer, const std::vector<MeshItemPtr>& items, const Camera& camera,
                               const RenderOptions& options, const PictureSize& size) {
  return render_picture(renderer, Scene{{items.begin(), items.end()}, {}, {}}, camera, options, size);
}

}  // namespace croquis::render
