// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Geometry>

#include "croquis/geometry/vector.h"

namespace croquis {

/// A piece of a subpath, from the end of the piece before it. All three kinds stay what they are under an affine map.
struct SvgSegment {
  enum class Kind { Line, Cubic, Arc };

  Kind kind = Kind::Line;
  Vec2 end = Vec2::Zero();
  Vec2 a = Vec2::Zero();       ///< cubic: first handle; arc: first half axis
  Vec2 b = Vec2::Zero();       ///< cubic: second handle; arc: second half axis
  Vec2 centre = Vec2::Zero();  ///< arc: centre + cos(angle) a + sin(angle) b
  double angle = 0;            ///< arc: where it begins
  double sweep = 0;            ///< arc: by how much the angle grows
};

struct SvgSubpath {
  Vec2 start = Vec2::Zero();
  std::vector<SvgSegment> segments;
  bool closed = false;

  Vec2 last() const { return segments.empty() ? start : segments.back().end; }
};

struct SvgArcShape {
  double radius_x = 0;
  double radius_y = 0;
  double rotation = 0;  ///< degrees
  bool large = false;
  bool positive = false;
};

SvgSegment svg_line(const Vec2& end);
SvgSegment svg_cubic(const Vec2& a, const Vec2& b, const Vec2& end);

/// The elliptical arc of path data; a line when a radius is 0, radii enlarged when they are too short to reach.
/// SVG 1.1, F.6.5 and F.6.6.
SvgSegment svg_arc(const Vec2& from, const SvgArcShape& shape, const Vec2& to);

/// A full turn that begins and ends at centre + (radius_x, 0).
SvgSubpath svg_ellipse(const Vec2& centre, double radius_x, double radius_y);

void transform(SvgSubpath& subpath, const Eigen::Affine2d& map);

/// The point of a segment at t in [0,1]. @param from where it begins
Vec2 point_on(const SvgSegment& segment, const Vec2& from, double t);

/// Into how many straight pieces a segment must be cut to stay within a distance of it; bounded.
int pieces_within(const SvgSegment& segment, const Vec2& from, double tolerance);

}  // namespace croquis
