// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/surface/stroke_curves.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <Eigen/Geometry>

#include "croquis/geometry/bezier_fit.h"

namespace croquis {
namespace {

constexpr double spacing_pixels = 2;       // of the places that a stroke is worked on with
constexpr double least_step_pixels = 3;    // between places that have a direction
constexpr int steadying_passes = 6;        // moves a place by less than the jitter of a hand
constexpr double closing_pixels = 14;      // ends this near are meant to meet …
constexpr double closing_miss = 0.05;      // … or this near × the stroke's length …
constexpr double closing_share = 0.15;     // … where the stroke is much longer than the gap
constexpr double corner_sharpness = 0.62;  // of a corner nearly all turning is within half the reach; of an arc half
constexpr double least_line_pixels = 1.5;  // a line is never drawn straighter
constexpr double steps_in_reach = 2.2;
constexpr std::size_t smooth_loop_parts = 4;  // of a loop without corners

double row_length(std::span<const Vec3> points) {
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
  return length;
}

double longest_step(std::span<const Vec3> points) {
  double longest = 0;
  for (std::size_t i = 1; i < points.size(); ++i) longest = std::max(longest, (points[i] - points[i - 1]).norm());
  return longest;
}

/// Places at even distances along the stroke, its ends too.
std::vector<Vec3> evenly_spaced(std::span<const Vec3> points, double spacing) {
  const double length = row_length(points);
  const auto parts = std::clamp<std::size_t>(static_cast<std::size_t>(length / spacing), 1, 4000);
  std::vector<Vec3> places = {points.front()};
  double passed = 0;
  std::size_t at = 1;
  for (std::size_t k = 1; k < parts; ++k) {
    const double wanted = length * static_cast<double>(k) / static_cast<double>(parts);
    while (passed + (points[at] - points[at - 1]).norm() < wanted && at + 1 < points.size()) {
      passed += (points[at] - points[at - 1]).norm();
      ++at;
    }
    const double step = (points[at] - points[at - 1]).norm();
    const double share = step > 0 ? std::clamp((wanted - passed) / step, 0.0, 1.0) : 0;
    places.push_back(points[at - 1] + share * (points[at] - points[at - 1]));
  }
  places.push_back(points.back());
  return places;
}

/// Takes out the noise of a pen; the ends stay.
void steady(std::vector<Vec3>& places) {
  for (int pass = 0; pass < steadying_passes; ++pass) {
    for (const double step : {0.5, -0.52}) {  // forth and back, so that curves don't shrink (Taubin 1995)
      std::vector<Vec3> moved = places;
      for (std::size_t i = 1; i + 1 < places.size(); ++i)
        moved[i] += step * ((places[i - 1] + places[i + 1]) / 2 - places[i]);
      places = std::move(moved);
    }
  }
}

/// Angle between the ways to and from a place over a number of places before and after; the row may be a ring.
double turn_at(std::span<const Vec3> places, std::size_t at, std::size_t reach, bool ring) {
  const std::size_t count = ring ? places.size() - 1 : places.size();
  const auto place = [&](std::ptrdiff_t i) {
    const auto n = static_cast<std::ptrdiff_t>(count);
    return places[static_cast<std::size_t>(ring ? (i % n + n) % n : i)];
  };
  const auto i = static_cast<std::ptrdiff_t>(at);
  const auto r = static_cast<std::ptrdiff_t>(reach);
  return angle_between(place(i) - place(i - r), place(i + r) - place(i));
}

/// Positions of sharp corners, ascending.
/// @param step px, the longest way between two events: a corner that falls between them is cut off by so much
std::vector<std::size_t> corners_of(std::span<const Vec3> places, bool ring, double step,
                                    const StrokeCurveOptions& options) {
  const double pixels = std::max(options.corner_reach, steps_in_reach * step);
  const auto reach = std::max<std::size_t>(2, static_cast<std::size_t>(pixels / spacing_pixels));
  const double least = options.corner_degrees * std::numbers::pi / 180;
  std::vector<std::size_t> corners;
  std::vector<double> turns(places.size());
  const std::size_t margin = ring ? 0 : reach;
  if (places.size() < 2 * reach + 2) return corners;
  for (std::size_t i = margin; i + std::max<std::size_t>(margin, 1) < places.size(); ++i) {
    turns[i] = turn_at(places, i, reach, ring);
    if (turn_at(places, i, reach / 2, ring) < corner_sharpness * turns[i]) turns[i] = 0;
  }
  const std::size_t count = ring ? turns.size() - 1 : turns.size();  // a ring's last place is its first
  for (std::size_t i = 0; i < count; ++i) {
    bool sharpest = turns[i] >= least;
    for (std::size_t k = 1; k <= reach && sharpest; ++k) {
      if (ring || i >= k) sharpest = turns[(i + count - k) % count] < turns[i];
      if (ring || i + k < count) sharpest = sharpest && turns[(i + k) % count] <= turns[i];
    }
    if (sharpest) corners.push_back(i);
  }
  return corners;
}

bool is_line(std::span<const Vec3> places, const StrokeCurveOptions& options) {
  const Vec3 way = places.back() - places.front();
  const double allowed = std::max(options.straight_share * way.norm(), least_line_pixels * options.unit);
  return std::ranges::all_of(places, [&](const Vec3& place) {
    const double share = std::clamp((place - places.front()).dot(way) / std::max(way.squaredNorm(), 1e-300), 0.0, 1.0);
    return (place - places.front() - share * way).norm() <= allowed;
  });
}

/// How far places are beside the stroke that was meant, one standard deviation: from third differences, which smooth
/// curves hardly have, and their median, which corners don't change.
double pen_noise(std::span<const Vec3> points) {
  constexpr double deviation_of_median = 1.4826;  // of normal noise
  const double growth = std::sqrt(20.0);          // 1 + 9 + 9 + 1: of noise in a third difference
  std::vector<double> sizes;
  for (std::size_t i = 0; i + 3 < points.size(); ++i) {
    const Vec3 along = unit_or_zero(points[i + 3] - points[i]);
    const Vec3 difference = points[i + 3] - 3 * points[i + 2] + 3 * points[i + 1] - points[i];
    sizes.push_back((difference - difference.dot(along) * along).norm());
  }
  if (sizes.empty()) return 0;
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::ranges::nth_element(sizes, middle);
  return deviation_of_median / growth * *middle;
}

/// A stroke on the way to its curves.
class StrokeRow {
 public:
  StrokeRow(std::span<const Vec3> points, const StrokeCurveOptions& options)
      : options_(options), places_(evenly_spaced(points, spacing_pixels * options.unit)) {
    noise_ = pen_noise(points);
    const double gap = (places_.back() - places_.front()).norm();
    const double length = row_length(points);
    closed_ = gap <= std::max(closing_pixels * options.unit, closing_miss * length) && gap <= closing_share * length;
    if (closed_) close();
    corners_ = corners_of(places_, closed_, longest_step(points) / options.unit, options);
    if (closed_) turn_to_corner();
  }

