// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "render/picture_probe.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"

using namespace croquis;
using namespace croquis::render;
using namespace croquis::test;

namespace {

constexpr Color black = {0, 0, 0, 255}, red = {255, 0, 0, 255}, blue = {0, 0, 255, 255}, white = {255, 255, 255, 255};

LinePath path(std::vector<glm::dvec3> places, bool closed = false) { return line_through(places, closed); }

Scene scene_of(const LinePath& line, const LineStyle& style) {
  Scene scene;
  scene.lines.emplace_back(make_line_item(line, style));
  return scene;
}

/// A straight line as a pen gives it: far more points than pixels, shaking by a tenth of a pixel.
LinePath shaky_line(const glm::dvec2& from, const glm::dvec2& to, int count) {
  Random random(3);
  LinePath line;
  for (int i = 0; i < count; ++i) {
    const glm::dvec2 place = glm::mix(from, to, i / (count - 1.0));
    line.points.push_back(
        {{place.x + random.between(-0.1, 0.1), place.y + random.between(-0.1, 0.1), 0}, 1, std::nullopt});
  }
  return line;
}

}  // namespace

TEST_CASE("a line is as wide as its style says, at every pixel ratio and slope") {
  const double width = GENERATE(1.0, 2.0, 3.25, 12.0);
  const double ratio = GENERATE(1.0, 1.5, 2.0);
  const double slope = GENERATE(0.0, 0.31, 1.0);
  with_renderer([&](Renderer& renderer) {
    const LinePath line = path({{-50, 40.3 - 50 * slope, 0}, {150, 40.3 + 150 * slope, 0}});
    const RenderedPicture picture = pixel_picture(renderer, scene_of(line, {width, black, {}, {}}), {60, 120}, ratio);
    for (const int x : {5, 20, 30}) {
      CHECK(ink_of_column(picture, x) ==
            Approx(width * ratio * std::sqrt(1 + slope * slope)).epsilon(0.04).margin(0.05));
    }
  });
}

TEST_CASE("a line thinner than a pixel is fainter, not gone") {
  with_renderer([](Renderer& renderer) {
    const LinePath line = path({{-5, 20.5, 0}, {50, 20.5, 0}});
    const RenderedPicture picture = pixel_picture(renderer, scene_of(line, {0.4, black, {}, {}}), {40, 40});
    CHECK(ink_of_column(picture, 20) == Approx(0.4).margin(0.02));
  });
}

TEST_CASE("a single point is a round dot and ends are round") {
  with_renderer([](Renderer& renderer) {
    const RenderedPicture dot = pixel_picture(renderer, scene_of(path({{30, 30, 0}}), {20, black, {}, {}}), {60, 60});
    CHECK(ink_of_all(dot) == Approx(M_PI * 100).epsilon(0.01));
    const LinePath segment = path({{20, 30, 0}, {60, 30, 0}});
    const RenderedPicture line = pixel_picture(renderer, scene_of(segment, {20, black, {}, {}}), {80, 60});
    CHECK(ink_of_all(line) == Approx(M_PI * 100 + 40 * 20).epsilon(0.01));
  });
}

TEST_CASE("a pen's pressure widens the line from point to point") {
  with_renderer([](Renderer& renderer) {
    LinePath line = path({{-10, 30, 0}, {110, 30, 0}});
    line.points[0].width_factor = 0;
    const RenderedPicture picture = pixel_picture(renderer, scene_of(line, {24, black, {}, {}}), {100, 60});
    for (const int x : {20, 50, 80}) {
      CHECK(ink_of_column(picture, x) == Approx(24 * (x + 10.5) / 120).epsilon(0.05));
    }
  });
}

TEST_CASE("dashes are as long as asked for, from the line's start on and around its corners") {
  const double ratio = GENERATE(1.0, 2.0);
  with_renderer([&](Renderer& renderer) {
    LineStyle style{2, black, {12, 8, 0, 0}, {}};
    const double y = 90;
    const LinePath corner = path({{10, y, 0}, {105, y, 0}, {105, 10, 0}});
    const RenderedPicture picture = pixel_picture(renderer, scene_of(corner, style), {120, 100}, ratio);
    const double on = 12 * ratio, period = 20 * ratio;
    const auto drawn = [&](double length) { return std::fmod(length, period) < on; };
    for (double length = 0.5; length < 170; length += 1) {
      const double in_period = std::fmod(length, period);
      const bool near_end = std::min({in_period, std::abs(in_period - on), period - in_period}) < 1.5 * ratio;
      if (near_end || std::abs(length - 95) < 2 * ratio) continue;
      const int x = static_cast<int>(length < 95 ? 10 + length : 105);
      const int row = static_cast<int>(length < 95 ? 100 - y : 10 + length - 95);
      INFO("after " << length << " pixels");
      CHECK((ink(picture, x, row) > 0.9) == drawn(length));
      CHECK((ink(picture, x, row) < 0.1) == !drawn(length));
    }
  });
}

