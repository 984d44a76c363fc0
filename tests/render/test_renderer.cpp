// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include <catch2/catch.hpp>
#include <epoxy/gl.h>

#include "croquis/render/renderer.h"
#include "render/picture_probe.h"
#include "support/meshes/mesh_shapes.h"

using namespace croquis;
using namespace croquis::render;
using croquis::test::brightness;
using croquis::test::count_pixels;
using croquis::test::flat_options;
using croquis::test::picture_of;
using croquis::test::pixel;
using croquis::test::with_renderer;

namespace {

constexpr Color red = {220, 30, 30, 255}, green = {30, 200, 60, 255}, blue = {30, 60, 220, 255};
constexpr Color cyan = {30, 200, 200, 255}, magenta = {200, 40, 200, 255}, yellow = {220, 210, 40, 255};

Color color_of_side(const Vec3& normal) {
  if (std::abs(normal.x()) > 0.5) return normal.x() > 0 ? red : cyan;
  if (std::abs(normal.y()) > 0.5) return normal.y() > 0 ? green : magenta;
  return normal.z() > 0 ? blue : yellow;
}

/// A box of 2 by 1 by 3 whose six sides have six colours.
PolyMesh colored_box() {
  PolyMesh box = test::cube();
  std::vector<std::array<std::uint8_t, 3>> colors;
  for (std::size_t f = 0; f < box.face_count(); ++f) {
    const auto face = box.face(f);
    const Vec3 ahead = box.positions[face[1]] - box.positions[face[0]];
    const Vec3 behind = box.positions[face[3]] - box.positions[face[0]];
    const Color color = color_of_side(ahead.cross(behind));
    colors.push_back({color.r, color.g, color.b});
  }
  test::color_faces(box, colors);
  for (Vec3& position : box.positions) position = position.cwiseProduct(Vec3(2, 1, 3));
  return box;
}

/// Width / height of everything that is not white.
double drawn_aspect(const RenderedPicture& picture) {
  int left = picture.width, right = -1, top = picture.height, bottom = -1;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      if (brightness(pixel(picture, x, y)) >= 250) continue;
      left = std::min(left, x);
      right = std::max(right, x);
      top = std::min(top, y);
      bottom = std::max(bottom, y);
    }
  }
  return (right - left + 1.0) / (bottom - top + 1.0);
}

}  // namespace

TEST_CASE("a sphere covers pi/4 of the square about it") {
  with_renderer([](Renderer& renderer) {
    const RenderedPicture picture =
        picture_of(renderer, test::uv_sphere(128, 64), NamedView::Front, flat_options(), {300, 300});
    const int covered = count_pixels(picture, [](const Color& color) { return color.b < 220; });
    const double side = 300 * 0.88;
    CHECK(covered / (side * side) == Approx(M_PI / 4).epsilon(0.01));
  });
}

TEST_CASE("each named view shows its side of a box, in its proportions and its own colour") {
  struct Expected {
    NamedView view;
    Color color;
    double aspect;
  };
  const Expected expected = GENERATE(Expected{NamedView::Front, blue, 2.0}, Expected{NamedView::Side, red, 3.0},
                                     Expected{NamedView::Top, green, 2.0 / 3.0});
  with_renderer([&](Renderer& renderer) {
    const RenderedPicture picture = picture_of(renderer, colored_box(), expected.view, flat_options(), {320, 240});
    CHECK(pixel(picture, 160, 120) == expected.color);
    CHECK(drawn_aspect(picture) == Approx(expected.aspect).epsilon(0.02));
    for (const Color& other : {red, green, blue, cyan, magenta, yellow}) {
      if (other == expected.color) continue;
      CHECK(count_pixels(picture, [&](const Color& color) { return color == other; }) == 0);
    }
  });
}

TEST_CASE("pictures are neither mirrored nor upside down") {
  PolyMesh mesh = test::merged(test::scaled(test::cube(), 4), test::translated(test::cube(), {3, 3, 4}));
  std::vector<std::array<std::uint8_t, 3>> colors(6, {200, 200, 200});
  colors.insert(colors.end(), 6, {220, 30, 30});
  test::color_faces(mesh, colors);
  with_renderer([&](Renderer& renderer) {
    const RenderedPicture picture = picture_of(renderer, mesh, NamedView::Front, flat_options(), {200, 200});
    CHECK(pixel(picture, 175, 25) == red);
    CHECK(pixel(picture, 25, 25) == Color(200, 200, 200, 255));
    CHECK(pixel(picture, 175, 175) == Color(200, 200, 200, 255));
  });
}

