// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/attribute_surface/reference_surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <Eigen/Geometry>

namespace croquis::test {
namespace {

using Control = std::vector<Vec3>;

constexpr double pi = std::numbers::pi;

/// Sum of Bernstein polynomials times control points.
Vec3 bernstein_sum(const Control& control, double t) {
  const int degree = static_cast<int>(control.size()) - 1;
  Vec3 sum = Vec3::Zero();
  double binomial = 1;
  for (int i = 0; i <= degree; ++i) {
    sum += binomial * std::pow(t, i) * std::pow(1 - t, degree - i) * control[static_cast<std::size_t>(i)];
    binomial = binomial * (degree - i) / (i + 1);
  }
  return sum;
}

Control differences(const Control& control) {
  Control result;
  for (std::size_t i = 1; i < control.size(); ++i)
    result.emplace_back(static_cast<double>(control.size() - 1) * (control[i] - control[i - 1]));
  return result;
}

/// Length from 0 to t: Gauss with five places on many parts.
double length_to(const Control& derivative, double t) {
  constexpr int parts = 200;
  constexpr double nodes[] = {-0.906179845938663993, -0.538469310105683091, 0, 0.538469310105683091,
                              0.906179845938663993};
  constexpr double weights[] = {0.236926885056189088, 0.478628670499366468, 0.568888888888888889, 0.478628670499366468,
                                0.236926885056189088};
  double sum = 0;
  for (int part = 0; part < parts; ++part) {
    for (int k = 0; k < 5; ++k)
      sum += weights[k] * bernstein_sum(derivative, t * (part + 0.5 + 0.5 * nodes[k]) / parts).norm();
  }
  return sum * t / (2 * parts);
}

Control control_of(const SurfaceSide& side) {
  Control control = side.curve->control();
  if (side.reversed) std::ranges::reverse(control);
  return control;
}

/// The parameter at a fraction of the length, by Newton's method kept inside a bracket.
double parameter_at(const Control& control, double fraction) {
  if (fraction <= 0 || fraction >= 1) return fraction <= 0 ? 0 : 1;
  const Control derivative = differences(control);
  const double wanted = fraction * length_to(derivative, 1);
  double low = 0, high = 1, t = fraction;
  for (int step = 0; step < 60 && high - low > 1e-15; ++step) {
    const double miss = length_to(derivative, t) - wanted;
    (miss > 0 ? high : low) = t;
    double next = t - miss / bernstein_sum(derivative, t).norm();
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (std::abs(next - t) < 1e-16) break;
    t = next;
  }
  return t;
}

Vec3 turned_towards(const Vec3& from, const Vec3& to, double t) {
  const double angle = angle_between(from, to);
  if (angle < 1e-12) return from;
  return (std::sin((1 - t) * angle) * from + std::sin(t * angle) * to) / std::sin(angle);
}

Vec3 fence_normal(const NormalFence& fence, double t) {
  std::size_t k = 1;
  while (k + 1 < fence.at.size() && fence.at[k] < t) ++k;
  const double part = (t - fence.at[k - 1]) / (fence.at[k] - fence.at[k - 1]);
  return turned_towards(fence.normals[k - 1], fence.normals[k], part);
}

std::vector<double> relaxed(std::vector<double> lengths) {
  const auto count = static_cast<double>(lengths.size());
  double sum = std::accumulate(lengths.begin(), lengths.end(), 0.0);
  for (double& length : lengths) length = std::max(length, 1e-3 * sum);
  sum = std::accumulate(lengths.begin(), lengths.end(), 0.0);
  for (double& length : lengths) length /= sum;
  const double longest = *std::ranges::max_element(lengths);
  const double excess = longest - 0.95 * (1 - longest);
  if (excess <= 1e-14) return lengths;
  const double beta = excess / (excess + (0.95 * (count - 1) - 1) / count);
  for (double& length : lengths) length = (1 - beta) * length + beta / count;
  return lengths;
}

/// The polygon in a circle found by walking: for a bend between -pi and pi of the longest side's half angle.
std::vector<Vec2> polygon_in_circle(const std::vector<double>& lengths) {
  const auto longest = std::ranges::max_element(lengths);
  const auto half_angle = [&](double length, double phi) {
    return std::asin(std::min(1.0, length / *longest * std::sin(phi)));
  };
  const auto others = [&](double phi) {
    double sum = 0;
    for (auto each = lengths.begin(); each != lengths.end(); ++each)
      sum += each == longest ? 0 : half_angle(*each, phi);
    return sum;
  };
  double low = 1e-9, high = pi - 1e-9;      // others(phi) + phi - pi is negative below the root and positive above it,
  for (int step = 0; step < 200; ++step) {  // up to pi / 2 at least; behind it, it falls back to 0 at pi
    const double phi = 0.5 * (low + high);
    const bool above = phi <= pi / 2 ? others(phi) + phi > pi : others(phi) > pi - phi;
    (above ? high : low) = phi;
  }
  const double phi = 0.5 * (low + high), radius = *longest / (2 * std::sin(phi));
  std::vector<Vec2> corners;
  double angle = 0.3;
  for (auto each = lengths.begin(); each != lengths.end(); ++each) {
    corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    angle += each == longest ? 2 * phi : 2 * half_angle(*each, phi);
  }
  return corners;
}

std::vector<Vec2> regular(std::size_t sides) {
  std::vector<Vec2> corners;
  if (sides == 3) corners = {{0, 0}, {1, 0}, {0, 1}};
  if (sides == 4) corners = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (std::size_t i = 0; sides > 4 && i < sides; ++i) {
    const double angle = 2 * pi * static_cast<double>(i) / static_cast<double>(sides);
    corners.emplace_back(std::cos(angle), std::sin(angle));
  }
  double perimeter = 0;
  for (std::size_t i = 0; i < sides; ++i) perimeter += (corners[(i + 1) % sides] - corners[i]).norm();
  for (Vec2& corner : corners) corner /= perimeter;
  return corners;
}

Vec2 centroid_of(const std::vector<Vec2>& corners) {
  double area = 0;
  Vec2 sum = Vec2::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
    area += cross(a, b) / 2;
    sum += cross(a, b) * (a + b) / 6;
  }
  return sum / area;
}

}  // namespace

