// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/attribute_surface/bridges/stroke_path.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "croquis/geometry/polyline.h"

namespace croquis {

StrokePath::StrokePath(const Stroke& stroke) : closed_(stroke.closed) {
  for (const StrokeSample& sample : stroke.samples) {
    if (points_.empty() || sample.position != points_.back()) points_.push_back(sample.position);
  }
  while (closed_ && points_.size() > 1 && points_.back() == points_.front()) points_.pop_back();
  closed_ = closed_ && points_.size() > 2;
  lengths_ = arc_lengths(points_, closed_);
}

double StrokePath::wrapped(double length) const {
  if (!closed_) return std::clamp(length, 0.0, this->length());
  const double turns = std::floor(length / this->length());
  return std::clamp(length - turns * this->length(), 0.0, this->length());
}

double StrokePath::along(double a, double b) const {
  const double straight = std::abs(a - b);
  return closed_ ? std::min(straight, length() - straight) : straight;
}

Vec2 StrokePath::at(double length) const {
  const double s = wrapped(length);
  const auto after = std::upper_bound(lengths_.begin(), lengths_.end() - 1, s);
  const auto k = std::min<std::size_t>(static_cast<std::size_t>(after - lengths_.begin()) - 1, segments() - 1);
  const double span = lengths_[k + 1] - lengths_[k];
  const double t = span > 0 ? (s - lengths_[k]) / span : 0;
  if (t <= 0) return points_[k];
  return t >= 1 ? end_of(k) : Vec2(points_[k] + t * (end_of(k) - points_[k]));
}

std::vector<double> StrokePath::corners(double angle, double reach) const {
  std::vector<std::pair<double, double>> turns;  // less the angle, so that sorting puts the sharpest first
  for (std::size_t i = closed_ ? 0 : 1; i + (closed_ ? 0 : 1) < points_.size(); ++i) {
    const double s = lengths_[i];
    const Vec2 arriving = points_[i] - at(s - reach), leaving = at(s + reach) - points_[i];
    const double turn = std::abs(std::atan2(cross(arriving, leaving), arriving.dot(leaving)));
    if (turn > angle) turns.emplace_back(-turn, s);
  }
  std::ranges::sort(turns);
  std::vector<double> found;
  for (const auto& [turn, s] : turns) {
    const auto near = [&, at = s](double other) { return along(other, at) < reach; };
    const bool at_end = !closed_ && (s < reach || length() - s < reach);
    if (!at_end && std::ranges::none_of(found, near)) found.push_back(s);
  }
  std::ranges::sort(found);
  return found;
}

std::vector<Vec2> StrokePath::part(double from, double to) const {
  const double end = to > from ? to : to + length();
  std::vector<Vec2> result{at(from)};
  const auto add = [&](const Vec2& point) {
    if (point != result.back()) result.push_back(point);
  };
  for (const double turn : {0.0, length()}) {
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const double s = lengths_[i] + turn;
      if (s > from && s < end) add(points_[i]);
    }
  }
  add(at(to));
  return result;
}

StrokePath::Nearest StrokePath::nearest(const Vec2& point, double around, double shut) const {
  Nearest best{0, std::numeric_limits<double>::infinity()};
  for (std::size_t k = 0; k < segments(); ++k) {
    const double t = nearest_parameter(point, points_[k], end_of(k));
    const double s = lengths_[k] + t * (lengths_[k + 1] - lengths_[k]);
    const double distance = (points_[k] + t * (end_of(k) - points_[k]) - point).norm();
    if (distance < best.distance && (shut <= 0 || along(s, around) > shut)) best = {s, distance};
  }
  return best;
}

}  // namespace croquis
