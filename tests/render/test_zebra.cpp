// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "render/picture_probe.h"
#include "support/meshes/mesh_shapes.h"

using namespace croquis;
using namespace croquis::render;
using namespace croquis::test;

namespace {

constexpr PictureSize size = {40, 400};

RenderOptions zebra_options(int stripes = 16) {
  RenderOptions options = flat_options();
  options.shading = Shading::Zebra;
  options.zebra_stripes = stripes;
  return options;
}

/// A strip along y from 0 to 400, as wide as the picture, at the height that the function gives; a unit is a pixel.
template <typename Height>
PolyMesh strip(Height height) {
  PolyMesh mesh = test::grid(1, 400);
  for (Vec3& place : mesh.positions) place = {40 * place.x(), place.y(), height(place.y())};
  return mesh;
}

RenderedPicture draw(Renderer& renderer, const PolyMesh& mesh, const RenderOptions& options) {
  Scene scene;
  scene.meshes.emplace_back(make_mesh_item(mesh, {.crease_angle = std::numbers::pi}));
  return render_picture(renderer, scene, pixel_camera(size), options, size);
}

/// Changes between dark and light down the picture's middle, each at its y of the model.
std::vector<int> edges_of_stripes(const RenderedPicture& picture) {
  std::vector<int> edges;
  for (int y = 1; y < size.height; ++y) {
    const bool light = brightness(pixel(picture, 20, size.height - 1 - y)) > 110;
    const bool before = brightness(pixel(picture, 20, size.height - y)) > 110;
    if (light != before) edges.push_back(y);
  }
  return edges;
}

constexpr double radius = 220;

/// A cylinder about an axis along x: its normal turns evenly with the angle from the middle.
double arc(double y) { return std::sqrt(radius * radius - (y - 200) * (y - 200)); }

}  // namespace

TEST_CASE("stripes lie where a mirror would show them") {
  const int stripes = GENERATE(8, 16);
  with_renderer([&](Renderer& renderer) {
    const std::vector<int> edges = edges_of_stripes(draw(renderer, strip(arc), zebra_options(stripes)));
    // The mirrored ray turns twice as fast as the normal; an edge lies at every odd quarter of a stripe.
    std::vector<double> wanted;
    for (int edge = 0; edge < 4 * stripes; ++edge) {
      // All around: up to straight above from the front, then down behind the model.
      const double mirrored = (edge + 0.5 - 2 * stripes) / 2 / stripes * std::numbers::pi;
      const double y = 200 + radius * std::sin(mirrored / 2);
      wanted.push_back(y);
    }
    const auto all_near = [](const auto& these, const auto& those) {
      for (const double place : these) {
        if (place < 6 || place > 394) continue;  // the strip ends there
        INFO(place);
        CHECK(std::any_of(those.begin(), those.end(), [&](double other) { return std::abs(other - place) <= 2.5; }));
      }
    };
    CHECK(edges.size() >= static_cast<std::size_t>(2 * stripes));
    all_near(edges, wanted);
    all_near(wanted, edges);
  });
}

TEST_CASE("a flat surface shows no stripes, a step of curvature bends them, a crease breaks them") {
  with_renderer([](Renderer& renderer) {
    CHECK(edges_of_stripes(draw(renderer, strip([](double) { return 0.0; }), zebra_options())).empty());
    // Left and right of the middle the same slope: where they meet, a crease of 2 * 0.2 jumps over stripes.
    const auto roof = [](double y) { return -0.3 * std::abs(y - 200); };
    const std::vector<int> edges = edges_of_stripes(draw(renderer, strip(roof), zebra_options()));
    for (const int edge : edges) CHECK(std::abs(edge - 200) <= 2);
  });
}

TEST_CASE("stripes are black and white with soft edges, and too many of them are an even grey") {
  with_renderer([](Renderer& renderer) {
    const RenderedPicture picture = draw(renderer, strip(arc), zebra_options());
    int grey = 0;
    for (int y = 5; y < 395; ++y) {
      const int level = brightness(pixel(picture, 20, y));
      if (level > 70 && level < 170) ++grey;
    }
    CHECK(grey > 5);
    CHECK(grey < 60);
    CHECK(count_pixels(picture, [](const Color& c) { return brightness(c) < 50; }) > 40 * 100);
    CHECK(count_pixels(picture, [](const Color& c) { return brightness(c) > 190; }) > 40 * 100);

    const auto ripples = [](double y) { return 0.8 * std::sin(y * 2.0); };
    RenderOptions dense = zebra_options(200);
    dense.supersampling = 1;
    const RenderedPicture noise = draw(renderer, strip(ripples), dense);
    double least = 255, most = 0;
    for (int y = 20; y < 380; ++y) {
      least = std::min<double>(least, brightness(pixel(noise, 20, y)));
      most = std::max<double>(most, brightness(pixel(noise, 20, y)));
    }
    CHECK(most - least < 110);
  });
}

TEST_CASE("stripes stand still while the model turns below them about the line of sight's level") {
  with_renderer([](Renderer& renderer) {
    // A ball looks the same from everywhere: the room stands with the camera.
    const PolyMesh ball = test::uv_sphere(128, 64);
    const RenderedPicture front = picture_of(renderer, ball, NamedView::Front, zebra_options(), {120, 120});
    const RenderedPicture side = picture_of(renderer, ball, NamedView::Side, zebra_options(), {120, 120});
    int different = 0;
    for (int y = 0; y < 120; ++y) {
      for (int x = 0; x < 120; ++x)
        different += std::abs(brightness(pixel(front, x, y)) - brightness(pixel(side, x, y))) > 40 ? 1 : 0;
    }
    CHECK(different < 100);
  });
}
