// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
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

constexpr Color black = {0, 0, 0, 255};

Mark mark_at(const glm::dvec3& place, MarkShape shape, float size) {
  Mark mark;
  mark.position = place;
  mark.shape = shape;
  mark.size = size;
  mark.color = black;
  mark.outline = {0, 0, 0, 0};
  return mark;
}

Scene scene_of(const Mark& mark, MarkDepth depth = MarkDepth::OnTop) {
  Scene scene;
  scene.marks.emplace_back(make_mark_item(std::vector<Mark>{mark}, depth));
  return scene;
}

/// Middle of all ink, from the upper left corner.
glm::dvec2 middle_of_ink(const RenderedPicture& picture) {
  glm::dvec2 sum(0);
  for (int x = 0; x < picture.width; ++x) {
    for (int y = 0; y < picture.height; ++y) sum += ink(picture, x, y) * glm::dvec2(x + 0.5, y + 0.5);
  }
  return sum / ink_of_all(picture);
}

double contrast(const Color& a, const Color& b) {
  const auto luminance = [](const Color& color) {
    const auto linear = [](int value) { return std::pow(value / 255.0, 2.2); };
    return 0.2126 * linear(color.r) + 0.7152 * linear(color.g) + 0.0722 * linear(color.b);
  };
  const double la = luminance(a) + 0.05, lb = luminance(b) + 0.05;
  return la > lb ? la / lb : lb / la;
}

}  // namespace

TEST_CASE("marks stand with their middle at their place") {
  const MarkShape shape =
      GENERATE(MarkShape::Disc, MarkShape::Ring, MarkShape::Square, MarkShape::Cross, MarkShape::OverUnder);
  const double ratio = GENERATE(1.0, 2.0);
  with_renderer([&](Renderer& renderer) {
    const RenderedPicture picture =
        pixel_picture(renderer, scene_of(mark_at({31.3, 27.8, 5}, shape, 14)), {64, 60}, ratio);
    CHECK(glm::distance(middle_of_ink(picture), glm::dvec2(31.3, 60 - 27.8)) < 0.06);
  });
}

TEST_CASE("a warning's triangle holds its place and its exclamation mark") {
  with_renderer([](Renderer& renderer) {
    const RenderedPicture picture =
        pixel_picture(renderer, scene_of(mark_at({32, 32, 0}, MarkShape::Warning, 40)), {64, 64});
    CHECK(glm::distance(middle_of_ink(picture), glm::dvec2(32, 32)) < 5);
    CHECK(ink(picture, 32, 30) < 0.1);
    CHECK(ink(picture, 26, 36) > 0.9);
  });
}

TEST_CASE("a disc's area follows its size and the pixel ratio") {
  const double ratio = GENERATE(1.0, 1.5, 2.0);
  with_renderer([&](Renderer& renderer) {
    const RenderedPicture picture =
        pixel_picture(renderer, scene_of(mark_at({32, 32, 0}, MarkShape::Disc, 16)), {64, 64}, ratio);
    CHECK(ink_of_all(picture) == Approx(M_PI * 64 * ratio * ratio).epsilon(0.01));
  });
}

TEST_CASE("marks keep their size near and far") {
  with_renderer([](Renderer& renderer) {
    Camera camera;
    camera.projection = Projection::Perspective;
    camera.eye = {0, 0, 10};
    for (const double z : {8.0, 0.0, -500.0}) {
      const RenderedPicture picture =
          render_picture(renderer, scene_of(mark_at({0, 0, z}, MarkShape::Disc, 16)), camera, flat_options(), {64, 64});
      CHECK(ink_of_all(picture) == Approx(M_PI * 64).epsilon(0.01));
    }
    const Scene behind = scene_of(mark_at({0, 0, 11}, MarkShape::Disc, 16));
    CHECK(ink_of_all(render_picture(renderer, behind, camera, flat_options(), {64, 64})) == 0);
  });
}

