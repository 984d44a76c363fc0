// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/strokes/stroke_fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "croquis/base/error.h"
#include "croquis/base/limits.h"
#include "croquis/geometry/polyline.h"
#include "tools/strokes/cubic_fit.h"

namespace croquis {
namespace {

/// What the fit works on: the stroke's samples, thinned and faired.
struct FitPoints {
  std::vector<Vec2> smooth;          ///< at least one; neighbours differ
  std::vector<std::size_t> samples;  ///< the sample that each stands for, increasing
  std::vector<std::size_t> corners;  ///< 0-based points, increasing; never an end of an open stroke
  bool closed = false;               ///< and has at least three points
};

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

/// Finds corners, replaces each few dense samples by their mean, and fairs what lies between corners and
/// ends, which keep their places.
/// @throws Error (E_NO_STROKES, E_NOT_FINITE)
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

/// Pixels over which directions are taken: long against jitter, short against drawn bends.
constexpr double tangent_reach = 6;

/// A stretch of the points between two breaks, in order; of a closed stroke it may pass the list's end.
struct Run {
  std::vector<std::size_t> points;
  bool smooth_seam = false;  ///< a closed stroke without corners: both ends are one place with one direction
};

std::vector<Run> runs_between_corners(const FitPoints& points) {
  const std::size_t count = points.smooth.size();
  std::vector<std::size_t> breaks = points.corners;
  if (!points.closed) breaks.insert(breaks.begin(), 0);
  const bool smooth_seam = breaks.empty();
  if (smooth_seam) breaks.push_back(0);
  breaks.push_back(points.closed ? breaks.front() + count : count - 1);
  std::vector<Run> runs;
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    Run run{{}, smooth_seam};
    for (std::size_t i = breaks[k]; i <= breaks[k + 1]; ++i) run.points.push_back(i % count);
    runs.push_back(std::move(run));
  }
  return runs;
}

std::vector<FittedPiece> fit_run(const std::vector<Vec2>& places, bool smooth_seam, double reach, double tolerance) {
  const std::vector<Vec2> reversed(places.rbegin(), places.rend());
  Vec2 begin = tangent_at_begin(places, reach);
  Vec2 end = -tangent_at_begin(reversed, reach);
  if (smooth_seam) {
    std::vector<Vec2> around(places.begin() + static_cast<std::ptrdiff_t>(places.size() / 2), places.end());
    const std::size_t seam = around.size() - 1;
    around.insert(around.end(), places.begin() + 1, places.begin() + static_cast<std::ptrdiff_t>(places.size() / 2));
    begin = end = tangent_within(around, seam, reach);
  }
  return fit_cubics(places, begin, end, reach, tolerance);
}

/// Gathers squared distances of points and samples to the curve.
class Residuals {
 public:
  Residuals(const Stroke& stroke, const FitPoints& points) : stroke_(stroke), points_(points) {}

  void add(const Run& run, const FittedPiece& piece) {
    for (std::size_t i = piece.first; i <= piece.last; ++i) {
      const double t = piece.parameters[i - piece.first];
      smooth_ += (point_at(piece.cubic, t) - points_.smooth[run.points[i]]).squaredNorm();
      ++smooth_count_;
      if (i < piece.last) add_samples(run, piece, i);
    }
  }

  void write_to(StrokeFit& fit) const {
    fit.rms = std::sqrt(smooth_ / static_cast<double>(smooth_count_));
    fit.raw_rms = std::sqrt(drawn_ / static_cast<double>(drawn_count_));
    fit.largest = std::sqrt(largest_);
  }

 private:
  /// The samples from the one of point i up to that of the next; their parameters lie between those of the two.
  void add_samples(const Run& run, const FittedPiece& piece, std::size_t i) {
    const std::size_t total = stroke_.samples.size();
    const std::size_t begin = points_.samples[run.points[i]];
    std::size_t end = points_.samples[run.points[i + 1]];
    if (end <= begin) end += total;
    const double from = piece.parameters[i - piece.first];
    const double step = (piece.parameters[i + 1 - piece.first] - from) / static_cast<double>(end - begin);
    for (std::size_t k = begin; k <= end; ++k) {
      const Vec2& place = stroke_.samples[k % total].position;
      const double t = nearest_on_cubic(piece.cubic, place, from + step * static_cast<double>(k - begin));
      const double distance = (point_at(piece.cubic, t) - place).squaredNorm();
      drawn_ += distance;
      largest_ = std::max(largest_, distance);
      ++drawn_count_;
    }
  }

  const Stroke& stroke_;
  const FitPoints& points_;
  double smooth_ = 0;
  double drawn_ = 0;
  double largest_ = 0;
  std::size_t smooth_count_ = 0;
  std::size_t drawn_count_ = 0;
};

void add_run(const FitPoints& points, const Run& run, const std::vector<FittedPiece>& pieces, StrokeFit& fit) {
  for (const FittedPiece& piece : pieces) {
    const std::size_t point = run.points[piece.first];
    const bool corner = std::binary_search(points.corners.begin(), points.corners.end(), point);
    fit.anchors.push_back({piece.cubic[0], points.samples[point], corner});
    fit.segments.push_back(piece.cubic);
  }
}

/// Anchors begin with the stroke's earliest one, whichever corner the fit began with.
void begin_with_first_sample(StrokeFit& fit) {
  const auto first = std::min_element(fit.anchors.begin(), fit.anchors.end(),
                                      [](const auto& a, const auto& b) { return a.sample < b.sample; });
  const auto shift = first - fit.anchors.begin();
  std::rotate(fit.anchors.begin(), first, fit.anchors.end());
  std::rotate(fit.segments.begin(), fit.segments.begin() + shift, fit.segments.end());
}

}  // namespace

Vec2 point_at(const CubicSegment& segment, double t) {
  const double s = 1 - t;
  return s * s * s * segment[0] + 3 * s * s * t * segment[1] + 3 * s * t * t * segment[2] + t * t * t * segment[3];
}

StrokeFit fit_stroke(const Stroke& stroke, const FitOptions& options) {
  const FitPoints points = fit_points(stroke, options);
  StrokeFit fit;
  fit.closed = points.closed;
  if (points.smooth.size() == 1) {
    fit.anchors.push_back({points.smooth.front(), points.samples.front(), false});
    return fit;
  }
  Residuals residuals(stroke, points);
  for (const Run& run : runs_between_corners(points)) {
    std::vector<Vec2> places;
    for (const std::size_t point : run.points) places.push_back(points.smooth[point]);
    const std::vector<FittedPiece> pieces = fit_run(places, run.smooth_seam, tangent_reach * options.units_per_pixel,
                                                    options.tolerance * options.units_per_pixel);
    for (const FittedPiece& piece : pieces) residuals.add(run, piece);
    add_run(points, run, pieces, fit);
  }
  if (points.closed) {
    begin_with_first_sample(fit);
  } else {
    fit.anchors.push_back({points.smooth.back(), points.samples.back(), false});
  }
  residuals.write_to(fit);
  return fit;
}

}  // namespace croquis
