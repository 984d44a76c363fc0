// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/sketches/characters/character.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <stdexcept>

#include "croquis/geometry/polyline.h"
#include "support/sketches/sketch_spline.h"
#include "support/sketches/sketch_tubes.h"

namespace croquis::test {
namespace {

constexpr double spacing = 3;

/// Counterclockwise when `positive`, so that the surface lies on the left.
std::vector<Vec2> turned(std::vector<Vec2> loop, bool positive) {
  if ((signed_area(loop) > 0) != positive) std::reverse(loop.begin(), loop.end());
  return loop;
}

bool covers(const CharacterPart& part, const Vec2& place) {
  if (winding(part.outline, place) == 0) return false;
  return std::none_of(part.holes.begin(), part.holes.end(),
                      [&](const std::vector<Vec2>& hole) { return winding(hole, place) != 0; });
}

bool is_seen(const Character& character, std::size_t part) {
  const std::vector<Vec2>& outline = character.parts[part].outline;
  return std::any_of(outline.begin(), outline.end(), [&](const Vec2& place) {
    return std::none_of(character.parts.begin() + static_cast<std::ptrdiff_t>(part) + 1, character.parts.end(),
                        [&](const CharacterPart& other) { return covers(other, place); });
  });
}

TrueContour contour_of(std::vector<Vec2> loop, std::size_t part) {
  TrueContour contour;
  contour.component = static_cast<int>(part);
  contour.height.assign(loop.size(), static_cast<double>(part));
  contour.points = std::move(loop);
  return contour;
}

/// Names strokes after the part whose outline their middle sample lies on.
void name_strokes(const Character& character, const std::vector<TrueContour>& outlines, Drawing& drawing) {
  std::map<std::string, int> used;
  for (Stroke& stroke : drawing.strokes) {
    const Vec2 middle = stroke.samples[stroke.samples.size() / 2].position;
    double least = std::numeric_limits<double>::infinity();
    int part = 0;
    for (const TrueContour& outline : outlines) {
      for (const Vec2& point : outline.points) {
        if ((point - middle).norm() >= least) continue;
        least = (point - middle).norm();
        part = outline.component;
      }
    }
    const std::string& name = character.parts[static_cast<std::size_t>(part)].name;
    const int number = ++used[name];
    stroke.id = number == 1 ? name : name + " " + std::to_string(number);
  }
}

}  // namespace

Sketch character_sketch(const Character& character) {
  std::vector<TrueContour> contours;
  std::vector<int> euler;
  for (std::size_t part = 0; part < character.parts.size(); ++part) {
    const CharacterPart& drawn = character.parts[part];
    if (!is_seen(character, part)) {
      throw std::invalid_argument("the part \"" + drawn.name + "\" of " + character.name + " is covered completely");
    }
    contours.push_back(contour_of(turned(drawn.outline, true), part));
    for (const std::vector<Vec2>& hole : drawn.holes) contours.push_back(contour_of(turned(hole, false), part));
    euler.push_back(1 - static_cast<int>(drawn.holes.size()));
  }
  Sketch sketch = draw_visible(std::move(contours), std::move(euler));
  name_strokes(character, sketch.truth.outlines, sketch.drawing);
  return sketch;
}

Drawing whole_outlines(const Character& character) {
  Drawing drawing;
  for (const CharacterPart& part : character.parts) {
    drawing.strokes.push_back(stroke_of(part.name, part.outline, true));
    for (std::size_t h = 0; h < part.holes.size(); ++h) {
      drawing.strokes.push_back(stroke_of(part.name + " hole " + std::to_string(h + 1), part.holes[h], true));
    }
  }
  return drawing;
}

std::vector<Character> all_characters() {
  std::vector<Character> all = animal_characters();
  for (const auto& more : {people_and_plants(), thing_characters()}) all.insert(all.end(), more.begin(), more.end());
  return all;
}

std::vector<Vec2> ellipse(const Vec2& centre, double rx, double ry, double degrees) {
  const int count = std::max(16, static_cast<int>(2 * std::numbers::pi * std::max(rx, ry) / spacing));
  const double tilt = degrees * std::numbers::pi / 180;
  std::vector<Vec2> loop;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.31) / count;  // no sample on an axis of symmetry
    const Vec2 place(rx * std::cos(angle), ry * std::sin(angle));
    loop.emplace_back(centre + Vec2(std::cos(tilt) * place.x() - std::sin(tilt) * place.y(),
                                    std::sin(tilt) * place.x() + std::cos(tilt) * place.y()));
  }
  return loop;
}

std::vector<Vec2> smooth(const std::vector<Vec2>& through) { return smooth_loop(through, spacing); }

std::vector<Vec2> limb_outline(const std::vector<Vec2>& through, const std::vector<double>& radii) {
  return tube_outline(limb(through, radii, 0), spacing);
}

std::vector<Vec2> rounded_polygon(const std::vector<Vec2>& corners, double radius) {
  std::vector<Vec2> loop;
  const std::size_t count = corners.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2& corner = corners[i];
    const Vec2 in = (corner - corners[(i + count - 1) % count]).normalized();
    const Vec2 out = (corners[(i + 1) % count] - corner).normalized();
    const Vec2 begin = corner - radius * in;
    const Vec2 end = corner + radius * out;
    const Vec2 next = corners[(i + 1) % count] - radius * out;
    for (int k = 0; k <= 8; ++k) {
      const double t = k / 8.0;
      loop.emplace_back((1 - t) * (1 - t) * begin + 2 * t * (1 - t) * corner + t * t * end);
    }
    const int pieces = static_cast<int>((next - end).norm() / spacing);
    for (int k = 1; k < pieces; ++k) loop.emplace_back(end + (next - end) * k / pieces);
  }
  return loop;
}

std::vector<Vec2> star_outline(const Vec2& centre, int points, double outer, double inner) {
  std::vector<Vec2> corners;
  for (int i = 0; i < 2 * points; ++i) {
    const double angle = std::numbers::pi * (i + 0.5) / points;
    corners.emplace_back(centre + (i % 2 == 0 ? outer : inner) * Vec2(std::cos(angle), std::sin(angle)));
  }
  return rounded_polygon(corners, (corners[1] - corners[0]).norm() / 8);
}

std::vector<Vec2> cloud_outline(const Vec2& centre, double rx, double ry, int lobes, double bulge) {
  std::vector<Vec2> loop;
  const int count = static_cast<int>(2 * std::numbers::pi * std::max(rx, ry) * 1.2 / spacing);
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.31) / count;
    const double swell = 1 + bulge * (std::abs(std::sin(lobes * angle / 2)) - 0.5);
    loop.emplace_back(centre + swell * Vec2(rx * std::cos(angle), ry * std::sin(angle)));
  }
  return loop;
}

}  // namespace croquis::test
