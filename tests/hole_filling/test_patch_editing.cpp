// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "algorithms/hole_filling/fairing/patch_editing.h"

using namespace croquis;
using namespace croquis::hole_filling;

namespace {

/// A disc of radius 1 with `count` rim points, as a fan around one more point.
LoosePatch fan(Index count, double size) {
  LoosePatch patch;
  patch.rim_points = count;
  for (Index i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    patch.points.emplace_back(std::cos(angle), std::sin(angle), 0);
    patch.triangles.push_back({i, (i + 1) % count, count});
  }
  patch.points.emplace_back(0.3, 0.1, 0);
  patch.sizes.assign(patch.points.size(), size);
  return patch;
}

double area(const LoosePatch& patch) {
  double sum = 0;
  for (const auto& [a, b, c] : patch.triangles)
    sum += 0.5 * (patch.points[b] - patch.points[a]).cross(patch.points[c] - patch.points[a]).z();
  return sum;
}

/// Directed edges, each at most once, and how many have no partner.
std::size_t open_edges(const LoosePatch& patch) {
  std::map<std::array<Index, 2>, int> edges;
  for (const auto& t : patch.triangles) {
    for (std::size_t i = 0; i < 3; ++i) CHECK(++edges[{t[i], t[(i + 1) % 3]}] == 1);
  }
  return static_cast<std::size_t>(std::count_if(edges.begin(), edges.end(), [&](const auto& e) {
    return !edges.count({e.first[1], e.first[0]});
  }));
}

}  // namespace

TEST_CASE("a patch brought to size keeps its rim and area, and gets edges of that size") {
  for (const Index count : {12u, 40u, 90u}) {
    const double size = 2 * std::sin(std::numbers::pi / count);
    LoosePatch patch = fan(count, size);
    const LoosePatch before = patch;
    for (int round = 0; round < 8; ++round) REQUIRE(bring_to_size(patch));
    CHECK(patch.rim_points == count);
    CHECK(std::equal(before.points.begin(), before.points.begin() + count, patch.points.begin()));
    CHECK(patch.sizes.size() == patch.points.size());
    CHECK(area(patch) == Approx(area(before)).epsilon(1e-12));
    CHECK(open_edges(patch) == count);
    double sum = 0, longest = 0;
    for (const auto& t : patch.triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        const double length = (patch.points[t[i]] - patch.points[t[(i + 1) % 3]]).norm();
        sum += length;
        longest = std::max(longest, length);
      }
    }
    CHECK(sum / static_cast<double>(3 * patch.triangles.size()) == Approx(size).epsilon(0.3));
    CHECK(longest < 2 * size);
  }
}

TEST_CASE("a patch that is no surface is refused and stays as it is") {
  LoosePatch patch = fan(6, 0.1);
  patch.triangles.push_back(patch.triangles.front());
  const LoosePatch before = patch;
  CHECK_FALSE(bring_to_size(patch));
  CHECK(patch.triangles == before.triangles);
  CHECK(patch.points == before.points);
}
