// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "render/picture_probe.h"
#include "support/meshes/mesh_shapes.h"

using namespace croquis;
using namespace croquis::render;
using namespace croquis::test;

namespace {

constexpr PictureSize size = {60, 60};
constexpr Color white = {255, 255, 255, 255}, blue = {0, 0, 255, 255}, red = {255, 0, 0, 255};

/// A square of that side about the picture's middle, at a height over the paper; a unit is a pixel.
PolyMesh square(double side, double height) {
  return test::translated(test::scaled(test::grid(1, 1), side), {30 - side / 2, 30 - side / 2, height});
}

MeshStyle wire_of(MeshStyle style, const Color& color) {
  style.wire_color = color;
  style.wire_width = 2;
  return style;
}

/// A big square before a small one: one mesh, whose own front hides its back.
PolyMesh squares_behind_each_other() { return test::merged(square(40, 10), square(20, 0)); }

RenderOptions options_with(int samples) {
  RenderOptions options = flat_options();
  options.supersampling = samples;
  options.occlusion = samples > 1;
  return options;
}

/// Both ways of drawing: the careful and the quick one.
int any_samples() { return GENERATE(1, 3); }

}  // namespace

TEST_CASE("wire alone has no fill and hides nothing") {
  const int samples = any_samples();
  with_renderer([&](Renderer& renderer) {
    Scene scene;
    scene.meshes.emplace_back(make_mesh_item(squares_behind_each_other()), Emphasis{},
                              wire_of(MeshStyle::wire_only(), blue));
    const RenderedPicture picture = render_picture(renderer, scene, pixel_camera(size), options_with(samples), size);
    CHECK(pixel(picture, 30, 30) == white);
    CHECK(pixel(picture, 30, 15) == white);
    CHECK(pixel(picture, 30, 10) == blue);
    CHECK(pixel(picture, 30, 20) == blue);
    CHECK(count_color(picture, blue) == Approx(4 * 2 * (40 + 20)).epsilon(0.02));
  });
}

TEST_CASE("wire with hidden lines removed has no fill but covers what is behind it") {
  const int samples = any_samples();
  const bool lit = GENERATE(false, true);
  with_renderer([&](Renderer& renderer) {
    Scene scene;
    scene.meshes.emplace_back(make_mesh_item(squares_behind_each_other()), Emphasis{},
                              wire_of(MeshStyle::hidden_lines_removed(), blue));
    scene.points.push_back(
        make_point_item(std::vector<Vec3>{{30, 30, 0}}, {7, red, {}, PointShape::Square, PointDepth::Surfaces}));
    RenderOptions options = options_with(samples);
    if (lit) options.shading = Shading::Clay;
    const RenderedPicture picture = render_picture(renderer, scene, pixel_camera(size), options, size);
    CHECK(pixel(picture, 30, 30) == white);
    CHECK(pixel(picture, 30, 20) == white);
    CHECK(pixel(picture, 30, 10) == blue);
    CHECK(count_color(picture, red) == 0);
    CHECK(count_color(picture, white) == Approx(60 * 60 - 4 * 2 * 40).epsilon(0.01));
  });
}

TEST_CASE("each item has its own wire, its own colour of it, or none") {
  with_renderer([](Renderer& renderer) {
    const auto at = [](double x) { return make_mesh_item(test::translated(square(10, 0), {x, 0, 0})); };
    Scene scene;
    scene.meshes.emplace_back(at(-20), Emphasis{}, MeshStyle::shaded());
    scene.meshes.emplace_back(at(0), Emphasis{}, wire_of(MeshStyle::shaded_wire(), blue));
    scene.meshes.emplace_back(at(20), Emphasis{}, wire_of({}, red));
    RenderOptions options = flat_options();
    options.wire = GENERATE(false, true);
    const RenderedPicture picture = render_picture(renderer, scene, pixel_camera(size), options, size);
    const Color clay = palette_color(0);
    CHECK(pixel(picture, 10, 25) == clay);
    CHECK(pixel(picture, 30, 25) == blue);
    CHECK(pixel(picture, 50, 25) == (options.wire ? red : clay));
    CHECK(pixel(picture, 30, 30) == clay);
  });
}

TEST_CASE("a cage's edges win where they lie in another surface and shine through behind it") {
  const int samples = any_samples();
  with_renderer([&](Renderer& renderer) {
    const double height = GENERATE(0.0, -20.0);
    MeshStyle style = wire_of(MeshStyle::cage(blue), blue);
    style.covered_wire = GENERATE(0.0, 0.5);
    Scene scene;
    scene.meshes.emplace_back(make_mesh_item(square(20, height)), Emphasis{}, style);
    scene.meshes.emplace_back(make_mesh_item(square(40, 0)));
    const RenderedPicture picture = render_picture(renderer, scene, pixel_camera(size), options_with(samples), size);
    const Color clay = palette_color(0);
    const Color half(glm::round(0.5F * (glm::vec4(clay) + glm::vec4(blue))));
    const Color wanted = height == 0 ? blue : style.covered_wire > 0 ? half : clay;
    for (int x = 22; x < 38; ++x) {
      const Color seen = pixel(picture, x, 20);
      CHECK(glm::length(glm::vec4(seen) - glm::vec4(wanted)) < 4);
    }
    CHECK(pixel(picture, 30, 30) == clay);
  });
}

TEST_CASE("emphasis colours the wire of what has no filled faces") {
  with_renderer([](Renderer& renderer) {
    Scene scene;
    scene.meshes.emplace_back(make_mesh_item(square(40, 0)), Emphasis{true, false, false},
                              wire_of(MeshStyle::wire_only(), blue));
    RenderOptions options = flat_options();
    options.emphasis.selected = red;
    const RenderedPicture picture = render_picture(renderer, scene, pixel_camera(size), options, size);
    CHECK(pixel(picture, 30, 10) == red);
    CHECK(count_color(picture, blue) == 0);
  });
}

TEST_CASE("wire too dense to tell its lines apart leaves filled faces as they are") {
  with_renderer([](Renderer& renderer) {
    const PolyMesh dense = test::translated(test::scaled(test::grid(80, 80), 0.5), {10, 10, 0});
    Scene scene;
    scene.meshes.emplace_back(make_mesh_item(dense), Emphasis{}, wire_of(MeshStyle::shaded_wire(), blue));
    CHECK(count_color(render_picture(renderer, scene, pixel_camera(size), flat_options(), size), palette_color(0)) ==
          40 * 40);
    scene.meshes[0].style.surface = SurfaceLook::None;
    CHECK(count_color(render_picture(renderer, scene, pixel_camera(size), flat_options(), size), blue) >= 40 * 40);
    // A dense cage would hide what it stands around.
    scene.meshes[0].style = wire_of(MeshStyle::cage(blue), blue);
    CHECK(count_color(render_picture(renderer, scene, pixel_camera(size), flat_options(), size), blue) == 0);
  });
}
