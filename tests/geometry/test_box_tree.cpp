// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <set>
#include <vector>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "geometry/box_tree.h"
#include "geometry/ranked_places.h"
#include "support/random.h"

using namespace croquis;
using namespace croquis::test;

namespace {

using Pairs = std::set<std::array<Index, 2>>;

/// Boxes between two places each, with their ranks and as they are.
struct Boxes {
  std::vector<PackedBox> packed;
  std::vector<Eigen::AlignedBox3d> exact;

  void add(const std::vector<Vec3>& ends) {
    const std::vector<PackedPlace> places = ranked_places(ends);
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
      packed.push_back(extended({places[i], places[i]}, places[i + 1]));
      exact.emplace_back(ends[i].cwiseMin(ends[i + 1]), ends[i].cwiseMax(ends[i + 1]));
    }
  }
};

/// Whole coordinates, so that many boxes touch; negative ones and both zeros, too.
std::vector<Vec3> random_ends(std::uint64_t seed, std::size_t boxes, std::uint32_t range, std::uint32_t size) {
  Random random(seed);
  const auto place = [&](std::uint32_t below) {
    const double x = random.below(below);
    const double y = random.below(below);
    return Vec3(x, y, random.below(below));
  };
  std::vector<Vec3> ends;
  for (std::size_t i = 0; i < boxes; ++i) {
    const Vec3 low = place(range) - Vec3::Constant(range / 2);
    ends.push_back(low);
    ends.push_back(i % 3 == 0 ? Vec3(-low) : Vec3(low + place(size)));
  }
  return ends;
}

Pairs pairs_of(const BoxTree& tree) {
  Pairs pairs;
  for (std::size_t leaf = 0; leaf < tree.leaf_count(); ++leaf) {
    tree.visit_pairs_of_leaf(leaf, [&](Index i, Index j) {
      const bool is_new = pairs.insert({std::min(i, j), std::max(i, j)}).second;
      CHECK(is_new);
    });
  }
  return pairs;
}

}  // namespace

TEST_CASE("a tree finds each pair of boxes that overlap or touch once, and no other") {
  for (const std::size_t count : {0U, 1U, 2U, 8U, 9U, 64U, 65U, 700U}) {
    for (const double scale : {1.0, 1e-300, 1e300}) {
      std::vector<Vec3> ends = random_ends(count, count, 40, 6);
      for (Vec3& end : ends) end *= scale;
      if (count > 2) ends[1] = Vec3(1e307, 1e307, 1e307);  // a stray one must not make all others look alike
      Boxes boxes;
      boxes.add(ends);
      Pairs expected;
      for (Index i = 0; i < count; ++i) {
        for (Index j = i + 1; j < count; ++j) {
          if (boxes.exact[i].intersects(boxes.exact[j])) expected.insert({i, j});
        }
      }
      INFO(count << " boxes, scale " << scale);
      CHECK(pairs_of(BoxTree(boxes.packed)) == expected);
    }
  }
}

TEST_CASE("two trees find each pair of boxes that overlap once") {
  Boxes boxes;
  boxes.add(random_ends(3, 600, 60, 5));
  for (const std::size_t cut : {std::size_t{0}, std::size_t{1}, std::size_t{250}, boxes.packed.size()}) {
    const BoxTree first(std::span(boxes.packed).first(cut));
    const BoxTree second(std::span(boxes.packed).subspan(cut));
    Pairs expected, found;
    for (Index i = 0; i < cut; ++i) {
      for (auto j = static_cast<Index>(cut); j < boxes.packed.size(); ++j) {
        if (boxes.exact[i].intersects(boxes.exact[j])) expected.insert({i, j});
      }
    }
    for (std::size_t leaf = 0; leaf < first.leaf_count(); ++leaf) {
      first.visit_pairs_between(leaf, second, [&](Index i, Index j) {
        const bool is_new = found.insert({i, static_cast<Index>(j + cut)}).second;
        CHECK(is_new);
      });
    }
    CHECK(found == expected);
  }
}

TEST_CASE("with more different coordinates than ranks no overlap is lost") {
  constexpr std::size_t count = (std::size_t{1} << packed_bits) + 1000;
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < count; ++i) points.push_back(Vec3::Constant(std::sqrt(static_cast<double>(i))));
  const std::vector<PackedPlace> places = ranked_places(points);
  std::size_t equal = 0;
  bool is_sorted = true;
  for (std::size_t i = 1; i < count; ++i) {
    is_sorted = is_sorted && at_or_above(places[i], places[i - 1]) == packed_guards;
    if (places[i] == places[i - 1]) ++equal;
  }
  CHECK(is_sorted);
  CHECK(equal == count / 2);
}

TEST_CASE("boxes of triangles overlap as places wherever they do as points, at any scale and with a vertex far out") {
  for (const double scale : {1e-290, 1e-9, 1.0, 1e9, 1e290}) {
    for (const double outlier : {0.0, 1e3, 1e9}) {
      Random random(7);
      std::vector<Vec3> points;
      for (std::size_t i = 0; i < 240; ++i) {
        const Vec3 low(random.below(40), random.below(40), random.below(40));
        points.push_back(scale * (i % 3 == 0 ? low : Vec3(points[i - i % 3] / scale + 0.3 * low)));
      }
      points.push_back(outlier * scale * Vec3(1, -1, 0.5));
      points.push_back(Vec3::Constant(1e308));  // of no triangle
      std::vector<MeetingTriangle> triangles;
      for (Index v = 0; v < 240; v += 3) triangles.push_back({{v, v + 1, v + 2}, 0});
      triangles.push_back({{0, 1, 240}, 0});
      const std::vector<PackedPlace> places = places_for_boxes(points, triangles);
      std::size_t lost = 0, overlapping = 0, found = 0;
      for (std::size_t i = 0; i < triangles.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          const auto packed_box = [&](std::size_t t) {
            const auto [a, b, c] = triangles[t].vertices;
            return extended(extended({places[a], places[a]}, places[b]), places[c]);
          };
          const auto exact_box = [&](std::size_t t) {
            Eigen::AlignedBox3d box;
            for (const Index v : triangles[t].vertices) box.extend(points[v]);
            return box;
          };
          const bool do_overlap = exact_box(i).intersects(exact_box(j));
          const bool is_found = overlap(packed_box(i), packed_box(j));
          overlapping += do_overlap ? 1U : 0U;
          found += is_found ? 1U : 0U;
          lost += do_overlap && !is_found ? 1U : 0U;
        }
      }
      INFO(scale << " " << outlier);
      CHECK(lost == 0);
      CHECK(overlapping > 10);
      CHECK(found <= overlapping + overlapping / 20);
    }
  }
}
