// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/perspective/stroke_shape.h"

#include <algorithm>
#include <cmath>

#include "croquis/geometry/polyline.h"
#include "croquis/tools/strokes/stroke_fit.h"
#include "tools/strokes/cubic_fit.h"

namespace croquis {
namespace {

/// Pixels of the view: a gesture that reaches no farther is a click.
constexpr double least_reach_px = 6;

/// How far a line of the hand bends from its chord, as a share of the chord, and in pixels.
constexpr double bend_share = 0.022, bend_px = 2;
constexpr double exact_share = 0.008, exact_px = 1.2;

/// RMS tolerance of a curve, as a share of its length, and in pixels. Every piece more is one more patch: few are
/// wanted.
constexpr double curve_share = 0.005, curve_px = 1;

/// A loop's ends are nearer to each other than this share of its length, or that many pixels.
constexpr double loop_share = 0.06, loop_px = 14;

/// Corners: turns by more than this within that many pixels, or within that share of a short gesture's length: there a
/// bend is as narrow as a corner of a long one.
constexpr double corner_degrees = 42, corner_reach_px = 14, corner_reach_share = 0.12, least_corner_reach_px = 4;

/// Pixels, and a share of the gesture: a shorter part at its end is where the pen slipped.
constexpr double slip_px = 12, slip_share = 0.2;

/// Pixels over which a curve's direction is taken.
constexpr double tangent_reach_px = 8;

constexpr std::size_t loop_parts = 4;

double largest_distance(std::span<const Vec2> places, const Vec2& from) {
  double largest = 0;
  for (const Vec2& place : places) largest = std::max(largest, (place - from).norm());
  return largest;
}

/// From the chord, the farthest. Parts that go back behind the chord's ends count, too.
double bend_of(std::span<const Vec2> places) {
  const Vec2 chord = places.back() - places.front();
  const double chord_length = chord.norm();
  double largest = 0;
  for (const Vec2& place : places) {
    const Vec2 offset = place - places.front();
    const double along = chord_length > 0 ? offset.dot(chord) / chord_length : 0;
    const double beyond = std::max({-along, along - chord_length, 0.0});
    const double aside = chord_length > 0 ? std::abs(cross(chord, offset)) / chord_length : offset.norm();
    largest = std::max({largest, beyond, aside});
  }
  return largest;
}

bool is_straight(std::span<const Vec2> places, const ShapeOptions& options) {
  if (options.straightness == Straightness::Always) return true;
  const bool exact = options.straightness == Straightness::WhenExact;
  const double share = (exact ? exact_share : bend_share) * (places.back() - places.front()).norm();
  return bend_of(places) <= std::max(share, (exact ? exact_px : bend_px) * options.units_per_pixel);
}

/// The line with the least squares of distances, from the foot of the first place to that of the last: all of the
/// gesture says where it points, not its ends alone.
StrokeShape line_through(const std::vector<Vec2>& places) {
  // Weighted by length, so that a hand that rests doesn't count more.
  Vec2 mean = Vec2::Zero();
  double total = 0;
  const auto each_part = [&](const auto& use) {
    for (std::size_t i = 1; i < places.size(); ++i)
      use(Vec2((places[i - 1] + places[i]) / 2), (places[i] - places[i - 1]).norm());
  };
  each_part([&](const Vec2& middle, double weight) {
    mean += weight * middle;
    total += weight;
  });
  mean /= total;
  double xx = 0, xy = 0, yy = 0;
  each_part([&](const Vec2& middle, double weight) {
    const Vec2 d = middle - mean;
    xx += weight * d.x() * d.x();
    xy += weight * d.x() * d.y();
    yy += weight * d.y() * d.y();
  });
  const double angle = std::atan2(2 * xy, xx - yy) / 2;
  const Vec2 along(std::cos(angle), std::sin(angle));
  const auto foot = [&](const Vec2& place) { return Vec2(mean + (place - mean).dot(along) * along); };
  return {{line_piece(foot(places.front()), foot(places.back()))}, true};
}

FitOptions fit_options(std::span<const Vec2> places, const ShapeOptions& options) {
  FitOptions fit;
  fit.units_per_pixel = options.units_per_pixel;
  fit.tolerance = std::max(curve_px, curve_share * length(places, false) / options.units_per_pixel);
  fit.corner_degrees = corner_degrees;
  const double pixels = length(places, false) / options.units_per_pixel;
  fit.corner_reach = std::clamp(corner_reach_share * pixels, least_corner_reach_px, corner_reach_px);
  return fit;
}

Stroke samples_of(std::span<const Vec2> places, bool closed) {
  Stroke stroke;
  stroke.id = "drawn";
  stroke.closed = closed;
  for (const Vec2& place : places) {
    stroke.samples.emplace_back();
    stroke.samples.back().position = place;
  }
  return stroke;
}

StrokeShape curve_through(const std::vector<Vec2>& places, const ShapeOptions& options) {
  FitOptions fit = fit_options(places, options);
  fit.corner_degrees = 180;
  return {fit_stroke(samples_of(places, false), fit).segments, false};
}

/// A loop without corners as four curves whose directions agree where they meet.
std::vector<StrokeShape> quarters(const std::vector<CubicSegment>& loop, double tolerance, double reach) {
  const std::vector<Vec2> places = traced(loop, false, 32);
  const std::vector<double> lengths = arc_lengths(places, false);
  std::vector<std::size_t> breaks = {0};
  for (std::size_t part = 1; part < loop_parts; ++part) {
    const double wanted = lengths.back() * static_cast<double>(part) / loop_parts;
    breaks.push_back(
        static_cast<std::size_t>(std::lower_bound(lengths.begin(), lengths.end(), wanted) - lengths.begin()));
  }
  breaks.push_back(places.size() - 1);
  const Vec2 seam = (loop.front()[1] - loop.front()[0]).normalized();
  const auto direction = [&](std::size_t k) {
    return k == 0 || k == loop_parts ? seam : tangent_within(places, breaks[k], reach);
  };
  std::vector<StrokeShape> shapes;
  for (std::size_t k = 0; k < loop_parts; ++k) {
    StrokeShape shape;
    const std::span<const Vec2> part(places.data() + breaks[k], breaks[k + 1] - breaks[k] + 1);
    for (const FittedPiece& piece : fit_cubics(part, direction(k), direction(k + 1), reach, tolerance))
      shape.pieces.push_back(piece.cubic);
    shapes.push_back(std::move(shape));
  }
  return shapes;
}

/// The samples between corners. @return the loop's own first corner comes first
std::vector<std::vector<Vec2>> between_corners(std::span<const Vec2> places, const StrokeFit& fit) {
  std::vector<std::size_t> breaks;
  for (const StrokeAnchor& anchor : fit.anchors) {
    if (anchor.corner) breaks.push_back(anchor.sample);
  }
  const std::size_t count = places.size();
  if (!fit.closed) {
    breaks.insert(breaks.begin(), 0);
    breaks.push_back(count - 1);
  } else {
    breaks.push_back(breaks.front() + count);
  }
  std::vector<std::vector<Vec2>> runs;
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    std::vector<Vec2> run;
    for (std::size_t i = breaks[k]; i <= breaks[k + 1]; ++i) run.push_back(places[i % count]);
    runs.push_back(std::move(run));
  }
  return runs;
}

/// Neighbours were fitted on their own: lines end beside the corner that they share.
void join(std::vector<StrokeShape>& shapes, bool closed) {
  const std::size_t joints = shapes.size() - (closed ? 0 : 1);
  for (std::size_t k = 0; k < joints; ++k) {
    StrokeShape& before = shapes[k];
    StrokeShape& after = shapes[(k + 1) % shapes.size()];
    const Vec2 corner = (before.end() + after.start()) / 2;
    const Vec2 begin = before.start();
    before = with_ends(std::move(before), begin, corner);
    const Vec2 end = after.end();
    after = with_ends(std::move(after), corner, end);
  }
}

/// An open gesture without short parts at its ends.
void drop_slips(std::vector<std::vector<Vec2>>& runs, double whole, const ShapeOptions& options) {
  const double limit = std::min(slip_px * options.units_per_pixel, slip_share * whole);
  if (runs.size() > 1 && length(runs.front(), false) < limit) runs.erase(runs.begin());
  if (runs.size() > 1 && length(runs.back(), false) < limit) runs.pop_back();
}

bool is_loop(std::span<const Vec2> places, const ShapeOptions& options) {
  if (options.straightness == Straightness::Always) return false;
  const double gap = (places.back() - places.front()).norm();
  const double limit = std::max(loop_share * length(places, false), loop_px * options.units_per_pixel);
  return gap < limit && largest_distance(places, places.front()) > 2 * limit;
}

}  // namespace

