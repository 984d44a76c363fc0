// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/fit_points.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "croquis/base/error.h"
#include "croquis/geometry/polyline.h"

namespace croquis {
namespace {

/// Pixels. Samples nearer than this to the one before repeat it: a pen held still.
constexpr double repeated_pixels = 0.02;

/// Pixels between samples up to which jitter may be taken away in full.
constexpr double dense_pixels = 3;

/// Share of a corner's turn that half the reach must already show; an arc of a circle shows half of its turn.
constexpr double corner_share = 0.7;

[[noreturn]] void refuse(const Stroke& stroke, const char* code, const std::string& sentence) {
  throw Error(make_error(Category::Malformed, code, sentence, {{SubjectKind::Stroke, stroke.id, {}, {}, {}}}));
}

void require_usable(const Stroke& stroke) {
  if (stroke.samples.empty()) refuse(stroke, "E_NO_STROKES", "Stroke " + stroke.id + " has no samples; remove it.");
  for (const StrokeSample& sample : stroke.samples) {
    if (!sample.position.allFinite())
      refuse(stroke, "E_NOT_FINITE", "Stroke " + stroke.id + " has a place that is not finite; draw it again.");
  }
}

void take_distinct(const Stroke& stroke, double distance, FitPoints& points) {
  for (std::size_t i = 0; i < stroke.samples.size(); ++i) {
    const Vec2& place = stroke.samples[i].position;
    if (!points.drawn.empty() && (place - points.drawn.back()).norm() <= distance) continue;
    points.drawn.push_back(place);
    points.samples.push_back(i);
  }
  while (stroke.closed && points.drawn.size() > 1 && (points.drawn.back() - points.drawn.front()).norm() <= distance) {
    points.drawn.pop_back();
    points.samples.pop_back();
  }
  points.closed = stroke.closed && points.drawn.size() > 2;
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
std::vector<double> corner_scores(const ByArcLength& line, const FitPoints& points, double reach, double smallest) {
  std::vector<double> scores(points.drawn.size(), 0);
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

std::vector<std::size_t> find_corners(const FitPoints& points, double reach, double smallest) {
  std::vector<std::size_t> corners;
  const ByArcLength line(points.drawn, points.closed);
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

/// Fairing is there against jitter, which shows between near samples. Where a fast hand leaves them far apart it would
/// flatten the curve itself.
void limit_shifts(FitPoints& points, const FitOptions& options) {
  const std::size_t count = points.drawn.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2 chord = points.drawn[(i + 1) % count] - points.drawn[(i + count - 1) % count];
    const double spacing = chord.norm() / 2 / options.units_per_pixel;
    const double limit = options.jitter * options.units_per_pixel * std::min(1.0, dense_pixels / spacing);
    const Vec2 shift = points.smooth[i] - points.drawn[i];
    if (shift.norm() > limit) points.smooth[i] = points.drawn[i] + limit / shift.norm() * shift;
  }
}

}  // namespace

FitPoints fit_points(const Stroke& stroke, const FitOptions& options) {
  require_usable(stroke);
  FitPoints points;
  take_distinct(stroke, repeated_pixels * options.units_per_pixel, points);
  const double smallest = options.corner_degrees * std::numbers::pi / 180;
  if (points.drawn.size() > 2)
    points.corners = find_corners(points, options.corner_reach * options.units_per_pixel, smallest);
  TaubinOptions fairing;
  fairing.passes = options.smoothing;
  fairing.fixed.assign(points.drawn.size(), false);
  for (const std::size_t corner : points.corners) fairing.fixed[corner] = true;
  points.smooth = taubin_smooth(points.drawn, points.closed, fairing);
  limit_shifts(points, options);
  return points;
}

}  // namespace croquis
