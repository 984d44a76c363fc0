// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/attribute_surface/bridges/rim_face.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include <Eigen/Geometry>

#include "algorithms/attribute_surface/bridges/rim_sides.h"
#include "croquis/geometry/bezier_fit.h"

namespace croquis {
namespace {

constexpr double fit_tolerance = 0.01;  // × mean edge: what is left is moved along
constexpr double edges_of_reach = 3;    // edges of the rim over which misses fade
constexpr double misses_of_reach = 8;   // the same, × the greatest miss: a surface is bent by them hardly
constexpr std::size_t long_rim = 16;    // edges: corners of longer ones are looked for without their teeth
constexpr double least_upright = 0.2;   // cosine: rims that stand up more say nothing of heights
constexpr double least_rise = 1e-6;     // × perimeter
constexpr double usual_fullness = 0.5;
constexpr double least_step = 1e-9;  // between fractions of a curve

double loop_length(const RimLoop& loop) {
  double length = (loop.points.front() - loop.points.back()).norm();
  for (std::size_t i = 1; i < loop.points.size(); ++i) length += (loop.points[i] - loop.points[i - 1]).norm();
  return length;
}

/// Fractions by the nearest places of a curve, or where these don't ascend, as on jagged rims, by the chords.
std::vector<double> ascending_fractions(const FittedBezier& fitted, const ArcLengthCurve& curve,
                                        const std::vector<Vec3>& points) {
  std::vector<double> fractions, chords{0};
  for (const double t : fitted.parameters) fractions.push_back(curve.fraction(t));
  fractions.front() = 0;
  fractions.back() = 1;
  bool ascend = true;
  for (std::size_t i = 1; i < points.size(); ++i) {
    chords.push_back(chords.back() + (points[i] - points[i - 1]).norm());
    ascend = ascend && fractions[i] > fractions[i - 1] + least_step;
  }
  if (ascend) return fractions;
  for (double& chord : chords) chord /= chords.back();
  return chords;
}

/// Every point but corners and its neighbours, 1 : 2 : 1, on the surface that the normals tell: the mean of the points
/// is as far from a round surface on one side as the mean of their tangent planes on the other.
RimLoop blurred(const RimLoop& loop, const std::vector<bool>& is_corner) {
  RimLoop result = loop;
  const std::size_t n = loop.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (is_corner[i]) continue;
    const std::array<std::pair<std::size_t, double>, 3> parts{{{(i + n - 1) % n, 0.25}, {i, 0.5}, {(i + 1) % n, 0.25}}};
    Vec3 point = Vec3::Zero(), normal = Vec3::Zero(), to_planes = Vec3::Zero();
    for (const auto& [j, weight] : parts) {
      point += weight * loop.points[j];
      normal += weight * loop.normals[j];
    }
    for (const auto& [j, weight] : parts)
      to_planes += weight * (loop.points[j] - point).dot(loop.normals[j]) * loop.normals[j];
    result.points[i] = point + to_planes / 2;
    result.normals[i] = unit_or_zero(normal);
  }
  return result;
}

/// The rim without what changes from each point to the next, as where triangles were taken away: curves can't follow
/// that, and surfaces shouldn't. What changes slowly stays.
RimLoop evened_out(const RimLoop& loop, const std::vector<bool>& is_corner) {
  const RimLoop once = blurred(loop, is_corner), twice = blurred(once, is_corner);
  RimLoop result = once;
  for (std::size_t i = 0; i < loop.points.size(); ++i) {
    result.points[i] += once.points[i] - twice.points[i];
    result.normals[i] = unit_or_zero(2 * once.normals[i] - twice.normals[i]);
  }
  return result;
}

/// How high a surface rises over the rim in the middle, along an axis: of the cubics with the rim's heights and slopes
/// through opposite places their mean, which is halfway between the mean height and that of the tangent planes.
double expected_height(const RimLoop& rim, const Vec3& middle, const Vec3& axis) {
  double heights = 0, lengths = 0;
  const std::size_t n = rim.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const double length = (rim.points[(i + 1) % n] - rim.points[(i + n - 1) % n]).norm();
    const double upright = std::max(rim.normals[i].dot(axis), least_upright);
    const Vec3 across = (middle - rim.points[i]) - (middle - rim.points[i]).dot(axis) * axis;
    const double rise = -rim.normals[i].dot(across) / upright;
    heights += length * (rim.points[i].dot(axis) + rise / 2);
    lengths += length;
  }
  return heights / lengths;
}