PictureCubic line_piece(const Vec2& from, const Vec2& to) {
  return {from, from + (to - from) / 3, from + (to - from) * 2 / 3, to};
}

Vec2 place_on(const PictureCubic& piece, double t) { return point_at(piece, t); }

std::vector<Vec2> traced(const std::vector<PictureCubic>& pieces, bool straight, int per_piece) {
  if (straight) return {pieces.front()[0], pieces.back()[3]};
  std::vector<Vec2> places = {pieces.front()[0]};
  for (const PictureCubic& piece : pieces) {
    for (int i = 1; i <= per_piece; ++i) places.push_back(place_on(piece, static_cast<double>(i) / per_piece));
  }
  return places;
}

std::vector<StrokeShape> shapes_of(std::span<const Vec2> drawn, const ShapeOptions& options) {
  std::vector<Vec2> places;
  for (const Vec2& place : drawn) {
    if (places.empty() || place != places.back()) places.push_back(place);
  }
  if (places.size() < 2 || largest_distance(places, places.front()) < least_reach_px * options.units_per_pixel)
    return {};
  if (options.straightness == Straightness::Always) return {line_through(places)};
  const bool loop = is_loop(places, options);
  FitOptions fitting = fit_options(places, options);
  if (loop) fitting.tolerance = std::max(curve_px, fitting.tolerance / loop_parts);  // as of one part
  const StrokeFit fit = fit_stroke(samples_of(places, loop), fitting);
  const bool corners = std::ranges::any_of(fit.anchors, [](const StrokeAnchor& anchor) { return anchor.corner; });
  if (loop && !corners) {
    const double unit = options.units_per_pixel;
    return quarters(fit.segments, fitting.tolerance * unit, tangent_reach_px * unit);
  }
  std::vector<std::vector<Vec2>> runs = between_corners(places, fit);
  if (!fit.closed) drop_slips(runs, length(places, false), options);
  std::vector<StrokeShape> shapes;
  for (const std::vector<Vec2>& run : runs) {
    if (largest_distance(run, run.front()) < least_reach_px * options.units_per_pixel) continue;
    shapes.push_back(is_straight(run, options) ? line_through(run) : curve_through(run, options));
  }
  if (!shapes.empty()) join(shapes, fit.closed && shapes.size() > 1);
  return shapes;
}

StrokeShape with_ends(StrokeShape shape, const Vec2& start, const Vec2& end) {
  if (shape.straight) {
    shape.pieces = {line_piece(start, end)};
    return shape;
  }
  const Vec2 by_start = start - shape.start();
  const Vec2 by_end = end - shape.end();
  shape.pieces.front()[0] = start;
  shape.pieces.front()[1] += by_start;
  shape.pieces.back()[3] = end;
  shape.pieces.back()[2] += by_end;
  return shape;
}

}  // namespace croquis