TEST_CASE("the ink of dashes is their share of the whole line's") {
  with_renderer([](Renderer& renderer) {
    LineStyle style{1, black, {9, 3, 2, 6}, {}};
    const LinePath line = path({{10, 20.5, 0}, {10 + 20 * 10, 20.5, 0}});
    const RenderedPicture picture = pixel_picture(renderer, scene_of(line, style), {230, 40});
    CHECK(ink_of_all(picture) == Approx(10 * 11).epsilon(0.03));
  });
}

TEST_CASE("dashes shorter than the line is wide are round dots") {
  with_renderer([](Renderer& renderer) {
    const LinePath line = path({{10, 20.5, 0}, {10 + 16 * 10, 20.5, 0}});
    const RenderedPicture picture = pixel_picture(renderer, scene_of(line, {8, black, {1, 15, 0, 0}, {}}), {200, 40});
    CHECK(ink(picture, 10 + 16, 20) > 0.9);
    CHECK(ink_of_column(picture, 10 + 8) == 0);
    // Ten dots, and the one that would follow at the line's end shows its half, cut round.
    CHECK(ink_of_all(picture) == Approx(10.5 * M_PI * 16).epsilon(0.05));
  });
}

TEST_CASE("a half transparent line is even, however many points it has and wherever it crosses itself") {
  with_renderer([](Renderer& renderer) {
    const LineStyle style{10, {0, 0, 0, 128}, {}, {}};
    LinePath line = shaky_line({-20, 30}, {120, 30}, 2000);
    const LinePath back = shaky_line({120, 10}, {20, 80}, 2000);
    line.points.insert(line.points.end(), back.points.begin(), back.points.end());
    const RenderedPicture picture = pixel_picture(renderer, scene_of(line, style), {100, 60});
    double most = 0;
    for (int x = 0; x < 100; ++x) {
      for (int y = 0; y < 60; ++y) most = std::max(most, ink(picture, x, y));
    }
    CHECK(most == Approx(128 / 255.0).margin(0.005));
    CHECK(ink(picture, 15, 30) == Approx(128 / 255.0).margin(0.005));
    CHECK(ink_of_column(picture, 8) == Approx(10 * 128 / 255.0).epsilon(0.05));
  });
}

TEST_CASE("of an item's lines the later one of another colour lies on top") {
  with_renderer([](Renderer& renderer) {
    std::vector<LinePath> lines = {path({{0, 20, 0}, {40, 20, 0}}), path({{20, 0, 0}, {20, 40, 0}})};
    for (LinePoint& point : lines[0].points) point.color = red;
    for (LinePoint& point : lines[1].points) point.color = blue;
    Scene scene;
    scene.lines.emplace_back(make_line_item(lines, {8, black, {}, {}}));
    CHECK(pixel(pixel_picture(renderer, scene, {40, 40}), 20, 20) == blue);
    std::swap(lines[0], lines[1]);
    scene.lines[0] = make_line_item(lines, {8, black, {}, {}});
    CHECK(pixel(pixel_picture(renderer, scene, {40, 40}), 20, 20) == red);
    CHECK(pixel(pixel_picture(renderer, scene, {40, 40}), 20, 5) == blue);
  });
}

TEST_CASE("a thousand lines of alternating colours are all drawn in their own") {
  with_renderer([](Renderer& renderer) {
    std::vector<LinePath> lines;
    for (int i = 0; i < 1000; ++i) {
      const double x = i % 50 * 4 + 2, y = i / 50 * 4 + 2;
      lines.push_back(path({{x, y, 0}}));
      lines.back().points[0].color = i % 2 == 0 ? red : blue;
    }
    Scene scene;
    scene.lines.emplace_back(make_line_item(lines, {3, black, {}, {}}));
    CHECK(scene.lines[0].item->runs.size() == 1000);
    const RenderedPicture picture = pixel_picture(renderer, scene, {200, 80});
    int wrong = 0;
    for (int i = 0; i < 1000; ++i) {
      wrong += pixel(picture, i % 50 * 4 + 2, 79 - (i / 50 * 4 + 2)) == (i % 2 == 0 ? red : blue) ? 0 : 1;
    }
    CHECK(wrong == 0);
  });
}