ReferenceSurface::ReferenceSurface(const SurfaceFrame& frame, std::vector<ReferencePoint> points)
    : frame_(frame), points_(std::move(points)) {
  std::vector<double> lengths;
  const bool two = frame_.sides.size() == 2;
  for (const SurfaceSide& side : frame_.sides) {
    const double length = length_to(differences(side.curve->control()), 1);
    sigma_ += length;
    if (!two) sides_.push_back({&side, 0, 1, length});
    if (two) sides_.insert(sides_.end(), {{&side, 0, 0.5, length / 2}, {&side, 0.5, 1, length / 2}});
  }
  for (const Side& side : sides_) lengths.push_back(side.length);
  corners_ =
      frame_.domain == AttributeDomain::Chordlength ? polygon_in_circle(relaxed(lengths)) : regular(sides_.size());
}

Vec3 ReferenceSurface::curve_place(const Side& side, double t) const {
  const Control control = control_of(*side.source);
  return bernstein_sum(control, parameter_at(control, side.from + t * (side.to - side.from)));
}

Vec3 ReferenceSurface::curve_derivative(const Side& side, double t) const {
  const Control control = control_of(*side.source), derivative = differences(control);
  const Vec3 direction = bernstein_sum(derivative, parameter_at(control, side.from + t * (side.to - side.from)));
  return side.length * direction.normalized();
}

Vec3 ReferenceSurface::continued(const Side& side, double t) const {
  if (t < 0) return curve_place(side, 0) + t * curve_derivative(side, 0);
  if (t > 1) return curve_place(side, 1) + (t - 1) * curve_derivative(side, 1);
  return curve_place(side, t);
}

Vec3 ReferenceSurface::inward(const Side& side, double t) const {
  const Vec3 along = curve_derivative(side, t).normalized();
  Vec3 normal = fence_normal(side.source->fence, side.from + t * (side.to - side.from));
  normal = (normal - normal.dot(along) * along).normalized();
  return side.source->fence.magnitude * normal.cross(along);
}

