// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/svg/svg_shapes.h"

namespace croquis {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double most_pieces = 65536;

/// Angle from u to v in (-pi, pi].
double signed_angle(const Vec2& u, const Vec2& v) { return std::atan2(cross(u, v), u.dot(v)); }

/// Centre of the unit circle through p and q that the two flags choose (F.6.5, in the frame where radii are 1).
Vec2 unit_centre(const Vec2& p, const Vec2& q, const SvgArcShape& shape) {
  const Vec2 half = (q - p) / 2;
  const double apart = half.squaredNorm();
  const double away = std::sqrt(std::max(0.0, (1 - apart) / apart));
  const double side = shape.large == shape.positive ? -1 : 1;
  return (p + q) / 2 + side * away * left_of(half);
}

}  // namespace

SvgSegment svg_line(const Vec2& end) {
  SvgSegment segment;
  segment.end = end;
  return segment;
}

SvgSegment svg_cubic(const Vec2& a, const Vec2& b, const Vec2& end) {
  SvgSegment segment = svg_line(end);
  segment.kind = SvgSegment::Kind::Cubic;
  segment.a = a;
  segment.b = b;
  return segment;
}

SvgSegment svg_arc(const Vec2& from, const SvgArcShape& shape, const Vec2& to) {
  SvgSegment segment = svg_line(to);
  const Vec2 radii(std::abs(shape.radius_x), std::abs(shape.radius_y));
  if (radii.minCoeff() == 0 || from == to) return segment;
  const Eigen::Rotation2Dd turn(std::remainder(shape.rotation, 360.0) * pi / 180);
  // The frame in which the ellipse is a unit circle about some centre, with `from` as origin to keep digits.
  const Vec2 chord = (turn.inverse() * (to - from)).cwiseQuotient(radii);
  const double scale = std::max(1.0, chord.norm() / 2);
  const Vec2 q = chord / scale;
  if (!q.allFinite() || q.norm() == 0) return segment;
  const Vec2 centre = unit_centre(Vec2::Zero(), q, shape);
  segment.kind = SvgSegment::Kind::Arc;
  segment.a = scale * radii.x() * (turn * Vec2::UnitX());
  segment.b = scale * radii.y() * (turn * Vec2::UnitY());
  segment.centre = from + centre.x() * segment.a + centre.y() * segment.b;
  segment.angle = std::atan2(-centre.y(), -centre.x());
  segment.sweep = signed_angle(-centre, q - centre);
  if (shape.positive && segment.sweep < 0) segment.sweep += 2 * pi;
  if (!shape.positive && segment.sweep > 0) segment.sweep -= 2 * pi;
  return segment;
}

SvgSubpath svg_ellipse(const Vec2& centre, double radius_x, double radius_y) {
  SvgSubpath subpath;
  subpath.start = centre + Vec2(radius_x, 0);
  subpath.closed = true;
  SvgSegment turn;
  turn.kind = SvgSegment::Kind::Arc;
  turn.end = subpath.start;
  turn.a = Vec2(radius_x, 0);
  turn.b = Vec2(0, radius_y);
  turn.centre = centre;
  turn.sweep = 2 * pi;
  subpath.segments.push_back(turn);
  return subpath;
}

void transform(SvgSubpath& subpath, const Eigen::Affine2d& map) {
  subpath.start = map * subpath.start;
  for (SvgSegment& segment : subpath.segments) {
    const bool arc = segment.kind == SvgSegment::Kind::Arc;
    segment.end = map * segment.end;
    segment.a = arc ? Vec2(map.linear() * segment.a) : Vec2(map * segment.a);
    segment.b = arc ? Vec2(map.linear() * segment.b) : Vec2(map * segment.b);
    segment.centre = map * segment.centre;
  }
}

Vec2 point_on(const SvgSegment& segment, const Vec2& from, double t) {
  if (t >= 1) return segment.end;
  const double s = 1 - t;
  switch (segment.kind) {
    case SvgSegment::Kind::Line: return s * from + t * segment.end;
    case SvgSegment::Kind::Cubic:
      return s * s * s * from + 3 * s * s * t * segment.a + 3 * s * t * t * segment.b + t * t * t * segment.end;
    case SvgSegment::Kind::Arc: break;
  }
  const double angle = segment.angle + t * segment.sweep;
  return segment.centre + std::cos(angle) * segment.a + std::sin(angle) * segment.b;
}

int pieces_within(const SvgSegment& segment, const Vec2& from, double tolerance) {
  // A chord over a parameter step h is at most |c''| h^2 / 8 away from its curve.
  double bend = 0;
  if (segment.kind == SvgSegment::Kind::Cubic) {
    const double first = (from - 2 * segment.a + segment.b).norm();
    const double second = (segment.a - 2 * segment.b + segment.end).norm();
    bend = 6 * std::max(first, second);
  } else if (segment.kind == SvgSegment::Kind::Arc) {
    bend = std::hypot(segment.a.norm(), segment.b.norm()) * segment.sweep * segment.sweep;
  }
  if (bend == 0 || tolerance <= 0) return 1;
  const double pieces = std::ceil(std::sqrt(bend / (8 * tolerance)));
  return std::isfinite(pieces) ? static_cast<int>(std::clamp(pieces, 1.0, most_pieces)) : 1;
}

}  // namespace croquis
