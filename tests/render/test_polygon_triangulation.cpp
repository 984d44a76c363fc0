// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "render/items/polygon_triangulation.h"

using namespace croquis;
using namespace croquis::render;

namespace {

using Polygon = std::vector<glm::dvec3>;

/// Signed area of the triangles along the polygon's area vector, and the sum of their sizes.
struct Cover {
  double signed_area = 0;
  double total_area = 0;
};

Cover cover(const Polygon& polygon) {
  const glm::dvec3 normal = glm::normalize(area_vector(polygon));
  Cover result;
  for (const auto& [a, b, c] : triangulate_polygon(polygon)) {
    const double area = 0.5 * glm::dot(normal, glm::cross(polygon[b] - polygon[a], polygon[c] - polygon[a]));
    result.signed_area += area;
    result.total_area += std::abs(area);
  }
  return result;
}

/// A star with 2 n corners, every other one at the inner radius, tilted in space.
Polygon star(int n, double inner) {
  Polygon polygon;
  for (int i = 0; i < 2 * n; ++i) {
    const double angle = M_PI * i / n;
    const double radius = i % 2 == 0 ? 1 : inner;
    const double x = radius * std::cos(angle);
    const double y = radius * std::sin(angle);
    polygon.push_back({x, 0.6 * y, 0.8 * y + 0.3 * x});
  }
  return polygon;
}

Polygon comb(int teeth) {
  Polygon polygon = {{0, -1, 0}, {2.0 * teeth, -1, 0}};
  for (int i = teeth; i > 0; --i) {
    polygon.push_back({2.0 * i, 5, 0});
    polygon.push_back({2.0 * i - 1, 0, 0});
  }
  polygon.push_back({0, 5, 0});
  return polygon;
}

}  // namespace

TEST_CASE("every simple polygon is covered exactly once, in its own sense") {
  const Polygon polygon = GENERATE(star(3, 0.2), star(5, 0.4), star(40, 0.05), comb(1), comb(20),
                                   Polygon{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}},
                                   Polygon{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}},
                                   // A square with a square hole, joined by a bridge that is walked twice.
                                   Polygon{{0, 0, 0},
                                           {4, 0, 0},
                                           {4, 4, 0},
                                           {0, 4, 0},
                                           {0, 0, 0},
                                           {1, 1, 0},
                                           {1, 3, 0},
                                           {3, 3, 0},
                                           {3, 1, 0},
                                           {1, 1, 0}});
  const bool reversed = GENERATE(false, true);
  Polygon walked = polygon;
  if (reversed) std::reverse(walked.begin(), walked.end());
  const double area = glm::length(area_vector(walked));
  const Cover covered = cover(walked);
  CHECK(triangulate_polygon(walked).size() == walked.size() - 2);
  CHECK(covered.signed_area == Approx(area));
  CHECK(covered.total_area == Approx(area));
}

TEST_CASE("polygons that cross themselves or have no area still give their number of triangles") {
  const Polygon polygon = GENERATE(Polygon{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}, Polygon(7, glm::dvec3(1, 2, 3)),
                                   Polygon{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1.5, 0, 0}});
  CHECK(triangulate_polygon(polygon).size() == polygon.size() - 2);
}