TEST_CASE("the upper bar runs through, the lower one stops at either side") {
  with_renderer([](Renderer& renderer) {
    Mark mark = mark_at({50, 50, 0}, MarkShape::OverUnder, 60);
    mark.angle = 0.5F;
    mark.under_angle = 0.5F + 1.2F;
    const RenderedPicture picture = pixel_picture(renderer, scene_of(mark), {100, 100});
    const auto along = [&](double angle, double way) {
      return ink(picture, static_cast<int>(50 + way * std::cos(angle)), static_cast<int>(50 - way * std::sin(angle)));
    };
    int gap = 0;
    for (int way = -26; way <= 26; ++way) {
      CHECK(along(0.5, way) > 0.9);
      gap += along(0.5 + 1.2, way) < 0.1 ? 1 : 0;
    }
    CHECK(gap >= 6);
    for (const int way : {-24, -20, 20, 24}) CHECK(along(0.5 + 1.2, way) > 0.9);
  });
}

TEST_CASE("with their outline marks can be read on light and on dark") {
  with_renderer([](Renderer& renderer) {
    for (const Color& background : {Color(252, 251, 248, 255), Color(30, 32, 38, 255)}) {
      RenderOptions options = flat_options();
      options.background_top = options.background_bottom = background;
      Mark mark = mark_at({20, 20, 0}, MarkShape::Disc, 12);
      mark.color = Mark().color;
      mark.outline = Mark().outline;
      const RenderedPicture picture =
          render_picture(renderer, scene_of(mark), pixel_camera({40, 40}), options, {40, 40});
      double best = 0;
      for (int x = 0; x < 40; ++x) best = std::max(best, contrast(pixel(picture, x, 20), background));
      CHECK(best > 4.5);
    }
  });
}

TEST_CASE("a halo lies outside the mark and emphasis gives one to all") {
  with_renderer([](Renderer& renderer) {
    Mark mark = mark_at({32, 32, 0}, MarkShape::Square, 16);
    mark.halo = {255, 0, 0, 255};
    mark.halo_width = 5;
    Scene scene = scene_of(mark);
    const RenderedPicture picture = pixel_picture(renderer, scene, {64, 64});
    CHECK(pixel(picture, 32, 32) == black);
    CHECK(pixel(picture, 42, 32) == Color(255, 0, 0, 255));
    CHECK(pixel(picture, 46, 32) == Color(255, 255, 255, 255));

    scene = scene_of(mark_at({32, 32, 0}, MarkShape::Square, 16));
    scene.marks[0].emphasis.hovered = true;
    const Color glow = pixel(pixel_picture(renderer, scene, {64, 64}), 40, 32);
    CHECK(glow.b > glow.r + 60);
  });
}

TEST_CASE("a surface before its place hides a tested mark as a whole") {
  with_renderer([](Renderer& renderer) {
    for (const double z : {-20.0, 0.0, 20.0}) {
      Scene scene = scene_of(mark_at({32, 32, z}, MarkShape::Disc, 16), MarkDepth::Tested);
      scene.meshes.emplace_back(make_mesh_item(test::scaled(test::grid(2, 2), 32)));
      const RenderedPicture picture = pixel_picture(renderer, scene, {64, 64});
      CHECK((pixel(picture, 32, 32) == black) == (z >= 0));
      scene.marks[0] = make_mark_item(std::vector<Mark>{mark_at({32, 32, z}, MarkShape::Disc, 16)});
      CHECK(pixel(pixel_picture(renderer, scene, {64, 64}), 32, 32) == black);
    }
  });
}

TEST_CASE("marks that can't be drawn are all named") {
  Mark bad;
  bad.angle = std::numeric_limits<float>::infinity();
  try {
    make_mark_item(std::vector<Mark>{Mark(), bad, Mark(), bad});
    FAIL("accepted");
  } catch (const Error& error) {
    REQUIRE(error.findings().size() == 2);
    CHECK(error.findings()[0].subjects[0].index == 1);
  }
}