TEST_CASE("surfaces hide tested lines behind them and none on top, and lines in a surface are seen") {
  const Projection projection = GENERATE(Projection::Orthographic, Projection::Perspective);
  with_renderer([&](Renderer& renderer) {
    Scene scene;
    scene.meshes.emplace_back(make_mesh_item(test::scaled(test::grid(2, 2), 50)));
    const auto add = [&](double y, double z, LineDepth depth) {
      scene.lines.emplace_back(make_line_item(path({{-50, y, z}, {150, y, z}}), {4, red, {}, depth}));
    };
    add(20, -10, LineDepth::Tested);
    add(40, -10, LineDepth::OnTop);
    add(60, 0, LineDepth::Tested);
    add(80, 10, LineDepth::Tested);
    Camera camera = pixel_camera({100, 100});
    camera.projection = projection;
    camera.eye.z = 1000;
    camera.field_of_view = 2 * std::atan(50.0 / 1000);
    const RenderedPicture picture = render_picture(renderer, scene, camera, flat_options(), {100, 100});
    CHECK(pixel(picture, 50, 80) == palette_color(0));
    CHECK(pixel(picture, 50, 60) == red);
    CHECK(pixel(picture, 50, 40) == red);
    CHECK(pixel(picture, 50, 20) == red);
  });
}

TEST_CASE("a line through a perspective eye is cut off before it") {
  with_renderer([](Renderer& renderer) {
    Camera camera;
    camera.projection = Projection::Perspective;
    camera.eye = {0, 0, 5};
    const LinePath line = path({{-1, 0, -5}, {1, 0, 25}});
    const RenderedPicture picture =
        render_picture(renderer, scene_of(line, {6, black, {8, 5, 0, 0}, {}}), camera, flat_options(), {120, 80});
    CHECK(ink_of_all(picture) > 20);
    const LinePath behind = path({{-1, 0, 6}, {1, 0, 25}});
    CHECK(ink_of_all(
              render_picture(renderer, scene_of(behind, {6, black, {}, {}}), camera, flat_options(), {120, 80})) == 0);
  });
}

TEST_CASE("emphasis shows around a line without a new item") {
  with_renderer([](Renderer& renderer) {
    Scene scene = scene_of(path({{0, 20.5, 0}, {60, 20.5, 0}}), {3, black, {}, {}});
    const auto glow_at = [&](const Emphasis& emphasis) {
      scene.lines[0].emphasis = emphasis;
      return pixel(pixel_picture(renderer, scene, {60, 40}), 30, 16);
    };
    CHECK(glow_at({}) == white);
    const Color selected = glow_at({true, false, false});
    const Color hovered = glow_at({false, true, false});
    CHECK(selected.r > selected.b + 100);
    CHECK(hovered.b > hovered.r + 80);
    scene.lines[0].emphasis = {false, false, true};
    CHECK(ink(pixel_picture(renderer, scene, {60, 40}), 30, 19) == Approx(0.45).margin(0.02));
  });
}

TEST_CASE("lines that can't be drawn are all named") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<LinePath> lines = {path({{0, nan, 0}}), path({{0, 0, 0}}), path({{0, 0, 0}, {HUGE_VAL, 0, 0}})};
  try {
    make_line_item(lines);
    FAIL("accepted");
  } catch (const Error& error) {
    REQUIRE(error.findings().size() == 2);
    CHECK(error.findings()[0].code == "E_NOT_FINITE");
    CHECK(error.findings()[1].subjects[0].index == 2);
  }
}

TEST_CASE("lines of one colour in a row are one shape; nothing and empty lines are none") {
  CHECK(make_line_item(std::vector<LinePath>{})->runs.empty());
  CHECK(make_line_item(std::vector<LinePath>{{}, {}})->corners.empty());
  const std::vector<LinePath> lines = {
      path({{0, 0, 0}, {1, 0, 0}}), {}, path({{2, 0, 0}}), path({{3, 0, 0}, {4, 1, 0}}, true)};
  const LineItemPtr item = make_line_item(lines);
  REQUIRE(item->runs.size() == 1);
  CHECK(item->runs[0].count == 2 + 2 + 3);
  CHECK(item->bounds.max == glm::dvec3(4, 1, 0));
}

TEST_CASE("lines far from the origin keep their place to a fraction of a pixel") {
  with_renderer([](Renderer& renderer) {
    const glm::dvec3 far_away(1e9, -2e9, 0);
    const LinePath line = path({far_away + glm::dvec3(0, 20.25, 0), far_away + glm::dvec3(40, 20.25, 0)});
    Camera camera = pixel_camera({40, 40});
    camera.eye += far_away;
    camera.target += far_away;
    const RenderedPicture picture =
        render_picture(renderer, scene_of(line, {2, black, {}, {}}), camera, flat_options(), {40, 40});
    CHECK(ink(picture, 20, 20) == Approx(0.75).margin(0.02));
    CHECK(ink(picture, 20, 19) == Approx(1).margin(0.02));
    CHECK(ink(picture, 20, 18) == Approx(0.25).margin(0.02));
  });
}
