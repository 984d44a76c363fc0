// SPDX-License-Identifier: GPL-3.0-or-later
// Lines at the contours of surfaces, and outlines around what is selected.
#include <cmath>

#include <catch2/catch.hpp>

#include "croquis/render/renderer.h"
#include "render/picture_probe.h"
#include "support/meshes/mesh_shapes.h"

using namespace croquis;
using namespace croquis::render;
using croquis::test::brightness;
using croquis::test::count_color;
using croquis::test::picture_of;
using croquis::test::pixel;
using croquis::test::with_renderer;

namespace {

RenderOptions lines_on_flat() {
  RenderOptions options = test::flat_options();
  options.contours = true;
  options.contour_color = {0, 0, 0, 255};
  return options;
}

bool is_dark(const Color& color) { return brightness(color) < 110; }

/// Dark runs met on the way down a column.
int dark_runs(const RenderedPicture& picture, int x) {
  int runs = 0;
  bool inside = false;
  for (int y = 0; y < picture.height; ++y) {
    const bool dark = is_dark(pixel(picture, x, y));
    runs += dark && !inside ? 1 : 0;
    inside = dark;
  }
  return runs;
}

constexpr PictureSize outlined_size{200, 200};
constexpr Color orange(255, 128, 0, 255), black(0, 0, 0, 255);

RenderOptions outlining(int samples) {
  RenderOptions options = test::flat_options();
  options.supersampling = samples;
  options.emphasis.outline = orange;
  options.emphasis.outline_casing = black;
  options.emphasis.outline_width = 4;
  options.emphasis.casing_width = 3;
  return options;
}

/// A square of 80 pixels in the middle of the picture; one behind it that is larger.
Scene squares(bool outlined) {
  Scene scene;
  const PolyMesh unit = test::grid(1, 1);
  scene.meshes.emplace_back(make_mesh_item(test::translated(test::scaled(unit, 80), {60, 60, 10})),
                            Emphasis{false, false, false, outlined});
  scene.meshes.emplace_back(make_mesh_item(test::translated(test::scaled(unit, 120), {100, 40, 0})));
  return scene;
}

}  // namespace

TEST_CASE("a sphere has a line all along its outline and nowhere else") {
  const int size = GENERATE(60, 200, 500);
  with_renderer([&](Renderer& renderer) {
    const RenderedPicture picture =
        picture_of(renderer, test::uv_sphere(96, 48), NamedView::Front, lines_on_flat(), {size, size});
    const double radius = 0.44 * size;
    int misses = 0;
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x) {
        const double away = std::hypot(x + 0.5 - 0.5 * size, y + 0.5 - 0.5 * size) - radius;
        if (std::abs(away) > 2 && brightness(pixel(picture, x, y)) < 180) ++misses;
      }
    }
    CHECK(misses == 0);
    for (int degrees = 0; degrees < 360; degrees += 3) {
      const double angle = degrees * M_PI / 180;
      const int x = static_cast<int>(0.5 * size + radius * std::cos(angle));
      const int y = static_cast<int>(0.5 * size + radius * std::sin(angle));
      CHECK(is_dark(pixel(picture, x, y)));
    }
  });
}

TEST_CASE("a surface that hides a part of itself has a line there") {
  // Tilted by 70 degrees the upper half of the tube, in front, hides some of the lower.
  const PolyMesh mesh = test::rotated(test::torus(160, 80), 70 * M_PI / 180, {1, 0, 0});
  with_renderer([&](Renderer& renderer) {
    const RenderedPicture picture = picture_of(renderer, mesh, NamedView::Front, lines_on_flat(), {400, 400});
    const double unit = 400 * 0.88 / 2.8;
    CHECK(dark_runs(picture, 200) == 3);
    const double front_edge = (0.4 - std::cos(70 * M_PI / 180)) * unit;
    CHECK(is_dark(pixel(picture, 200, static_cast<int>(200 + front_edge))));
  });
}

