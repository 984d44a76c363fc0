// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include "support/perspective/solid_builder.h"

namespace croquis::test {
namespace {

struct BottleSizes {
  Vec2 low, high;  ///< of a rectangle
  double z = 0;
};

/// Corners of a rectangle, counter-clockwise from above.
std::array<Index, 4> add_corners(SolidBuilder& builder, const BottleSizes& at) {
  return {builder.vertex(at.low.x(), at.low.y(), at.z), builder.vertex(at.high.x(), at.low.y(), at.z),
          builder.vertex(at.high.x(), at.high.y(), at.z), builder.vertex(at.low.x(), at.high.y(), at.z)};
}

/// Middles of the rectangle's sides, each after the corner of the same number.
std::array<Index, 4> add_middles(SolidBuilder& builder, const BottleSizes& at) {
  const Vec2 middle = (at.low + at.high) / 2;
  return {builder.vertex(middle.x(), at.low.y(), at.z), builder.vertex(at.high.x(), middle.y(), at.z),
          builder.vertex(middle.x(), at.high.y(), at.z), builder.vertex(at.low.x(), middle.y(), at.z)};
}

void add_lines(SolidBuilder& builder, const std::array<Index, 4>& from, const std::array<Index, 4>& to,
               std::size_t step = 0) {
  for (std::size_t i = 0; i < 4; ++i) builder.line(from[i], to[(i + step) % 4]);
}

}  // namespace

PerspectiveSolid bottle() {
  SolidBuilder b("bottle");
  const BottleSizes base{{0, 0}, {3, 2.2}, 0}, body{{0, 0}, {3, 2.2}, 2.4};
  const BottleSizes neck{{0.95, 0.65}, {2.05, 1.55}, 3.6}, mouth{{0.95, 0.65}, {2.05, 1.55}, 4.6};
  const auto foot = add_corners(b, base), top = add_corners(b, body), middle = add_middles(b, body);
  const auto neck_corner = add_corners(b, neck), neck_middle = add_middles(b, neck), rim = add_corners(b, mouth);
  add_lines(b, foot, foot, 1);
  add_lines(b, foot, top);
  add_lines(b, top, middle);
  add_lines(b, middle, top, 1);
  add_lines(b, neck_corner, neck_middle);
  add_lines(b, neck_middle, neck_corner, 1);
  add_lines(b, neck_corner, rim);
  add_lines(b, rim, rim, 1);
  const std::array<Vec3, 4> first{{{1.5, 0.05, 3.1}, {2.9, 1.1, 3.1}, {1.5, 2.15, 3.1}, {0.1, 1.1, 3.1}}};
  const std::array<Vec3, 4> second{{{1.5, 0.5, 3.2}, {2.2, 1.1, 3.2}, {1.5, 1.7, 3.2}, {0.8, 1.1, 3.2}}};
  for (std::size_t i = 0; i < 4; ++i) b.curve(middle[i], neck_middle[i], first[i], second[i]);
  b.face({foot[3], foot[2], foot[1], foot[0]});
  b.face({rim[0], rim[1], rim[2], rim[3]});
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    b.face({foot[i], foot[next], top[next], middle[i], top[i]});
    b.face({neck_corner[i], neck_middle[i], neck_corner[next], rim[next], rim[i]});
    b.face({middle[i], top[next], middle[next], neck_middle[next], neck_corner[next], neck_middle[i]}, false);
  }
  return b.take();
}

PerspectiveSolid ball() {
  SolidBuilder b("ball");
  const double radius = 1.5, handle = 4.0 / 3 * (std::sqrt(2.0) - 1);
  std::array<std::array<Index, 2>, 3> poles{};
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 pole = radius * Vec3::Unit(axis);
    poles[static_cast<std::size_t>(axis)] = {b.vertex(pole.x(), pole.y(), pole.z()),
                                             b.vertex(-pole.x(), -pole.y(), -pole.z())};
  }
  for (int axis = 0; axis < 3; ++axis) {
    const int other = (axis + 1) % 3;
    for (int i = 0; i < 4; ++i) {
      const Vec3 u = (i % 2 ? -radius : radius) * Vec3::Unit(axis);
      const Vec3 v = (i / 2 ? -radius : radius) * Vec3::Unit(other);
      b.curve(poles[static_cast<std::size_t>(axis)][static_cast<std::size_t>(i % 2)],
              poles[static_cast<std::size_t>(other)][static_cast<std::size_t>(i / 2)], u + handle * v, v + handle * u);
    }
  }
  for (std::size_t i = 0; i < 8; ++i) {
    const Index x = poles[0][i & 1], y = poles[1][(i >> 1) & 1], z = poles[2][i >> 2];
    const bool even = ((i & 1) + ((i >> 1) & 1) + (i >> 2)) % 2 == 0;
    even ? b.face({x, y, z}, false) : b.face({x, z, y}, false);
  }
  return b.take();
}

}  // namespace croquis::test
