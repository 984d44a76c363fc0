// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <catch2/catch.hpp>

#include "croquis/render/renderer.h"
#include "render/picture_probe.h"
#include "support/meshes/mesh_shapes.h"

using namespace croquis;
using namespace croquis::render;
using croquis::test::count_color;
using croquis::test::pixel;
using croquis::test::with_renderer;

namespace {

constexpr PictureSize size{200, 200};
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

TEST_CASE("an outline runs beside what is seen of a surface, over all else, and touches nothing more") {
  const int samples = GENERATE(1, 2);
  with_renderer([&](Renderer& renderer) {
    const RenderedPicture plain =
        test::draw_once(renderer, squares(false), test::pixel_camera(size), outlining(samples), size);
    CHECK(count_color(plain, orange) == 0);
    const RenderedPicture picture =
        test::draw_once(renderer, squares(true), test::pixel_camera(size), outlining(samples), size);
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
    const RenderedPicture picture = test::draw_once(renderer, scene, test::pixel_camera(size), outlining(1), size);
    CHECK(pixel(picture, 137, 100) == orange);
    CHECK(pixel(picture, 97, 50) == orange);
    CHECK(pixel(picture, 120, 100) != orange);
  });
}