double ReferenceSurface::distance(std::size_t side, const Vec2& q) const {
  const Vec2 along = corners_[(side + 1) % corners_.size()] - corners_[side];
  return cross(along, q - corners_[side]) / along.norm();
}

double ReferenceSurface::parameter(std::size_t side, const Vec2& q) const {
  const Vec2 along = corners_[(side + 1) % corners_.size()] - corners_[side];
  return along.dot(q - corners_[side]) / along.squaredNorm();
}

double ReferenceSurface::side_weights(const Vec2& q) const {
  double sum = 0;
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const double length = (corners_[(i + 1) % corners_.size()] - corners_[i]).norm();
    sum += std::pow(length / distance(i, q), 2);
  }
  return sum;
}

Vec2 ReferenceSurface::place_of(const FanPlace& fan) const {
  const Vec2 middle = std::accumulate(corners_.begin(), corners_.end(), Vec2(Vec2::Zero())) / corners_.size();
  return middle + fan.a * (corners_[fan.corner] - middle) +
         fan.b * (corners_[(fan.corner + 1) % corners_.size()] - middle);
}

Vec3 ReferenceSurface::base(const Vec2& q) const {
  const bool smooth = frame_.mode == AttributeMode::Smooth;
  Vec3 flat = Vec3::Zero(), ribbons = Vec3::Zero();
  double once = 0, twice = 0;
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const double t = parameter(i, q), h = distance(i, q);
    const double w = (corners_[(i + 1) % corners_.size()] - corners_[i]).norm() / h;
    const Vec3 place = continued(sides_[i], t);
    flat += w * place;
    once += w;
    if (!smooth) continue;
    ribbons += w * w * (place + sigma_ * h * inward(sides_[i], std::clamp(t, 0.0, 1.0)));
    twice += w * w;
  }
  flat /= once;
  if (!smooth) return flat;
  ribbons /= twice;
  const double bubble = side_weights(centroid_of(corners_)) / side_weights(q);
  return ribbons + (1 - frame_.fullness) * bubble * (flat - ribbons);
}

Vec3 ReferenceSurface::paper(const Vec2& q) const {
  Vec3 sum = Vec3::Zero();
  double weights = 0;
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const double t = std::clamp(parameter(i, q), 0.0, 1.0);
    const Vec2 foot = corners_[i] + t * (corners_[(i + 1) % corners_.size()] - corners_[i]);
    const double w = 1 / (q - foot).norm();
    sum += w * curve_place(sides_[i], t);
    weights += w;
  }
  for (const ReferencePoint& point : points_) {
    const double w = 1 / (q - place_of(point.fan)).norm();
    sum += w * point.point;
    weights += w;
  }
  return sum / weights;
}

double ReferenceSurface::half_height(const ReferencePoint& point) const {
  if (point.radius) return *point.radius / sigma_;
  double least = 1;
  for (std::size_t i = 0; i < sides_.size(); ++i) least = std::min(least, distance(i, place_of(point.fan)));
  return least / 2;
}

Vec3 ReferenceSurface::base_at(const FanPlace& fan) const { return base(place_of(fan)); }

Vec3 ReferenceSurface::at(const FanPlace& fan) const {
  const Vec2 q = place_of(fan);
  if (frame_.mode == AttributeMode::Paper) return paper(q);
  Vec3 sum = Vec3::Zero();
  double weights = side_weights(q);
  for (const ReferencePoint& point : points_) {
    const Vec2 foot = place_of(point.fan);
    const double rho = half_height(point), r = (q - foot).norm();
    if (r >= 3 * rho) continue;
    const double fade = std::pow(1 - std::pow(r / (3 * rho), 2), 2);
    const double w = side_weights(foot) * fade * std::pow(rho / r, point.profile == PointProfile::Cone ? 1 : 2);
    sum += w * (point.point - base(foot));
    weights += w;
  }
  return base(q) + sum / weights;
}

}  // namespace croquis::test
