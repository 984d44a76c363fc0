// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <Eigen/LU>
#include <catch2/catch.hpp>

#include "implicit/cube_loops.h"
#include "support/random.h"

namespace croquis::implicit {
namespace {

using Values = std::array<double, 8>;

Values with_signs(unsigned pattern, test::Random& random) {
  Values values;
  for (unsigned c = 0; c < 8; ++c) {
    // Sizes over several powers of ten, and now and then the same size twice.
    const double size = random.below(10) == 0 ? 1 : std::pow(10, random.between(-3, 3));
    values[c] = (pattern >> c & 1U) != 0 ? -size : size;
  }
  return values;
}

/// The neighbour across a face of the axis: shares the face's values, the others are its own.
Values neighbour(const Values& values, unsigned face, test::Random& random) {
  Values other = with_signs(static_cast<unsigned>(random.bits()) & 255U, random);
  const unsigned axis = face / 2;
  for (unsigned c = 0; c < 8; ++c)
    if ((c >> axis & 1U) == (face & 1U)) other[c ^ 1U << axis] = values[c];
  return other;
}

/// The same edge as the neighbour across a face numbers it.
unsigned edge_across(unsigned edge, unsigned face) {
  const auto [axis, corner] = cube_edge(edge);
  const unsigned moved = corner ^ 1U << (face / 2);
  for (unsigned e = 0; e < 12; ++e)
    if (cube_edge(e).axis == axis && cube_edge(e).corner == moved) return e;
  return 99;
}

std::array<Vec3, 12> points_on_edges(const Values& values) {
  std::array<Vec3, 12> points;
  for (unsigned e = 0; e < 12; ++e) {
    const auto [axis, corner] = cube_edge(e);
    points[e] = Vec3(corner & 1U, corner >> 1 & 1U, corner >> 2);
    const double a = values[corner];
    const double b = values[corner | 1U << axis];
    points[e][axis] += (a < 0) != (b < 0) ? std::clamp(a / (a - b), 1e-4, 1 - 1e-4) : 0.5;
  }
  return points;
}

TEST_CASE("the two cubes at a face find the same segments there, turned round: 256 patterns, 1000 values each") {
  test::Random random(71);
  std::size_t ambiguous = 0;
  for (unsigned pattern = 0; pattern < 256; ++pattern) {
    bool all = true;
    for (int run = 0; run < 1000; ++run) {
      const Values values = with_signs(pattern, random);
      const unsigned face = random.below(6);
      const FaceSegments mine = face_segments(values, face);
      const FaceSegments theirs = face_segments(neighbour(values, face, random), face ^ 1U);
      all = all && mine.count == theirs.count;
      for (std::size_t i = 0; i < mine.count; ++i) {
        const FaceSegment turned = {edge_across(mine.segments[i].to, face), edge_across(mine.segments[i].from, face)};
        const auto end = theirs.segments.begin() + static_cast<std::ptrdiff_t>(theirs.count);
        all = all && std::find(theirs.segments.begin(), end, turned) != end;
      }
      if (mine.count == 2) ++ambiguous;
    }
    INFO("pattern " << pattern);
    CHECK(all);
  }
  CHECK(ambiguous > 10000);
}

TEST_CASE("loops close, go through every crossed edge once, and follow the faces' segments") {
  test::Random random(72);
  for (unsigned pattern = 0; pattern < 256; ++pattern) {
    for (int run = 0; run < 200; ++run) {
      const Values values = with_signs(pattern, random);
      const CubeLoops loops = cube_loops(values);
      std::set<std::pair<unsigned, unsigned>> steps, segments;
      std::size_t edges = 0;
      for (std::size_t i = 0; i < loops.count; ++i) {
        const auto loop = loops.loop(i);
        REQUIRE(loop.size() >= 3);
        edges += loop.size();
        for (std::size_t k = 0; k < loop.size(); ++k) steps.insert({loop[k], loop[(k + 1) % loop.size()]});
      }
      for (unsigned face = 0; face < 6; ++face) {
        const FaceSegments found = face_segments(values, face);
        for (std::size_t i = 0; i < found.count; ++i) segments.insert({found.segments[i].from, found.segments[i].to});
      }
      std::size_t crossed = 0;
      for (unsigned e = 0; e < 12; ++e) {
        const auto [axis, corner] = cube_edge(e);
        if ((values[corner] < 0) != (values[corner | 1U << axis] < 0)) ++crossed;
      }
      REQUIRE(edges == crossed);
      REQUIRE(steps == segments);
    }
  }
}

TEST_CASE("triangles of a loop cover it, and no inner edge lies in a face") {
  test::Random random(73);
  std::map<std::size_t, int> lengths;
  int without = 0;
  for (unsigned pattern = 1; pattern < 255; ++pattern) {
    for (int run = 0; run < 100; ++run) {
      const Values values = with_signs(pattern, random);
      const auto points = points_on_edges(values);
      const CubeLoops loops = cube_loops(values);
      for (std::size_t i = 0; i < loops.count; ++i) {
        const auto loop = loops.loop(i);
        ++lengths[loop.size()];
        std::vector<Vec3> places;
        for (const std::uint8_t e : loop) places.push_back(points[e]);
        const LoopTriangles found = triangulate_loop(loop, places);
        if (found.count == 0) {
          ++without;
          continue;
        }
        REQUIRE(found.count == loop.size() - 2);
        std::map<std::pair<int, int>, int> sides;  // directed
        for (std::size_t t = 0; t < found.count; ++t)
          for (std::size_t k = 0; k < 3; ++k) ++sides[{found.triangles[t][k], found.triangles[t][(k + 1) % 3]}];
        for (const auto& [side, count] : sides) {
          REQUIRE(count == 1);
          const auto n = static_cast<int>(loop.size());
          const bool rim = side.second == (side.first + 1) % n;
          REQUIRE(sides.count({side.second, side.first}) == (rim ? 0 : 1));
          if (!rim) {
            const auto a = loop[static_cast<std::size_t>(side.first)];
            const auto b = loop[static_cast<std::size_t>(side.second)];
            REQUIRE((faces_of_edge(a) & faces_of_edge(b)) == 0);
          }
        }
      }
    }
  }
  CHECK(lengths.size() >= 7);
  CHECK(without > 100);  // such loops do occur, and random values at every corner of a lattice meet them
}

TEST_CASE("one positive corner is cut off by a triangle that faces it") {
  for (unsigned corner = 0; corner < 8; ++corner) {
    Values values;
    values.fill(-1);
    values[corner] = 1;
    const CubeLoops loops = cube_loops(values);
    REQUIRE(loops.count == 1);
    const auto points = points_on_edges(values);
    const auto loop = loops.loop(0);
    REQUIRE(loop.size() == 3);
    const Vec3 a = points[loop[0]], b = points[loop[1]], c = points[loop[2]];
    const Vec3 at(corner & 1U, corner >> 1 & 1U, corner >> 2);
    Eigen::Matrix3d m;
    m << b - a, c - a, at - a;
    CHECK(m.determinant() > 0);
  }
}

TEST_CASE("the asymptotic decider joins the stronger pair of corners") {
  // On the face x = 0 the positive corners 0 and 6 are joined exactly when they outweigh the negative ones.
  for (const double strength : {0.5, 2.0}) {
    Values values = {strength, 1, -1, 1, -1, 1, strength, 1};
    const FaceSegments found = face_segments(values, 0);
    REQUIRE(found.count == 2);
    for (const FaceSegment& segment : found.segments) {
      std::set<unsigned> corners;  // the corner that the segment cuts off is on both of its edges
      for (const unsigned e : {segment.from, segment.to}) {
        const auto [axis, corner] = cube_edge(e);
        for (const unsigned c : {corner, corner | 1U << axis})
          if (!corners.insert(c).second) CHECK((values[c] > 0) == (strength < 1));
      }
      CHECK(corners.size() == 3);
    }
  }
}

}  // namespace
}  // namespace croquis::implicit
