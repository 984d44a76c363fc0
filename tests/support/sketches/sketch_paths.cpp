// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/sketches/sketch_paths.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace croquis::test {
namespace {

using Points = std::vector<Vec2>;

}  // namespace

Points points_of(const Stroke& stroke) {
  Points points;
  for (const StrokeSample& sample : stroke.samples) points.push_back(sample.position);
  return points;
}

void set_points(Stroke& stroke, const Points& points) {
  stroke.samples.assign(points.size(), StrokeSample{});
  for (std::size_t i = 0; i < points.size(); ++i) stroke.samples[i].position = points[i];
}

double path_length(const Points& points) {
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
  return length;
}

Vec2 path_place(const Points& points, double distance) {
  std::size_t i = 1;
  double left = distance;
  while (i + 1 < points.size() && left > (points[i] - points[i - 1]).norm()) {
    left -= (points[i] - points[i - 1]).norm();
    ++i;
  }
  return points[i - 1] + left * (points[i] - points[i - 1]).normalized();
}

Points path_part(const Points& points, double from, double to) {
  Points kept{path_place(points, from)};
  double distance = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0) distance += (points[i] - points[i - 1]).norm();
    if (distance > from + 0.2 && distance < to - 0.2) kept.push_back(points[i]);
  }
  kept.push_back(path_place(points, to));
  return kept;
}

Wobble::Wobble(Random& random, double length, double amplitude, double wavelength) : length_(length) {
  const int waves = std::max(2, static_cast<int>(length / wavelength));
  for (int k = 1; k <= waves; ++k) {
    const auto wave = [&] { return Wave{random.between(-1, 1), random.between(0, 2 * std::numbers::pi)}; };
    x_.push_back(wave());
    y_.push_back(wave());
  }
  // Each wave has variance E[a²]/2 = 1/6; amplitude² is shared by the two coordinates.
  scale_ = amplitude * std::sqrt(3.0 / waves);
}

Vec2 Wobble::at(double distance) const {
  Vec2 sum = Vec2::Zero();
  for (std::size_t k = 0; k < x_.size(); ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k + 1) * distance / length_;
    sum += Vec2(x_[k].size * std::sin(angle + x_[k].phase), y_[k].size * std::sin(angle + y_[k].phase));
  }
  return scale_ * sum;
}

}  // namespace croquis::test
