// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/geometry/triangle_tree.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"

using namespace croquis;
using namespace croquis::test;

TEST_CASE("the nearest triangle of a tree is that of a search of all, whichever count") {
  const PolyMesh soup = random_soup(3, 300);
  std::vector<std::array<Vec3, 3>> triangles;
  for (std::size_t f = 0; f < soup.face_count(); ++f)
    triangles.push_back(
        {soup.positions[soup.face(f)[0]], soup.positions[soup.face(f)[1]], soup.positions[soup.face(f)[2]]});
  const TriangleTree tree(triangles);
  Random random(5);
  for (int i = 0; i < 200; ++i) {
    const Vec3 place(random.between(-1, 2), random.between(-1, 2), random.between(-1, 2));
    for (const Index modulus : {1U, 7U}) {
      double least = std::numeric_limits<double>::infinity();
      for (Index t = 0; t < triangles.size(); t += modulus)
        least = std::min(least, foot_on_triangle(triangles[t], place).distance);
      const TriangleFoot foot = tree.nearest(place, 10, [&](Index t) { return t % modulus == 0; });
      CHECK(foot.distance == least);
      CHECK((foot.point - place).norm() == Approx(least));
    }
  }
}

TEST_CASE("the foot on a triangle is on it, and as near as any of its places") {
  const std::vector<std::array<Vec3, 3>> triangles = {{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.2, 1, 0.3)},
                                                      {Vec3(0, 0, 0), Vec3(1, 1, 1), Vec3(2, 2, 2)},
                                                      {Vec3(1, 2, 3), Vec3(1, 2, 3), Vec3(1, 2, 3)}};
  Random random(9);
  constexpr int steps = 60;
  for (const auto& [a, b, c] : triangles) {
    const auto at = [&, &a = a, &b = b, &c = c](int i, int j) {
      return Vec3(a + (b - a) * (static_cast<double>(i) / steps) + (c - a) * (static_cast<double>(j) / steps));
    };
    for (int run = 0; run < 30; ++run) {
      const Vec3 place(random.between(-1, 2), random.between(-1, 2), random.between(-1, 2));
      const TriangleFoot foot = foot_on_triangle({a, b, c}, place);
      double nearest = std::numeric_limits<double>::infinity(), nearest_to_foot = nearest;
      for (int i = 0; i <= steps; ++i) {
        for (int j = 0; i + j <= steps; ++j) {
          nearest = std::min(nearest, (at(i, j) - place).norm());
          nearest_to_foot = std::min(nearest_to_foot, (at(i, j) - foot.point).norm());
        }
      }
      const double spacing = std::max((b - a).norm(), (c - a).norm()) / steps;
      CHECK(foot.distance <= nearest * (1 + 1e-12));
      CHECK(nearest_to_foot <= 2 * spacing + 1e-12);
      CHECK((foot.point - place).norm() == Approx(foot.distance));
    }
  }
}
