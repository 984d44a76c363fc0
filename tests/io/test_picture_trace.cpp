// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/geometry/polyline.h"
#include "croquis/io/picture_trace.h"
#include "support/pictures/drawn_picture.h"
#include "support/random.h"

namespace croquis::test {
namespace {

Picture picture_of(const std::vector<InkLine>& lines, const PictureLook& look = {}) {
  return {look.width, look.height, drawn_pixels(lines, look)};
}

Drawing traced(const Picture& picture) {
  Progress progress;
  return trace_picture(picture, "sheet.png", progress);
}

Drawing traced(const std::vector<InkLine>& lines, const PictureLook& look = {}) {
  return traced(picture_of(lines, look));
}

std::string refusal_of(const Picture& picture) {
  try {
    traced(picture);
  } catch (const Error& error) {
    return error.findings().front().code;
  }
  return "";
}

/// The largest distance of points of one line from another one.
double deviation(const InkLine& from, const InkLine& to) {
  double largest = 0;
  for (const Vec2& point : from.points) {
    double least = 1e9;
    for (std::size_t i = 0; i + (to.closed ? 0 : 1) < to.points.size(); ++i) {
      const Vec2 &a = to.points[i], &b = to.points[(i + 1) % to.points.size()];
      least = std::min(least, (a + nearest_parameter(point, a, b) * (b - a) - point).norm());
    }
    largest = std::max(largest, least);
  }
  return largest;
}

double distance_between(const InkLine& a, const InkLine& b) { return std::max(deviation(a, b), deviation(b, a)); }

/// A stroke as it lies on the sheet, with more points on long pieces.
InkLine on_sheet(const Stroke& stroke) {
  InkLine line{{}, stroke.closed};
  for (const StrokeSample& sample : stroke.samples) line.points.emplace_back(sample.position.x(), -sample.position.y());
  return line;
}

/// Points at most 2 units apart.
InkLine dense(const InkLine& line) {
  InkLine result{{}, line.closed};
  for (std::size_t i = 0; i + (line.closed ? 0 : 1) < line.points.size(); ++i) {
    const Vec2 &a = line.points[i], &b = line.points[(i + 1) % line.points.size()];
    const int count = std::max(1, static_cast<int>((b - a).norm() / 2));
    for (int k = 0; k < count; ++k) result.points.emplace_back(a + k * (b - a) / count);
  }
  if (!line.closed) result.points.push_back(line.points.back());
  return result;
}

/// How far the strokes are from the lines, each from the one nearest to it; large where they differ in number or in
/// which are closed.
double distance_between(const Drawing& drawing, const std::vector<InkLine>& lines) {
  if (drawing.strokes.size() != lines.size()) return 1e9;
  double largest = 0;
  for (const InkLine& line : lines) {
    double least = 1e9;
    for (const Stroke& stroke : drawing.strokes) {
      if (stroke.closed == line.closed) least = std::min(least, distance_between(on_sheet(stroke), dense(line)));
    }
    largest = std::max(largest, least);
  }
  return largest;
}

std::vector<InkLine> lines_of(const Drawing& drawing) {
  std::vector<InkLine> lines;
  for (const Stroke& stroke : drawing.strokes) lines.push_back(on_sheet(stroke));
  return lines;
}

InkLine wave(const Vec2& start, double length, double height) {
  InkLine line;
  for (int i = 0; i <= 60; ++i) line.points.emplace_back(start + Vec2(length * i / 60, height * std::sin(i * 0.2)));
  return line;
}

/// Lines of a sheet that is 1000 by 750 units large, clear of its border.
std::vector<InkLine> some_lines() {
  return {ink_circle({330, 330}, 130), wave({560, 250}, 240, 40), ink_line({{180, 580}, {300, 520}, {420, 600}}),
          ink_line({{560, 420}, {760, 420}, {760, 560}, {560, 560}}, true), ink_circle({300, 300}, 30)};
}

PictureLook phone_photo() {
  PictureLook look;
  look.fading = 0.4;
  look.shadow = 0.4;
  look.shadow_edge = 4;
  look.desk = 60;
  look.noise = 0.02;
  return look;
}

/// The picture with its pixels elsewhere. @param from where the new pixel's value comes from
Picture moved(const Picture& picture, bool transposes, bool mirrors) {
  Picture result = picture;
  if (transposes) std::swap(result.width, result.height);
  for (int y = 0; y < result.height; ++y) {
    for (int x = 0; x < result.width; ++x) {
      const int column = mirrors ? result.width - 1 - x : x;
      const int from = transposes ? column * picture.width + y : y * picture.width + column;
      for (int c = 0; c < 4; ++c) {
        const auto to = static_cast<std::size_t>(4 * (y * result.width + x) + c);
        result.rgba[to] = picture.rgba[static_cast<std::size_t>(4 * from + c)];
      }
    }
  }
  return result;
}

Picture plain(double brightness, double noise) {
  PictureLook look;
  look.paper = brightness;
  look.noise = noise;
  return picture_of({}, look);
}

}  // namespace

TEST_CASE("lines come back within a pixel, closed where they are, from scans and screenshots") {
  for (const double width : {2.0, 5.0, 9.0}) {
    PictureLook look;
    look.line_width = width;
    INFO("line width " << width);
    CHECK(distance_between(traced(some_lines(), look), some_lines()) < 1.5 + width / 10);
  }
}

TEST_CASE("uneven light, a shadow's edge, grain and a dark desk around the sheet give no strokes") {
  CHECK(distance_between(traced(some_lines(), phone_photo()), some_lines()) < 1.7);
  PictureLook pencil = phone_photo();
  pencil.ink = 0.5;
  CHECK(distance_between(traced(some_lines(), pencil), some_lines()) < 1.7);
  PictureLook soft = phone_photo();
  soft.shadow_edge = 60;
  CHECK(distance_between(traced(some_lines(), soft), some_lines()) < 1.7);
}

TEST_CASE("the lines of squared paper are no strokes where the drawing is far darker") {
  PictureLook squared = phone_photo();
  squared.squares = 0.3;
  CHECK(distance_between(traced(some_lines(), squared), some_lines()) < 2);
}

TEST_CASE("the same sheet gives the same drawing whatever its pixels") {
  PictureLook large = phone_photo();
  large.width = 3200;
  large.height = 2400;
  CHECK(distance_between(traced(some_lines(), large), lines_of(traced(some_lines(), phone_photo()))) < 1.5);
}

TEST_CASE("a picture that is rotated or mirrored gives a drawing that is") {
  const Picture picture = picture_of(some_lines(), phone_photo());
  const Drawing drawing = traced(picture);
  for (const bool transposes : {false, true}) {
    for (const bool mirrors : {false, true}) {
      std::vector<InkLine> lines = lines_of(drawing);
      for (InkLine& line : lines) {
        for (Vec2& point : line.points) {
          if (transposes) std::swap(point.x(), point.y());
          if (mirrors) point.x() = (transposes ? 750 : 1000) - point.x();
        }
      }
      CHECK(distance_between(traced(moved(picture, transposes, mirrors)), lines) < 1.7);
    }
  }
}

TEST_CASE("light lines on dark ground and lines on transparent ground are the same lines") {
  const std::vector<InkLine> lines = lines_of(traced(some_lines()));
  PictureLook light;
  light.paper = 0.1;
  light.ink = 1;
  CHECK(distance_between(traced(some_lines(), light), lines) < 1);
  for (const double ink : {0.0, 1.0}) {
    PictureLook transparent;
    transparent.transparent = true;
    transparent.ink = ink;
    CHECK(distance_between(traced(some_lines(), transparent), lines) < 1);
  }
}

TEST_CASE("strokes run straight through crossings and end where they meet another one") {
  for (const double width : {4.0, 9.0}) {
    for (const double angle : {30.0, 50.0, 90.0}) {
      const double turn = angle * std::acos(-1) / 180;
      const Vec2 across = 200 * Vec2(std::cos(turn), std::sin(turn));
      const Vec2 middle(350, 250);
      const InkLine bar = ink_line({{200, 250}, {500, 250}});
      const std::vector<InkLine> cross{bar, ink_line({middle - across, middle + across})};
      const std::vector<InkLine> tee{bar, ink_line({middle, middle + across})};
      PictureLook look;
      look.line_width = width;
      INFO("width " << width << ", angle " << angle);
      CHECK(distance_between(traced(cross, look), cross) < 1.5 + width / 6);
      CHECK(distance_between(traced(tee, look), tee) < 1.5 + width / 6);
    }
  }
}

TEST_CASE("legs end at the body, whose outline stays closed") {
  const InkLine body = ink_circle({500, 350}, 180);
  std::vector<InkLine> animal{body};
  for (const double x : {400.0, 460.0, 560.0, 620.0}) {
    const double y = 350 + std::sqrt(180.0 * 180 - (x - 500) * (x - 500));
    animal.push_back(ink_line({{x, y}, {x, 640}}));
  }
  CHECK(distance_between(traced(animal, phone_photo()), animal) < 3);
}

TEST_CASE("gaps of two pixels are bridged, wider ones stay") {
  const auto with_gap = [](double gap) {
    return std::vector<InkLine>{ink_line({{200, 300}, {500 - gap / 2, 300}}),
                                ink_line({{500 + gap / 2, 300}, {800, 300}})};
  };
  const double width = PictureLook().line_width;
  CHECK(distance_between(traced(with_gap(width + 2)), {ink_line({{200, 300}, {800, 300}})}) < 1.7);
  CHECK(traced(with_gap(width + 12)).strokes.size() == 2);
}

TEST_CASE("small filled shapes are closed strokes along their border, specks are nothing") {
  PictureLook look = phone_photo();
  const std::vector<InkLine> face{ink_circle({400, 350}, 150), ink_circle({350, 310}, 14, true),
                                  ink_circle({450, 310}, 14, true)};
  std::vector<InkLine> borders = face;
  for (InkLine& line : borders) {
    // The pen goes half its width beyond what it fills.
    for (Vec2& point : line.points)
      if (line.filled) point += 2 * (point - Vec2(point.x() < 400 ? 350 : 450, 310)).normalized();
  }
  CHECK(distance_between(traced(face, look), borders) < 1.7);
  std::vector<InkLine> dirty = face;
  for (const double x : {600.0, 650.0, 700.0}) dirty.push_back(ink_line({{x, 300}, {x + 4, 302}}));
  look.line_width = 4;
  CHECK(traced(dirty, look).strokes.size() == 3);
}

TEST_CASE("the longest strokes come first, and names follow that order") {
  const Drawing drawing = traced(some_lines());
  REQUIRE(drawing.strokes.size() == 5);
  CHECK(drawing.file == "sheet.png");
  double last = 1e9;
  for (std::size_t i = 0; i < drawing.strokes.size(); ++i) {
    CHECK(drawing.strokes[i].id == "stroke-" + std::to_string(i + 1));
    const InkLine line = on_sheet(drawing.strokes[i]);
    CHECK(length(line.points, line.closed) <= last);
    last = length(line.points, line.closed);
  }
}

TEST_CASE("pictures without lines, and pictures of other things, are refused in one sentence") {
  CHECK(refusal_of(plain(1, 0)) == "E_NO_STROKES");
  CHECK(refusal_of(plain(0, 0)) == "E_NO_STROKES");
  CHECK(refusal_of(plain(0.8, 0.05)) == "E_NO_STROKES");
  CHECK(refusal_of(Picture{1, 1, {0, 0, 0, 255}}) == "E_NO_STROKES");
  CHECK(refusal_of(Picture{3, 2, std::vector<std::uint8_t>(24)}) == "E_NO_STROKES");
  Random random(3);
  std::vector<InkLine> grass;
  for (int i = 0; i < 3000; ++i) {
    const Vec2 root(random.between(0, 1000), random.between(0, 750));
    grass.push_back(ink_line({root, root + Vec2(random.between(-40, 40), -random.between(30, 90))}));
  }
  CHECK(refusal_of(picture_of(grass)) == "E_NO_LINE_DRAWING");
  Picture sparks = plain(0.5, 0);
  for (std::size_t i = 0; i < sparks.rgba.size(); ++i) {
    if (i % 4 != 3) sparks.rgba[i] = static_cast<std::uint8_t>(random.below(256));
  }
  CHECK_FALSE(refusal_of(sparks).empty());
}

}  // namespace croquis::test