/// The fullness with which the surface has the height in its middle that the rim lets expect: it depends linearly on
/// it.
double expected_fullness(SurfaceFrame frame, const RimLoop& rim) {
  Vec3 axis = Vec3::Zero();
  for (const Vec3& normal : rim.normals) axis += normal;
  axis = unit_or_zero(axis);
  frame.fullness = 0;
  const FaceSurface flat(frame);
  frame.fullness = 1;
  const FaceSurface full(frame);
  const Vec2 centroid = flat.domain().centroid;
  const double low = flat.at(centroid).dot(axis), high = full.at(centroid).dot(axis);
  if (std::abs(high - low) < least_rise * flat.sigma()) return usual_fullness;
  const Vec3 middle = (flat.at(centroid) + full.at(centroid)) / 2;
  return std::clamp((expected_height(rim, middle, axis) - low) / (high - low), 0.0, 1.0);
}

}  // namespace

RimFace::RimFace(const RimLoop& loop, const RimPatchOptions& options) : is_corner_(loop.points.size(), false) {
  const std::size_t n = loop.points.size();
  const RimCuts cuts =
      cut_rim(n < long_rim ? loop.points : evened_out(loop, is_corner_).points, options.corner, options.sides);
  for (std::size_t k = 0; k < cuts.at.size(); ++k) is_corner_[cuts.at[k]] = cuts.is_corner[k];
  first_point_ = cuts.at.front();
  even_ = evened_out(loop, is_corner_);
  SurfaceFrame frame;
  frame.mode = options.smooth ? AttributeMode::Smooth : AttributeMode::Position;
  frame.fullness = options.fullness.value_or(1);
  for (std::size_t k = 0; k < cuts.at.size(); ++k) {
    const std::size_t edges = (cuts.at[(k + 1) % cuts.at.size()] + n - cuts.at[k]) % n;
    frame.sides.push_back(make_side(loop, cuts.at[k], edges, options));
  }
  if (options.smooth && !options.fullness) frame.fullness = expected_fullness(frame, even_);
  surface_.emplace(frame);
  for (OutlinePlace& at : outline_) at.place = surface_->side_place(at.side, at.fraction);
  miss_reach_ =
      std::max(edges_of_reach / static_cast<double>(n), misses_of_reach * curve_distance_ / surface_->sigma());
}

SurfaceSide RimFace::make_side(const RimLoop& loop, std::size_t from, std::size_t edges,
                               const RimPatchOptions& options) {
  const std::size_t n = loop.points.size();
  std::vector<Vec3> points;
  for (std::size_t e = 0; e <= edges; ++e) points.push_back(even_.points[(from + e) % n]);
  BezierFitOptions fit;
  fit.divide = false;
  fit.tolerance = fit_tolerance * loop_length(loop) / static_cast<double>(n);
  const auto direction_at = [&](std::size_t i) -> std::optional<Vec3> {
    if (is_corner_[i]) return std::nullopt;
    const Vec3 direction = row_direction(even_.points, i, 0, true);
    return direction == Vec3::Zero() ? std::nullopt : std::optional(direction);
  };
  fit.start_direction = direction_at(from);
  fit.end_direction = direction_at((from + edges) % n);
  const FittedBezier fitted = fit_beziers(points, fit).front();
  SurfaceSide side;
  side.curve = std::make_shared<const ArcLengthCurve>(fitted.control);
  const std::vector<double> fractions = ascending_fractions(fitted, *side.curve, points);
  const std::size_t number = sides_++;
  for (std::size_t e = 0; e < edges; ++e) {
    outline_.push_back({Vec2::Zero(), number, fractions[e]});
    misses_.push_back(loop.points[(from + e) % n] - side.curve->at(fractions[e]));
    curve_distance_ = std::max(curve_distance_, misses_.back().norm());
  }
  if (options.smooth) {
    side.fence.at = fractions;
    for (std::size_t e = 0; e <= edges; ++e) side.fence.normals.push_back(even_.normals[(from + e) % n]);
  }
  return side;
}

double RimFace::spacing() const {
  const SurfacePlace middle = surface_->evaluate(surface_->domain().centroid);
  const double stretch = std::sqrt(middle.du.cross(middle.dv).norm()) / surface_->sigma();
  return 1 / static_cast<double>(outline_.size()) / std::clamp(stretch, 0.5, 4.0);
}

/// The nearer a point of the rim, the more of its miss: those that alternate cancel out a little inside.
Vec3 RimFace::miss_at(const Vec2& place) const {
  Vec3 sum = Vec3::Zero();
  double weights = 0;
  for (std::size_t i = 0; i < outline_.size(); ++i) {
    const double distance = std::max((place - outline_[i].place).norm(), 1e-12);
    const double weight = 1 / (distance * distance * distance);
    sum += weight * misses_[i];
    weights += weight;
  }
  return sum / weights;
}

/// Misses fade without a slope at the rim, so that tangent planes there stay the fence's.
Vec3 RimFace::at(const Vec2& place) const {
  const Vec3 point = surface_->at(place);
  const double depth = distance_inside(surface_->domain(), place) / miss_reach_;
  if (depth >= 1 || curve_distance_ == 0) return point;
  return point + (1 - depth * depth * (3 - 2 * depth)) * miss_at(place);
}

}  // namespace croquis
