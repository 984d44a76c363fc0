// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/strokes/fit_points.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "croquis/base/error.h"
#include "croquis/base/limits.h"
#include "croquis/geometry/polyline.h"

namespace croquis {
namespace {

/// Pixels. Samples nearer than this to the one before repeat it.
constexpr double repeated_pixels = 0.02;

/// Pixels. Samples this near to each other are dense: their differences are jitter more than drawing.
constexpr double crowd_pixels = 1.5;

/// Pixels between samples up to which jitter may be taken away in full.
constexpr double dense_pixels = 3;

/// Share of a corner's turn that half the reach must already show; an arc of a circle shows half of its turn.
constexpr double corner_share = 0.7;

[[noreturn]] void refuse_stroke(const Stroke& stroke, const char* code, const std::string& sentence) {
  throw Error(make_error(Category::Malformed, code, sentence, {{SubjectKind::Stroke, stroke.id, {}, {}, {}}}));
}

void require_usable(const Stroke& stroke) {
  if (stroke.samples.empty())
    refuse_stroke(stroke, "E_NO_STROKES", "Stroke " + stroke.id + " has no samples; remove it.");
  for (const StrokeSample& sample : stroke.samples) {
    if (!are_usable_numbers(sample.position))
      refuse_stroke(stroke, "E_NOT_FINITE", "Stroke " + stroke.id + " has a place that is not finite; draw it again.");
  }
}

/// The samples without repetitions.
struct DrawnPoints {
  std::vector<Vec2> places;
  std::vector<std::size_t> samples;  ///< their numbers in the stroke
  std::vector<std::size_t> corners;
  bool closed = false;
};

DrawnPoints distinct_points(const Stroke& stroke, double distance) {
  DrawnPoints points;
  for (std::size_t i = 0; i < stroke.samples.size(); ++i) {
    const Vec2& place = stroke.samples[i].position;
    if (!points.places.empty() && (place - points.places.back()).norm() <= distance) continue;
    points.places.push_back(place);
    points.samples.push_back(i);
  }
  while (stroke.closed && points.places.size() > 1 &&
         (points.places.back() - points.places.front()).norm() <= distance) {
    points.places.pop_back();
    points.samples.pop_back();
  }
  points.closed = stroke.closed && points.places.size() > 2;
  return points;
}

/// Places on a polyline by arc length; beyond the ends of an open one lies its end.
class ByArcLength {
 public:
  ByArcLength(std::span<const Vec2> points, bool closed)
      : points_(points), lengths_(arc_lengths(points, closed)), closed_(closed) {}

  double of_point(std::size_t i) const { return lengths_[i]; }
  double total() const { return lengths_.back(); }

  Vec2 at(double length) const {
    if (closed_) length -= std::floor(length / total()) * total();
    const auto next = std::upper_bound(lengths_.begin(), lengths_.end(), length);
    if (next == lengths_.begin()) return points_.front();
    const auto i = static_cast<std::size_t>(next - lengths_.begin()) - 1;
    if (next == lengths_.end()) return points_[closed_ ? 0 : i];
    const Vec2& end = points_[i + 1 == points_.size() ? 0 : i + 1];
    return points_[i] + (length - lengths_[i]) / (lengths_[i + 1] - lengths_[i]) * (end - points_[i]);
  }

  /// Radians 0..pi between the chords that reach back and ahead from a point.
  double turn(std::size_t i, double reach) const {
    const Vec2 in = points_[i] - at(lengths_[i] - reach);
    const Vec2 out = at(lengths_[i] + reach) - points_[i];
    return std::abs(std::atan2(cross(in, out), in.dot(out)));
  }