  std::vector<std::vector<Vec3>> curves() const {
    std::vector<std::vector<Vec3>> curves;
    std::vector<std::size_t> cuts = {0};
    const bool smooth = closed_ && corners_.empty();
    const std::size_t last = places_.size() - 1;
    for (std::size_t part = 1; smooth && part < smooth_loop_parts; ++part)
      cuts.push_back(last * part / smooth_loop_parts);
    for (const std::size_t corner : corners_) {
      if (corner > 0 && corner < last) cuts.push_back(corner);
    }
    if (closed_ && !smooth && cuts.size() == 1) cuts.push_back(last / 2);  // a drop: one corner
    cuts.push_back(last);
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) add_part(cuts[i], cuts[i + 1], curves);
    if (closed_) curves.back().back() = curves.front().front();
    return curves;
  }

 private:
  /// Brings the end to the start, the more the nearer to the end.
  void close() {
    const Vec3 gap = places_.front() - places_.back();
    const auto last = static_cast<double>(places_.size() - 1);
    for (std::size_t i = 0; i < places_.size(); ++i) places_[i] += gap * (static_cast<double>(i) / last);
    places_.back() = places_.front();
  }

  /// Begins a loop at its first corner.
  void turn_to_corner() {
    if (corners_.empty() || corners_.front() == 0) return;
    const std::size_t shift = corners_.front();
    places_.pop_back();
    std::ranges::rotate(places_, places_.begin() + static_cast<std::ptrdiff_t>(shift));
    places_.push_back(places_.front());
    for (std::size_t& corner : corners_) corner -= shift;
  }

  /// Direction along the row where two parts of a loop go on smoothly.
  std::optional<Vec3> smooth_direction(std::size_t at, std::span<const Vec3> whole) const {
    if (!closed_ || std::ranges::find(corners_, at % (whole.size() - 1)) != corners_.end()) return std::nullopt;
    const Vec3 direction = row_direction(whole.subspan(0, whole.size() - 1), at % (whole.size() - 1),
                                         4 * spacing_pixels * options_.unit, true);
    return direction.norm() > 0 ? std::optional(direction) : std::nullopt;
  }

  void add_part(std::size_t from, std::size_t to, std::vector<std::vector<Vec3>>& curves) const {
    std::vector<Vec3> part(places_.begin() + static_cast<std::ptrdiff_t>(from),
                           places_.begin() + static_cast<std::ptrdiff_t>(to + 1));
    if (is_line(part, options_)) {
      curves.push_back({part.front(), part.back()});
      return;
    }
    steady(part);
    const double tolerance = std::max(options_.tolerance * options_.unit, options_.noise_share * noise_);
    const BezierFitOptions fit{tolerance, options_.most_degree, true, smooth_direction(from, places_),
                               smooth_direction(to, places_)};
    for (const FittedBezier& fitted : fit_beziers(part, fit)) curves.push_back(fitted.control);
  }

  StrokeCurveOptions options_;
  std::vector<Vec3> places_;
  double noise_ = 0;
  bool closed_ = false;
  std::vector<std::size_t> corners_;
};

}  // namespace

std::vector<std::vector<Vec3>> curves_of_stroke(std::span<const Vec3> points, const StrokeCurveOptions& options) {
  // A slow hand leaves many places close together, whose noise would count as length and as turns.
  std::vector<Vec3> different;
  for (const Vec3& point : points) {
    if (different.empty() || (point - different.back()).norm() >= least_step_pixels * options.unit)
      different.push_back(point);
  }
  if (different.size() > 1) different.back() = points.back();
  const auto far = [&](const Vec3& point) {
    return (point - different.front()).norm() >= options.smallest * options.unit;
  };
  if (std::ranges::none_of(different, far)) return {};
  return StrokeRow(different, options).curves();
}

}  // namespace croquis
