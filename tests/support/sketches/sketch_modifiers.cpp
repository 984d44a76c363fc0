// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/sketches/sketch_modifiers.h"

#include <algorithm>

#include "support/random.h"
#include "support/sketches/sketch_paths.h"

namespace croquis::test {
namespace {

using Points = std::vector<Vec2>;

Points wobbled(const Points& points, bool closed, Random& random, const NoiseOptions& options, double u) {
  Points open = points;
  if (closed) open.push_back(points.front());
  const Wobble wobble(random, path_length(open), options.amplitude * u, options.wavelength * u);
  Points moved;
  double distance = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0) distance += (points[i] - points[i - 1]).norm();
    const double jitter = random.between(-0.5, 0.5) * options.spacing_jitter;
    const bool inner = i > 0 && i + 1 < points.size();
    const Vec2 base = inner ? Vec2(points[i] + jitter * (points[i + 1] - points[i])) : points[i];
    moved.push_back(base + wobble.at(distance));
  }
  return moved;
}

/// Distance from a place to the nearest end of any open stroke.
double distance_to_ends(const Drawing& drawing, const Vec2& place) {
  double nearest = 1e300;
  for (const Stroke& stroke : drawing.strokes) {
    if (stroke.closed) continue;
    nearest = std::min(nearest, (stroke.samples.front().position - place).norm());
    nearest = std::min(nearest, (stroke.samples.back().position - place).norm());
  }
  return nearest;
}

Points opened(const Stroke& stroke) {
  Points points = points_of(stroke);
  if (stroke.closed) points.push_back(points.front());
  return points;
}

std::size_t longest_stroke(const Drawing& drawing) {
  std::size_t longest = 0;
  for (std::size_t i = 1; i < drawing.strokes.size(); ++i) {
    if (path_length(opened(drawing.strokes[i])) > path_length(opened(drawing.strokes[longest]))) longest = i;
  }
  return longest;
}

/// Takes a piece out of the longest stroke, where no end of another is near: a closed stroke opens, an open one
/// becomes two, the second named with a "b".
void break_longest(Drawing& drawing, Random& random, double gap) {
  const std::size_t index = longest_stroke(drawing);
  const Points points = opened(drawing.strokes[index]);
  const double length = path_length(points);
  double best = length / 2;
  double clear = -1;
  for (int i = 0; i < 40; ++i) {
    const double at = random.between(0.15, 0.85) * length;
    const double distance = distance_to_ends(drawing, path_place(points, at));
    if (distance > clear) best = at;
    clear = std::max(clear, distance);
  }
  const Points before = path_part(points, 0, best - gap / 2);
  const Points after = path_part(points, best + gap / 2, length);
  Stroke& stroke = drawing.strokes[index];
  if (stroke.closed) {
    Points joined = after;
    joined.insert(joined.end(), before.begin() + 1, before.end());
    stroke.closed = false;
    set_points(stroke, joined);
    return;
  }
  Stroke second = stroke;
  second.id += "b";
  set_points(second, after);
  set_points(stroke, before);
  drawing.strokes.insert(drawing.strokes.begin() + static_cast<std::ptrdiff_t>(index) + 1, std::move(second));
}

}  // namespace

Sketch transformed(Sketch sketch, const Eigen::Affine2d& transform) {
  for (Stroke& stroke : sketch.drawing.strokes) {
    for (StrokeSample& sample : stroke.samples) sample.position = transform * sample.position;
  }
  for (TrueContour& contour : sketch.truth.outlines) {
    for (Vec2& point : contour.points) point = transform * point;
    if (transform.linear().determinant() > 0) continue;
    std::reverse(contour.points.begin(), contour.points.end());
    std::reverse(contour.height.begin(), contour.height.end());
  }
  for (TrueCrossing& place : sketch.truth.places) place.at = transform * place.at;
  return sketch;
}

Sketch rotated(const Sketch& sketch, double radians) {
  return transformed(sketch, Eigen::Affine2d(Eigen::Rotation2Dd(radians)));
}

Sketch scaled(const Sketch& sketch, double factor) {
  return transformed(sketch, Eigen::Affine2d(Eigen::Scaling(factor)));
}

Sketch translated(const Sketch& sketch, const Vec2& offset) {
  return transformed(sketch, Eigen::Affine2d(Eigen::Translation2d(offset)));
}

Sketch mirrored(const Sketch& sketch) { return transformed(sketch, Eigen::Affine2d(Eigen::Scaling(-1.0, 1.0))); }

Drawing shuffled_strokes(Drawing drawing, std::uint64_t seed) {
  Random random(seed);
  for (std::size_t i = drawing.strokes.size(); i > 1; --i) {
    std::swap(drawing.strokes[i - 1], drawing.strokes[random.below(static_cast<std::uint32_t>(i))]);
  }
  return drawing;
}

Drawing reversed_strokes(Drawing drawing) {
  for (Stroke& stroke : drawing.strokes) std::reverse(stroke.samples.begin(), stroke.samples.end());
  return drawing;
}

double diagonal(const Drawing& drawing) {
  Eigen::AlignedBox2d box;
  for (const Stroke& stroke : drawing.strokes) {
    for (const StrokeSample& sample : stroke.samples) box.extend(sample.position);
  }
  return box.isEmpty() ? 0 : box.diagonal().norm();
}

Drawing noisy(const Drawing& drawing, std::uint64_t seed, const NoiseOptions& options) {
  Random random(seed);
  const double u = diagonal(drawing) / 1000;
  Drawing result = drawing;
  if (options.gap > 0) break_longest(result, random, options.gap * u);
  for (Stroke& stroke : result.strokes) {
    Points points = points_of(stroke);
    const auto is_true_end = [&](const Vec2& end) { return distance_to_ends(drawing, end) < 1e-9; };
    if (!stroke.closed) {
      const auto shift = [&](const Vec2& end) {
        return is_true_end(end) ? random.between(-options.undershoot, options.overshoot) * u : 0.0;
      };
      const double before = shift(points.front());
      const double after = shift(points.back());
      points = path_part(points, -before, path_length(points) + after);
    }
    set_points(stroke, wobbled(points, stroke.closed, random, options, u));
  }
  return result;
}

}  // namespace croquis::test
