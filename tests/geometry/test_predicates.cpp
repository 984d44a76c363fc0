// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>

#include <catch2/catch.hpp>

#include "croquis/geometry/predicates.h"
#include "support/random.h"

using namespace croquis;

namespace {

/// Points of a lattice fine enough for rounding to spoil the plain determinant, coarse enough for 128-bit integers.
struct LatticePoint {
  std::int64_t x = 0;
  std::int64_t y = 0;
  Vec2 place() const { return {static_cast<double>(x) * 0x1p-20, static_cast<double>(y) * 0x1p-20}; }
};

__extension__ using Wide = __int128;

int sign_of(Wide value) { return value > 0 ? 1 : (value < 0 ? -1 : 0); }

}  // namespace

TEST_CASE("orientation agrees with integer arithmetic where rounding would decide wrongly") {
  test::Random random(7);
  int collinear = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto coordinate = [&] { return static_cast<std::int64_t>(random.bits() >> 24) - (std::int64_t{1} << 39); };
    const LatticePoint a{coordinate(), coordinate()};
    const LatticePoint step{static_cast<std::int64_t>(random.below(9)) + 1, static_cast<std::int64_t>(random.below(9))};
    const std::int64_t far = coordinate() / 16;
    const LatticePoint b{a.x + far * step.x, a.y + far * step.y};
    const LatticePoint c{a.x + 3 * step.x, a.y + 3 * step.y + static_cast<std::int64_t>(random.below(3)) - 1};
    const Wide exact = static_cast<Wide>(b.x - a.x) * (c.y - a.y) - static_cast<Wide>(b.y - a.y) * (c.x - a.x);
    CHECK(orientation(a.place(), b.place(), c.place()) == sign_of(exact));
    collinear += exact == 0 ? 1 : 0;
  }
  CHECK(collinear > 1000);
}

TEST_CASE("a point on the circle is neither inside nor outside, its neighbours are") {
  // Points of x^2 + y^2 = 5^4 13^2 on the integer lattice, moved far away from the origin.
  const Vec2 origin(0x1p30, -0x1p29);
  const Vec2 a = origin + Vec2(325, 0);
  const Vec2 b = origin + Vec2(36, 323);
  const Vec2 c = origin + Vec2(-204, -253);
  const double tiny = 0x1p-20;
  for (const Vec2& on : {Vec2(91, 312), Vec2(-315, 80), Vec2(165, -280), Vec2(-195, 260)}) {
    const Vec2 inwards(on.x() > 0 ? -tiny : tiny, 0);
    CHECK(in_circle(a, b, c, origin + on) == 0);
    CHECK(in_circle(a, b, c, origin + on + inwards) == 1);
    CHECK(in_circle(a, b, c, origin + on - inwards) == -1);
  }
}
