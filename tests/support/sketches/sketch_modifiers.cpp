// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/sketches/sketch_modifiers.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/random.h"

namespace croquis::test {
namespace {

using Points = std::vector<Vec2>;

Points points_of(const Stroke& stroke) {
  Points points;
  for (const StrokeSample& sample : stroke.samples) points.push_back(sample.position);
  return points;
}

void set_points(Stroke& stroke, const Points& points) {
  stroke.samples.assign(points.size(), StrokeSample{});
  for (std::size_t i = 0; i < points.size(); ++i) stroke.samples[i].position = points[i];
}

double length_of(const Points& points) {
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
  return length;
}

/// The place at a distance along an open polyline; beyond an end straight on.
Vec2 along(const Points& points, double distance) {
  std::size_t i = 1;
  double left = distance;
  while (i + 1 < points.size() && left > (points[i] - points[i - 1]).norm()) {
    left -= (points[i] - points[i - 1]).norm();
    ++i;
  }
  return points[i - 1] + left * (points[i] - points[i - 1]).normalized();
}

/// The part of an open polyline between two distances, either of which may lie beyond its ends.
Points part(const Points& points, double from, double to) {
  Points kept{along(points, from)};
  double distance = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0) distance += (points[i] - points[i - 1]).norm();
    if (distance > from + 0.2 && distance < to - 0.2) kept.push_back(points[i]);
  }
  kept.push_back(along(points, to));
  return kept;
}

/// A displacement that varies slowly along a stroke and, on a closed one, comes round to itself.
class Wobble {
 public:
  Wobble(Random& random, double length, double amplitude, double wavelength) : length_(length) {
    const int waves = std::max(2, static_cast<int>(length / wavelength));
    for (int k = 1; k <= waves; ++k) {
      const auto wave = [&] { return Wave{random.between(-1, 1), random.between(0, 2 * std::numbers::pi)}; };
      x_.push_back(wave());
      y_.push_back(wave());
    }
    // Each wave has variance E[a²]/2 = 1/6; amplitude² is shared by the two coordinates.
    scale_ = amplitude * std::sqrt(3.0 / waves);
  }

  Vec2 at(double distance) const {
    Vec2 sum = Vec2::Zero();
    for (std::size_t k = 0; k < x_.size(); ++k) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(k + 1) * distance / length_;
      sum += Vec2(x_[k].size * std::sin(angle + x_[k].phase), y_[k].size * std::sin(angle + y_[k].phase));
    }
    return scale_ * sum;
  }

 private:
  struct Wave {
    double size;
    double phase;
  };
  double length_;
  double scale_ = 0;
  std::vector<Wave> x_;
  std::vector<Wave> y_;
};

Points wobbled(const Points& points, bool closed, Random& random, const NoiseOptions& options, double u) {
  Points open = points;
  if (closed) open.push_back(points.front());
  const Wobble wobble(random, length_of(open), options.amplitude * u, options.wavelength * u);
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
    if (length_of(opened(drawing.strokes[i])) > length_of(opened(drawing.strokes[longest]))) longest = i;
  }
  return longest;
}

/// Takes a piece out of the longest stroke, where no end of another is near: a closed stroke opens, an open one
/// becomes two, the second named with a "b".
void break_longest(Drawing& drawing, Random& random, double gap) {
  const std::size_t index = longest_stroke(drawing);
  const Points points = opened(drawing.strokes[index]);
  const double length = length_of(points);
  double best = length / 2;
  double clear = -1;
  for (int i = 0; i < 40; ++i) {
    const double at = random.between(0.15, 0.85) * length;
    const double distance = distance_to_ends(drawing, along(points, at));
    if (distance > clear) best = at;
    clear = std::max(clear, distance);
  }
  const Points before = part(points, 0, best - gap / 2);
  const Points after = part(points, best + gap / 2, length);
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
      points = part(points, -before, length_of(points) + after);
    }
    set_points(stroke, wobbled(points, stroke.closed, random, options, u));
  }
  return result;
}

}  // namespace croquis::test