 private:
  std::span<const Vec2> points_;
  std::vector<double> lengths_;
  bool closed_;
};

/// How sharply the line turns at each point: 0 where it is no corner.
std::vector<double> corner_scores(const ByArcLength& line, const DrawnPoints& points, double reach, double smallest) {
  std::vector<double> scores(points.places.size(), 0);
  for (std::size_t i = 0; i < scores.size(); ++i) {
    const double from_end = std::min(line.of_point(i), line.total() - line.of_point(i));
    if (!points.closed && from_end < reach / 2) continue;
    const double near = line.turn(i, reach / 2);
    const double far = line.turn(i, reach);
    if (far >= smallest && near >= corner_share * far) scores[i] = near;
  }
  return scores;
}

bool is_highest(const std::vector<double>& scores, const ByArcLength& line, std::size_t i, double reach) {
  for (std::size_t k = i; k-- > 0 && line.of_point(i) - line.of_point(k) < reach;) {
    if (scores[k] >= scores[i]) return false;
  }
  for (std::size_t k = i + 1; k < scores.size() && line.of_point(k) - line.of_point(i) < reach; ++k) {
    if (scores[k] > scores[i]) return false;
  }
  return true;
}

std::vector<std::size_t> find_corners(const DrawnPoints& points, double reach, double smallest) {
  std::vector<std::size_t> corners;
  const ByArcLength line(points.places, points.closed);
  const std::vector<double> scores = corner_scores(line, points, reach, smallest);
  for (std::size_t i = 0; i < scores.size(); ++i) {
    if (scores[i] > 0 && is_highest(scores, line, i, reach / 2)) corners.push_back(i);
  }
  // The two ends of a closed line's list are neighbours as well.
  if (points.closed && corners.size() > 1 &&
      line.total() - line.of_point(corners.back()) + line.of_point(corners.front()) < reach / 2) {
    corners.erase(scores[corners.back()] > scores[corners.front()] ? corners.begin() : corners.end() - 1);
  }
  return corners;
}

/// Means of crowds: a crowd is what stays within reach of its first sample. Corners and the stroke's ends stand alone.
class Thinning {
 public:
  Thinning(const DrawnPoints& drawn, double reach) : drawn_(drawn), reach_(reach) {}

  FitPoints run() {
    std::size_t begin = 0;
    while (begin < drawn_.places.size()) {
      std::size_t end = begin + 1;
      while (end < drawn_.places.size() && joins(begin, end)) ++end;
      add(begin, end);
      begin = end;
    }
    result_.closed = drawn_.closed && result_.smooth.size() > 2;
    return std::move(result_);
  }

 private:
  bool is_corner(std::size_t i) const { return std::binary_search(drawn_.corners.begin(), drawn_.corners.end(), i); }
  bool stands_alone(std::size_t i) const {
    return is_corner(i) || (!drawn_.closed && (i == 0 || i + 1 == drawn_.places.size()));
  }
  bool joins(std::size_t begin, std::size_t i) const {
    return !stands_alone(begin) && !stands_alone(i) && (drawn_.places[i] - drawn_.places[begin]).norm() < reach_;
  }

  void add(std::size_t begin, std::size_t end) {
    Vec2 sum = Vec2::Zero();
    for (std::size_t i = begin; i < end; ++i) sum += drawn_.places[i];
    const Vec2 mean = sum / static_cast<double>(end - begin);
    if (!result_.smooth.empty() && mean == result_.smooth.back()) return;
    if (is_corner(begin)) result_.corners.push_back(result_.smooth.size());
    result_.smooth.push_back(mean);
    result_.samples.push_back(drawn_.samples[(begin + end) / 2]);
  }

  const DrawnPoints& drawn_;
  double reach_;
  FitPoints result_;
};

/// Fairing is there against jitter, which shows between near points. Where a fast pen leaves them far apart it would
/// flatten the curve itself.
Vec2 limited_shift(const std::vector<Vec2>& places, std::size_t i, const Vec2& shift, const FitOptions& options) {
  const std::size_t count = places.size();
  const Vec2 chord = places[(i + 1) % count] - places[(i + count - 1) % count];
  const double spacing = chord.norm() / 2 / options.units_per_pixel;
  const double limit = options.jitter * options.units_per_pixel * std::min(1.0, dense_pixels / spacing);
  return shift.norm() > limit ? Vec2(limit / shift.norm() * shift) : shift;
}

void fair(FitPoints& points, const FitOptions& options) {
  TaubinOptions fairing;
  fairing.passes = options.smoothing;
  fairing.fixed.assign(points.smooth.size(), false);
  for (const std::size_t corner : points.corners) fairing.fixed[corner] = true;
  const std::vector<Vec2> faired = taubin_smooth(points.smooth, points.closed, fairing);
  const std::vector<Vec2> before = points.smooth;
  for (std::size_t i = 0; i < before.size(); ++i)
    points.smooth[i] += limited_shift(before, i, faired[i] - before[i], options);
}

}  // namespace

FitPoints fit_points(const Stroke& stroke, const FitOptions& options) {
  require_usable(stroke);
  DrawnPoints drawn = distinct_points(stroke, repeated_pixels * options.units_per_pixel);
  const double smallest = options.corner_degrees * std::numbers::pi / 180;
  if (drawn.places.size() > 2)
    drawn.corners = find_corners(drawn, options.corner_reach * options.units_per_pixel, smallest);
  FitPoints points = Thinning(drawn, crowd_pixels * options.units_per_pixel).run();
  fair(points, options);
  return points;
}

}  // namespace croquis
