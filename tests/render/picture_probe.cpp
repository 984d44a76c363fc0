// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/picture_probe.h"

#include <array>
#include <optional>
#include <string>
#include <utility>

#include <catch2/catch.hpp>
#include <epoxy/gl.h>

#include "croquis/base/error.h"
#include "croquis/render/offscreen_context.h"

namespace croquis::test {
namespace {

std::optional<std::string> reason_without_context() {
  try {
    const render::OffscreenContext context;
    return std::nullopt;
  } catch (const Error& error) {
    return error.what();
  }
}

}  // namespace

void with_renderer(const std::function<void(render::Renderer&)>& test) {
  if (const auto reason = reason_without_context()) {
    WARN("Skipped: " << *reason);
    return;
  }
  const render::OffscreenContext context;
  render::Renderer renderer;
  test(renderer);
}

render::Color pixel(const render::RenderedPicture& picture, int x, int y) {
  const auto first =
      4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x));
  return {picture.rgba.at(first), picture.rgba.at(first + 1), picture.rgba.at(first + 2), picture.rgba.at(first + 3)};
}

int brightness(const render::Color& color) { return (color.r + color.g + color.b) / 3; }

int count_pixels(const render::RenderedPicture& picture, const std::function<bool(const render::Color&)>& condition) {
  int count = 0;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) count += condition(pixel(picture, x, y)) ? 1 : 0;
  }
  return count;
}

render::RenderOptions flat_options() {
  render::RenderOptions options;
  options.background_top = options.background_bottom = {255, 255, 255, 255};
  options.shading = render::Shading::Flat;
  options.contours = false;
  return options;
}

render::Camera pixel_camera(const render::PictureSize& size) {
  render::Camera camera;
  camera.target = {0.5 * size.width, 0.5 * size.height, 0};
  camera.eye = camera.target + glm::dvec3(0, 0, 100);
  camera.height = size.height;
  return camera;
}

render::RenderedPicture pixel_picture(render::Renderer& renderer, const render::Scene& scene,
                                      const render::PictureSize& size, double pixel_ratio) {
  render::RenderOptions options = flat_options();
  options.pixel_ratio = pixel_ratio;
  return render_picture(renderer, scene, pixel_camera(size), options, size);
}

render::RenderedPicture draw_once(render::Renderer& renderer, const render::Scene& scene, const render::Camera& camera,
                                  const render::RenderOptions& options, const render::PictureSize& size) {
  GLuint framebuffer = 0;
  GLuint color = 0;
  glGenFramebuffers(1, &framebuffer);
  glGenRenderbuffers(1, &color);
  glBindRenderbuffer(GL_RENDERBUFFER, color);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, size.width, size.height);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color);
  renderer.draw(scene, camera, options, {0, 0, size.width, size.height, {}});
  const auto row = 4 * static_cast<std::size_t>(size.width);
  render::RenderedPicture picture{size.width, size.height, {}};
  picture.rgba.resize(row * static_cast<std::size_t>(size.height));
  for (int y = 0; y < size.height; ++y) {
    glReadPixels(0, size.height - 1 - y, size.width, 1, GL_RGBA, GL_UNSIGNED_BYTE,
                 picture.rgba.data() + row * static_cast<std::size_t>(y));
  }
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glDeleteRenderbuffers(1, &color);
  glDeleteFramebuffers(1, &framebuffer);
  return picture;
}

int count_color(const render::RenderedPicture& picture, const render::Color& color) {
  return count_pixels(picture, [&](const render::Color& other) { return other == color; });
}

double ink(const render::RenderedPicture& picture, int x, int y) {
  return (255 - brightness(pixel(picture, x, y))) / 255.0;
}

double ink_of_column(const render::RenderedPicture& picture, int x) {
  double sum = 0;
  for (int y = 0; y < picture.height; ++y) sum += ink(picture, x, y);
  return sum;
}

double ink_of_all(const render::RenderedPicture& picture) {
  double sum = 0;
  for (int x = 0; x < picture.width; ++x) sum += ink_of_column(picture, x);
  return sum;
}

void color_faces(PolyMesh& mesh, const std::vector<std::array<std::uint8_t, 3>>& colors) {
  std::vector<std::uint8_t> values;
  for (const auto& color : colors) values.insert(values.end(), color.begin(), color.end());
  mesh.channels.push_back({"color", Domain::Face, 3, std::move(values), {}});
}

render::RenderedPicture picture_of(render::Renderer& renderer, const PolyMesh& mesh, render::NamedView view,
                                   const render::RenderOptions& options, const render::PictureSize& size) {
  const std::vector<render::MeshItemPtr> items = {render::make_mesh_item(mesh)};
  const render::Camera camera = frame(bounds_of(items), view_direction(view), size.aspect());
  return render_picture(renderer, items, camera, options, size);
}

}  // namespace croquis::test