TEST_CASE("the side towards the key light is brighter than the far side") {
  RenderOptions options;
  options.contours = false;
  with_renderer([&](Renderer& renderer) {
    const RenderedPicture picture =
        picture_of(renderer, test::uv_sphere(64, 32), NamedView::Front, options, {200, 200});
    const int lit = brightness(pixel(picture, 70, 55));
    const int middle = brightness(pixel(picture, 110, 110));
    const int far_side = brightness(pixel(picture, 145, 155));
    CHECK(lit > middle + 10);
    CHECK(middle > far_side + 20);
    CHECK(far_side > 30);
  });
}

TEST_CASE("wire draws the polygons' edges and no diagonals") {
  RenderOptions options = flat_options();
  options.wire = true;
  options.wire_color = {0, 0, 0, 255};
  options.wire_width = 2;
  with_renderer([&](Renderer& renderer) {
    const RenderedPicture picture = picture_of(renderer, test::grid(4, 4), NamedView::Front, options, {240, 240});
    const double unit = 240 * 0.88 / 4;
    const auto at = [&](double x, double y) {
      return pixel(picture, static_cast<int>(120 + unit * (x - 2)), static_cast<int>(120 - unit * (y - 2)));
    };
    for (int x = 0; x < 4; ++x) {
      for (int y = 0; y < 4; ++y) {
        CHECK(at(x + 0.5, y + 0.5) == palette_color(0));
        CHECK(brightness(at(x, y + 0.5)) < 130);
        CHECK(brightness(at(x + 0.5, y)) < 130);
      }
    }
  });
}

TEST_CASE("polylines are drawn in their colour, and hidden behind surfaces") {
  PolyMesh mesh = test::grid(2, 2);
  mesh.positions.insert(mesh.positions.end(), {{-2, 1, -1}, {4, 1, -1}, {-2, 3, 0}, {4, 3, 0}});
  mesh.add_line(std::vector<Index>{9, 10});
  mesh.add_line(std::vector<Index>{11, 12});
  mesh.channels.push_back({"color", Domain::Line, 3, std::vector<std::uint8_t>{0, 0, 255, 255, 0, 0}, {}});
  RenderOptions options = flat_options();
  options.line_width = 6;
  with_renderer([&](Renderer& renderer) {
    const RenderedPicture picture = picture_of(renderer, mesh, NamedView::Front, options, {300, 200});
    const double unit = 300 * 0.88 / 6;
    const auto at = [&](double x, double y) {
      return pixel(picture, static_cast<int>(150 + unit * (x - 1)), static_cast<int>(100 - unit * (y - 1.5)));
    };
    CHECK(at(-1, 1) == Color(0, 0, 255, 255));
    CHECK(at(3, 1) == Color(0, 0, 255, 255));
    CHECK(at(1, 1) == palette_color(0));
    CHECK(at(1, 3) == Color(255, 0, 0, 255));
  });
}

TEST_CASE("a host's framebuffer is filled inside the viewport alone and bound again afterwards") {
  with_renderer([](Renderer& renderer) {
    GLuint framebuffer = 0, color = 0;
    glGenFramebuffers(1, &framebuffer);
    glGenRenderbuffers(1, &color);
    glBindRenderbuffer(GL_RENDERBUFFER, color);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 64, 64);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color);
    glClearColor(1, 0, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);

    RenderOptions options = flat_options();
    options.background_top = options.background_bottom = {10, 20, 30, 255};
    renderer.draw(Scene{}, Camera(), options, {16, 8, 32, 40, {}});
    GLint bound = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
    CHECK(static_cast<GLuint>(bound) == framebuffer);

    RenderedPicture picture{64, 64, std::vector<std::uint8_t>(64 * 64 * 4)};
    glReadPixels(0, 0, 64, 64, GL_RGBA, GL_UNSIGNED_BYTE, picture.rgba.data());
    CHECK(count_pixels(picture, [](const Color& c) { return c == Color(10, 20, 30, 255); }) == 32 * 40);
    CHECK(count_pixels(picture, [](const Color& c) { return c == Color(255, 0, 255, 255); }) == 64 * 64 - 32 * 40);
    CHECK(pixel(picture, 16, 8) == Color(10, 20, 30, 255));
    CHECK(pixel(picture, 47, 47) == Color(10, 20, 30, 255));
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteRenderbuffers(1, &color);
  });
}
