// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/perspective/solid_builder.h"

#include <algorithm>
#include <numbers>
#include <stdexcept>

#include <Eigen/Geometry>

namespace croquis::test {
namespace {

/// Handle of a quarter of a circle, × its radius.
const double quarter_handle = 4.0 / 3 * (std::numbers::sqrt2 - 1);

Vec3 raised(const Vec2& place, int axis, double level) {
  Vec3 point;
  point[axis] = level;
  point[(axis + 1) % 3] = place.x();
  point[(axis + 2) % 3] = place.y();
  return point;
}

StrokeGroup group_of_line(const Vec3& a, const Vec3& b) {
  for (int axis = 0; axis < 3; ++axis) {
    if (a[(axis + 1) % 3] == b[(axis + 1) % 3] && a[(axis + 2) % 3] == b[(axis + 2) % 3]) {
      return static_cast<StrokeGroup>(axis);
    }
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (a[axis] == b[axis]) return static_cast<StrokeGroup>(3 + axis);
  }
  return StrokeGroup::Unknown;
}

StrokeGroup group_of_curve(const std::vector<RationalCubic>& pieces) {
  for (int axis = 0; axis < 3; ++axis) {
    const double level = pieces[0].points[0][axis];
    const bool flat = std::ranges::all_of(pieces, [&](const RationalCubic& piece) {
      return std::ranges::all_of(piece.points, [&](const Vec3& point) { return point[axis] == level; });
    });
    if (flat) return static_cast<StrokeGroup>(3 + axis);
  }
  throw std::logic_error("a curve lies in no plane at right angles to an axis");
}

std::string curve_id(std::size_t number) {
  const std::string digits = std::to_string(number);
  return (digits.size() < 2 ? "e0" : "e") + digits;
}

}  // namespace

SideLoop reversed(const SideLoop& loop) {
  SideLoop result(loop.rbegin(), loop.rend());
  for (SolidSide& side : result) side.reversed = !side.reversed;
  return result;
}

Profile polygon(std::initializer_list<Vec2> points) {
  Profile result;
  for (const Vec2& point : points) result.push_back({point, {}});
  return result;
}

Profile rectangle(const Vec2& low, const Vec2& high) {
  return polygon({low, {high.x(), low.y()}, high, {low.x(), high.y()}});
}

std::array<Vec2, 3> quarter(const Vec2& centre, const Vec2& a, const Vec2& b) {
  return {centre + a + quarter_handle * b, centre + b + quarter_handle * a, centre + b};
}

Profile circle(const Vec2& centre, double radius) {
  Profile result;
  Vec2 a(radius, 0);
  for (int i = 0; i < 4; ++i) {
    const Vec2 b = left_of(a);
    result.push_back({centre + a, {quarter(centre, a, b)}});
    a = b;
  }
  return result;
}

Index SolidBuilder::vertex(double x, double y, double z) {
  solid_.network.vertices.emplace_back(x, y, z);
  return static_cast<Index>(solid_.network.vertices.size() - 1);
}

Index SolidBuilder::line(Index a, Index b) {
  auto& curves = solid_.network.curves;
  solid_.groups.push_back(group_of_line(position(a), position(b)));
  curves.push_back({curve_id(curves.size()), a, b, {straight_cubic(position(a), position(b))}, true});
  return static_cast<Index>(curves.size() - 1);
}

Index SolidBuilder::curve(Index a, Index b, std::vector<std::array<Vec3, 3>> pieces) {
  NetworkCurve curve{curve_id(solid_.network.curves.size()), a, b, {}, false};
  pieces.back()[2] = position(b);
  Vec3 start = position(a);
  for (const auto& piece : pieces) {
    curve.pieces.push_back({{start, piece[0], piece[1], piece[2]}});
    start = piece[2];
  }
  solid_.groups.push_back(group_of_curve(curve.pieces));
  solid_.network.curves.push_back(std::move(curve));
  return static_cast<Index>(solid_.network.curves.size() - 1);
}

Index SolidBuilder::curve(Index a, Index b, const Vec3& first_handle, const Vec3& second_handle) {
  return curve(a, b, {{first_handle, second_handle, position(b)}});
}

SolidSide SolidBuilder::side(Index from, Index to) const {
  for (Index i = 0; i < solid_.network.curves.size(); ++i) {
    const NetworkCurve& curve = solid_.network.curves[i];
    if (curve.start == from && curve.end == to) return {i, false};
    if (curve.start == to && curve.end == from) return {i, true};
  }
  throw std::logic_error("no curve between two vertices of a face");
}

void SolidBuilder::face(std::initializer_list<Index> vertices, bool planar) {
  const std::vector<Index> corners(vertices);
  SideLoop loop;
  for (std::size_t i = 0; i < corners.size(); ++i) loop.push_back(side(corners[i], corners[(i + 1) % corners.size()]));
  face({loop}, planar);
}

void SolidBuilder::face(std::vector<SideLoop> loops, bool planar) {
  solid_.faces.push_back({std::move(loops), planar});
}

Index SolidBuilder::add_profile_side(const PrismShape& shape, std::size_t number, double level,
                                     const std::vector<Index>& ring) {
  const ProfileSide& side = shape.profile[number];
  const Index from = ring[number], to = ring[(number + 1) % ring.size()];
  if (side.pieces.empty()) return line(from, to);
  std::vector<std::array<Vec3, 3>> pieces;
  for (const auto& [first, second, end] : side.pieces) {
    pieces.push_back(
        {raised(first, shape.axis, level), raised(second, shape.axis, level), raised(end, shape.axis, level)});
  }
  return curve(from, to, std::move(pieces));
}

Prism SolidBuilder::prism(const PrismShape& shape) {
  Prism result;
  const std::size_t sides = shape.profile.size();
  const auto add_ring = [&](double level) {
    std::vector<Index> ring;
    for (const ProfileSide& corner : shape.profile) {
      const Vec3 point = raised(corner.start, shape.axis, level);
      ring.push_back(vertex(point.x(), point.y(), point.z()));
    }
    return ring;
  };
  result.low = add_ring(shape.from);
  result.high = add_ring(shape.to);
  std::vector<Index> low, high, upright;
  for (std::size_t i = 0; i < sides; ++i) low.push_back(add_profile_side(shape, i, shape.from, result.low));
  for (std::size_t i = 0; i < sides; ++i) high.push_back(add_profile_side(shape, i, shape.to, result.high));
  for (std::size_t i = 0; i < sides; ++i) upright.push_back(line(result.low[i], result.high[i]));
  for (std::size_t i = 0; i < sides; ++i) {
    SideLoop loop{{low[i], false}, {upright[(i + 1) % sides], false}, {high[i], true}, {upright[i], true}};
    face({shape.inside_out ? reversed(loop) : loop}, shape.profile[i].pieces.empty());
    result.low_loop.push_back({low[sides - 1 - i], true});
    result.high_loop.push_back({high[i], false});
  }
  if (shape.inside_out) {
    result.low_loop = reversed(result.low_loop);
    result.high_loop = reversed(result.high_loop);
  }
  return result;
}

void SolidBuilder::link(Index from, Index to) {
  solid_.links.push_back({from, to, group_of_line(position(from), position(to))});
}

PerspectiveSolid SolidBuilder::take(int shells, int genus) {
  solid_.shells = shells;
  solid_.genus = genus;
  return std::move(solid_);
}

}  // namespace croquis::test
