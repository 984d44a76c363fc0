// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "render/picture_probe.h"
#include "support/meshes/mesh_shapes.h"

using namespace croquis;
using namespace croquis::render;
using namespace croquis::test;

namespace {

constexpr PictureSize size = {80, 60};
constexpr Color violet = {90, 20, 110, 255}, yellow = {255, 210, 0, 255}, black = {0, 0, 0, 255};

PointStyle style_of(double points_size, PointShape shape = PointShape::Square) {
  PointStyle style;
  style.size = points_size;
  style.color = violet;
  style.shape = shape;
  return style;
}

Scene points_alone(const PointItemPtr& points) {
  Scene scene;
  scene.points.push_back(points);
  return scene;
}

/// Leftmost and rightmost column, lowest and highest row with that colour.
struct Extent {
  int left = 1 << 20, right = -1, top = 1 << 20, bottom = -1;
};

Extent extent_of(const RenderedPicture& picture, const Color& color) {
  Extent extent;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      if (pixel(picture, x, y) != color) continue;
      extent = {std::min(extent.left, x), std::max(extent.right, x), std::min(extent.top, y),
                std::max(extent.bottom, y)};
    }
  }
  return extent;
}

}  // namespace

TEST_CASE("points are crisp squares of exactly their size wherever they lie between pixels") {
  const int side = GENERATE(1, 4, 5);
  const double ratio = GENERATE(1.0, 2.0);
  with_renderer([&](Renderer& renderer) {
    const std::vector<Vec3> places = {{10, 10, 0}, {30.3, 10.7, 0}, {50.5, 40.5, 0}, {70.9, 50.2, 0}};
    const RenderedPicture picture =
        pixel_picture(renderer, points_alone(make_point_item(places, style_of(side))), size, ratio);
    const int drawn = static_cast<int>(side * ratio);
    CHECK(count_color(picture, violet) == 4 * drawn * drawn);
    CHECK(pixel(picture, 30, 59 - 10) == violet);
  });
}

TEST_CASE("discs are round, and an outline lies inside the size") {
  with_renderer([](Renderer& renderer) {
    PointStyle style = style_of(21, PointShape::Disc);
    style.outline = black;
    const std::vector<Vec3> places = {{40, 30, 0}};
    const RenderedPicture picture = pixel_picture(renderer, points_alone(make_point_item(places, style)), size);
    const Extent extent = extent_of(picture, violet);
    CHECK(extent.right - extent.left == 18);
    CHECK(extent.bottom - extent.top == 18);
    CHECK(count_color(picture, violet) == Approx(M_PI * 9.5 * 9.5).epsilon(0.05));
    CHECK(ink_of_all(picture) > 0.5 * M_PI * 10 * 10);
  });
}

TEST_CASE("a hidden vertex is covered whole, one on the surface or its rim is seen whole") {
  const int samples = GENERATE(1, 3);
  with_renderer([&](Renderer& renderer) {
    const PolyMesh box = test::translated(test::scaled(test::cube(), 40), {20, 10, -40});
    Scene scene;
    scene.meshes.emplace_back(make_mesh_item(box));
    RenderOptions options = flat_options();
    options.supersampling = samples;
    const auto drawn = [&](const Vec3& place, PointDepth depth) {
      PointStyle style = style_of(5);
      style.depth = depth;
      scene.points = {make_point_item(std::vector<Vec3>{place}, style)};
      return count_color(render_picture(renderer, scene, pixel_camera(size), options, size), violet);
    };
    CHECK(drawn({40, 30, 0}, PointDepth::Surfaces) == 25);
    CHECK(drawn({20, 10, 0}, PointDepth::Surfaces) == 25);
    CHECK(drawn({60, 50, 0}, PointDepth::Surfaces) == 25);
    CHECK(drawn({40, 30, -40}, PointDepth::Surfaces) == 0);
    CHECK(drawn({58, 30, -40}, PointDepth::Surfaces) == 0);
    CHECK(drawn({70, 30, -40}, PointDepth::Surfaces) == 25);
    CHECK(drawn({40, 30, -40}, PointDepth::OnTop) == 25);
  });
}

TEST_CASE("all vertices on the near side of a sphere are seen and none of the far side") {
  with_renderer([](Renderer& renderer) {
    const PolyMesh sphere = test::translated(test::scaled(test::uv_sphere(10, 9), 25), {40, 30, 0});
    Scene scene;
    scene.meshes.emplace_back(make_mesh_item(sphere));
    for (const Vec3& place : sphere.positions) {
      if (std::abs(place.z()) < 6) continue;  // the rim belongs to both sides
      scene.points = {make_point_item(std::vector<Vec3>{place}, style_of(3))};
      CHECK(count_color(pixel_picture(renderer, scene, size), violet) == (place.z() > 0 ? 9 : 0));
    }
  });
}

TEST_CASE("points have colours of their own, or some places are chosen, later ones over earlier ones") {
  with_renderer([](Renderer& renderer) {
    const std::vector<Vec3> places = {{20, 30, 0}, {22, 30, 0}, {60, 30, 0}};
    const std::vector<Color> colors = {violet, yellow, black};
    const RenderedPicture all =
        pixel_picture(renderer, points_alone(make_point_item(places, style_of(6), colors)), size);
    CHECK(count_color(all, violet) == 12);
    CHECK(count_color(all, yellow) == 36);
    CHECK(count_color(all, black) == 36);
    const RenderedPicture chosen =
        pixel_picture(renderer, points_alone(make_point_item(places, std::vector<Index>{2, 0}, style_of(6))), size);
    CHECK(count_color(chosen, violet) == 72);
    const Extent extent = extent_of(chosen, violet);
    CHECK(extent.left == 17);
    CHECK(extent.right == 62);
  });
}

TEST_CASE("very many points are one transfer of twelve bytes each, or slices of it") {
  with_renderer([](Renderer& renderer) {
    const PolyMesh mesh = test::torus(500, 400);
    const PointItemPtr item = make_point_item(mesh.positions, style_of(2));
    const Scene scene = points_alone(item);
    const Camera camera = frame(item->bounds, view_direction(NamedView::Perspective), size.aspect());
    RenderOptions options = flat_options();
    options.upload_budget = 1'000'000;
    RenderedPicture picture;
    int drawings = 0;
    do {
      picture = draw_once(renderer, scene, camera, options, size);
      ++drawings;
    } while (renderer.pending() && drawings < 50);
    CHECK(drawings == 3);
    CHECK(renderer.uploaded().bytes == 200'000 * 12);
    Renderer other;
    CHECK(picture.rgba == render_picture(other, scene, camera, flat_options(), size).rgba);
    CHECK(other.uploaded().transfers == 1);
  });
}

TEST_CASE("points that can not be drawn are refused by name") {
  std::vector<Vec3> places = {{0, 0, 0}, {1, 0, 0}};
  CHECK_THROWS_AS(make_point_item(places, style_of(3), std::vector<Color>(1)), Error);
  CHECK_THROWS_AS(make_point_item(places, std::vector<Index>{2}), Error);
  places[1].x() = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(make_point_item(places), Error);
  CHECK_THROWS_AS(make_point_item(places, std::vector<Index>{1}), Error);
  CHECK(make_point_item(places, std::vector<Index>{0})->places.size() == 1);
}