TEST_CASE("a cube's edges are drawn, its faces stay clean") {
  const std::vector<MeshItemPtr> items = {make_mesh_item(test::cube())};
  const PictureSize size{300, 300};
  const Camera camera = frame(bounds_of(items), view_direction(NamedView::Perspective), size.aspect());
  const glm::dmat4 matrix =
      projection_matrix(camera, size.aspect(), depth_range(camera, bounds_of(items))) * view_matrix(camera);
  with_renderer([&](Renderer& renderer) {
    const RenderedPicture picture = render_picture(renderer, items, camera, lines_on_flat(), size);
    const auto at = [&](const glm::dvec3& point) {
      const glm::dvec4 clip = matrix * glm::dvec4(point, 1);
      return pixel(picture, static_cast<int>(150 + 150 * clip.x / clip.w),
                   static_cast<int>(150 - 150 * clip.y / clip.w));
    };
    for (const double along : {0.1, 0.3, 0.5, 0.7, 0.9}) {
      CHECK(is_dark(at({along, 1, 1})));
      CHECK(is_dark(at({1, along, 1})));
      CHECK(is_dark(at({1, 1, along})));
      CHECK_FALSE(is_dark(at({along, 0.4, 1})));
      CHECK_FALSE(is_dark(at({1, along, 0.4})));
      CHECK_FALSE(is_dark(at({0.4, 1, along})));
    }
  });
}

TEST_CASE("a smooth curved surface carries no speckles when it is lit") {
  RenderOptions options;
  options.contour_color = {255, 0, 0, 255};
  const PolyMesh mesh = test::rotated(test::torus(120, 60), 0.6, {1, 0.3, 0});
  with_renderer([&](Renderer& renderer) {
    const RenderedPicture picture = picture_of(renderer, mesh, NamedView::Perspective, options, {400, 300});
    const auto is_line = [](const Color& color) { return color.r > color.g + 90; };
    // Every red pixel has several red neighbours: lines, no dots.
    for (int y = 1; y + 1 < picture.height; ++y) {
      for (int x = 1; x + 1 < picture.width; ++x) {
        if (!is_line(pixel(picture, x, y))) continue;
        int neighbours = 0;
        for (int k = 0; k < 9; ++k) neighbours += is_line(pixel(picture, x + k % 3 - 1, y + k / 3 - 1)) ? 1 : 0;
        CHECK(neighbours >= 3);
      }
    }
  });
}

TEST_CASE("an outline runs beside what is seen of a surface, over all else, and touches nothing more") {
  const int samples = GENERATE(1, 2);
  with_renderer([&](Renderer& renderer) {
    const RenderedPicture plain =
        test::draw_once(renderer, squares(false), test::pixel_camera(outlined_size), outlining(samples), outlined_size);
    CHECK(count_color(plain, orange) == 0);
    const RenderedPicture picture =
        test::draw_once(renderer, squares(true), test::pixel_camera(outlined_size), outlining(samples), outlined_size);
    for (const auto& [x, y] : {std::pair(57, 100), std::pair(142, 100), std::pair(100, 57), std::pair(100, 142)}) {
      CAPTURE(x, y);
      CHECK(pixel(picture, x, y) == orange);
    }
    for (const auto& [x, y] : {std::pair(54, 100), std::pair(145, 100), std::pair(100, 54), std::pair(100, 145)}) {
      CAPTURE(x, y);
      CHECK(pixel(picture, x, y) == black);
    }
    for (const auto& [x, y] : {std::pair(50, 100), std::pair(150, 100), std::pair(100, 100), std::pair(62, 100),
                               std::pair(137, 100), std::pair(10, 10)}) {
      CAPTURE(x, y);
      CHECK(pixel(picture, x, y) == pixel(plain, x, y));
    }
  });
}

TEST_CASE("a covered part has its outline where the cover begins") {
  with_renderer([](Renderer& renderer) {
    Scene scene = squares(true);
    scene.meshes[0].emphasis.outlined = false;
    scene.meshes[1].emphasis.outlined = true;  // partly behind the first one, whose right side is at 140
    const RenderedPicture picture =
        test::draw_once(renderer, scene, test::pixel_camera(outlined_size), outlining(1), outlined_size);
    CHECK(pixel(picture, 137, 100) == orange);
    CHECK(pixel(picture, 97, 50) == orange);
    CHECK(pixel(picture, 120, 100) != orange);
  });
}
