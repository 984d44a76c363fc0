// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/strokes/stroke_fit.h"

#include <algorithm>
#include <cmath>

#include "tools/strokes/cubic_fit.h"
#include "tools/strokes/fit_points.h"

namespace croquis {
namespace {

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

  void tell(StrokeFit& fit) const {
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
  residuals.tell(fit);
  return fit;
}

}  // namespace croquis
