// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/painters/picture_painter.h"

#include <algorithm>

#include <epoxy/gl.h>

namespace croquis::render {
namespace {

std::size_t row_bytes(const PictureLevel& level) { return std::size_t{4} * static_cast<std::size_t>(level.width); }

/// All levels, still empty.
GlHandle make_levels(const PictureItem& item) {
  GLuint name = 0;
  glGenTextures(1, &name);
  GlHandle handle(name, [](unsigned texture) { glDeleteTextures(1, &texture); });
  glBindTexture(GL_TEXTURE_2D, name);
  for (std::size_t i = 0; i < item.levels.size(); ++i) {
    const PictureLevel& level = item.levels[i];
    glTexImage2D(GL_TEXTURE_2D, static_cast<GLint>(i), GL_RGBA8, level.width, level.height, 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, nullptr);
  }
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, static_cast<GLint>(item.levels.size()) - 1);
  glBindTexture(GL_TEXTURE_2D, 0);
  return handle;
}

}  // namespace

PicturePainter::GpuPicture::GpuPicture(const PictureItem& item)
    : texture(make_levels(item)), missing(item.levels.size()) {
  check_gl("making room for a picture on the graphics card");
}

void PicturePainter::GpuPicture::send(const PictureItem& item, Uploads& uploads) {
  if (missing == 0) return;
  glBindTexture(GL_TEXTURE_2D, texture.name());
  while (missing > 0) {
    const PictureLevel& level = item.levels[missing - 1];
    const int left = level.height - rows;
    const bool at_once = level.rgba.size() <= small_item;
    const std::size_t granted = uploads.grant(static_cast<std::size_t>(left) * row_bytes(level), at_once);
    const int now = std::min(left, static_cast<int>(granted / row_bytes(level)));
    if (now == 0) break;
    glTexSubImage2D(GL_TEXTURE_2D, static_cast<GLint>(missing) - 1, 0, rows, level.width, now, GL_RGBA,
                    GL_UNSIGNED_BYTE, level.rgba.data() + static_cast<std::size_t>(rows) * row_bytes(level));
    uploads.count(static_cast<std::size_t>(now) * row_bytes(level));
    rows += now;
    if (rows < level.height) break;
    rows = 0;
    --missing;
  }
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, static_cast<GLint>(std::min(missing, item.levels.size() - 1)));
  glBindTexture(GL_TEXTURE_2D, 0);
}

void PicturePainter::draw(const std::vector<ShownPicture>& pictures, const ViewFrame& view, Uploads& uploads) {
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glBindVertexArray(no_attributes_.name());
  program_.use();
  program_.set("to_clip", view.to_clip);
  for (const ShownPicture& shown : pictures) {
    if (!shown.item || shown.opacity <= 0) continue;
    GpuPicture& picture = gpu_pictures_.get(shown.item);
    picture.send(*shown.item, uploads);
    // In double precision: pictures may lie far from the origin.
    const auto direction = [&](const glm::dvec3& way) { return glm::vec3(view.model_to_view * glm::dvec4(way, 0)); };
    program_.set("corner", glm::vec3(view.model_to_view * glm::dvec4(shown.corner, 1)));
    program_.set("right", direction(shown.right));
    program_.set("upwards", direction(shown.upwards));
    program_.set("opacity", static_cast<float>(std::min(shown.opacity, 1.0)));
    program_.set_texture("picture", 0, picture.texture);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  }
  glDisable(GL_BLEND);
}

}  // namespace croquis::render
