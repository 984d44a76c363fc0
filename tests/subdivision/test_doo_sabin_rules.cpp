// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

#include "algorithms/subdivision/refinement/point_rules.h"
#include "subdivision/subdivided.h"
#include "support/meshes/cages.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"

/// What each rule of positions promises, one by one.
namespace croquis::test {
namespace {

using subdivision::BoundaryCorners;
using subdivision::ChainEnds;
using subdivision::FaceMask;
using subdivision::Preset;
using subdivision::Profile;
using subdivision::Rules;
using subdivision::Weights;

std::vector<Vec3> chain_points(const Subdivided& result, int k) {
  std::vector<Vec3> points;
  for (const Index v : tagged_vertices(result.plan.level(k))) points.push_back(result.points(k)[v]);
  return points;
}

std::vector<Vec3> open_chaikin(const std::vector<Vec3>& line) {
  std::vector<Vec3> finer;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    finer.push_back(0.75 * line[i] + 0.25 * line[i + 1]);
    finer.push_back(0.25 * line[i] + 0.75 * line[i + 1]);
  }
  return finer;
}

bool has_point(const std::vector<Vec3>& points, const Vec3& point) {
  return std::any_of(points.begin(), points.end(), [&](const Vec3& p) { return (p - point).norm() < 1e-12; });
}

TEST_CASE("weights of a face have the known values") {
  const auto check = [](Weights weights, std::size_t n, const std::vector<double>& expected) {
    const std::vector<double> row = FaceMask(weights).row(n);
    for (std::size_t j = 0; j < expected.size(); ++j) {
      CHECK(row[j] == Approx(expected[j]).margin(1e-6));
      if (j > 0) CHECK(row[n - j] == Approx(row[j]).epsilon(1e-14));
    }
  };
  check(Weights::Classical, 3, {0.666667, 0.166667});
  check(Weights::Classical, 4, {0.5625, 0.1875, 0.0625});
  check(Weights::Classical, 5, {0.5, 0.180902, 0.069098});
  check(Weights::Classical, 6, {0.458333, 0.166667, 0.083333, 0.041667});
  check(Weights::Average, 3, {0.583333, 0.208333});
  check(Weights::Average, 4, {0.5625, 0.1875, 0.0625});
  check(Weights::Average, 5, {0.55, 0.175, 0.05});
  check(Weights::Average, 6, {0.541667, 0.166667, 0.041667, 0.041667});
}

TEST_CASE("roots of unity are exact to the last places and exactly symmetric") {
  for (const std::size_t n : {3u, 4u, 5u, 7u, 8u, 12u, 31u, 360u, 10007u}) {
    for (std::size_t j = 0; j < n; j += 1 + n / 50) {
      const Vec2 root = subdivision::unit_root(j, n);
      const double angle = 2 * M_PI * static_cast<double>(j) / static_cast<double>(n);
      CHECK(root.x() == Approx(std::cos(angle)).margin(2e-15));
      CHECK(root.y() == Approx(std::sin(angle)).margin(2e-15));
      CHECK(subdivision::unit_root(n - j, n) == Vec2(root.x(), -root.y()));
    }
  }
  CHECK(subdivision::unit_root(1, 4) == Vec2(0, 1));
}

TEST_CASE("the points of whole faces are what their rows say, for faces of any size") {
  Random random(5);
  for (const Weights weights : {Weights::Classical, Weights::Average}) {
    const FaceMask mask(weights);
    for (const std::size_t n : {3u, 4u, 5u, 6u, 9u, 32u, 33u, 100u}) {
      std::vector<Vec3> points(n), result(n);
      std::vector<Index> corners(n);
      for (Index i = 0; i < n; ++i) {
        points[i] = Vec3(random.unit(), random.unit(), random.unit());
        corners[i] = i;
      }
      mask.apply(points.data(), corners, result.data());
      const std::vector<double> row = mask.row(n);
      double worst = 0;
      for (std::size_t i = 0; i < n; ++i) {
        Vec3 expected = Vec3::Zero();
        for (std::size_t j = 0; j < n; ++j) expected += row[j] * points[(i + j) % n];
        worst = std::max(worst, (result[i] - expected).norm());
      }
      CHECK(worst < 1e-14);
    }
  }
}

TEST_CASE("an open chain that retracts is Chaikin's open polyline and keeps its right angles") {
  const Subdivided result = subdivide(bolt_open_chain(), 5, Rules::of(Preset::Paper));
  const PolyMesh cage = bolt();
  std::vector<Vec3> line(cage.positions.begin() + 8, cage.positions.begin() + 12);
  for (int k = 1; k <= 5; ++k) {
    line = open_chaikin(line);
    CHECK(same_points(chain_points(result, k), line, 1e-12));
    for (const auto& tag : result.plan.level(k).sharp) {
      CHECK(std::abs(dihedral_degrees(result.topology(k), result.points(k), tag.edge) - 90) < 1e-9);
    }
  }
  CHECK(has_point(chain_points(result, 5), Vec3(-0.03125, -1, 0)));
  CHECK(has_point(chain_points(result, 5), Vec3(-0.03125, 1, 0)));
}

TEST_CASE("pinned chain ends stay, by switch or by pin") {
  Rules pin_all;
  pin_all.chain_ends = ChainEnds::Pin;
  PolyMesh pinned = bolt_open_chain();
  pinned.tags.pins = {8, 11};
  for (const Subdivided& result : {subdivide(bolt_open_chain(), 4, pin_all), subdivide(pinned, 4)}) {
    for (int k = 1; k <= 4; ++k) {
      CHECK(has_point(chain_points(result, k), Vec3(-1, -1, 0)));
      CHECK(has_point(chain_points(result, k), Vec3(-1, 1, 0)));
    }
  }
}

TEST_CASE("fans at corners of the surface stop growing") {
  PolyMesh mesh = bolt_loop();
  mesh.tags.pins = {8, 9, 10, 11};
  const Subdivided result = subdivide(mesh, 6);
  for (int k = 0; k <= 6; ++k) {
    std::size_t faces = 0;
    const Index kept = result.plan.level(k).pins.front();
    for (const Index v : result.topology(k).corner_vertex) faces += v == kept ? 1 : 0;
    const auto in_sector = static_cast<std::size_t>(std::clamp(k + 1, 2, 5));  // two sectors at each vertex
    CHECK(faces == 2 * in_sector);
  }
}

TEST_CASE("boundary corners stay or are rounded") {
  const auto corner_distance = [](BoundaryCorners corners) {
    Rules rules;
    rules.boundary_corners = corners;
    const Subdivided result = subdivide(grid(4, 3), 4, rules);
    CHECK(fault(result.topology(4)) == "");
    double nearest = 10;
    for (const Vec3& p : result.points(4)) nearest = std::min(nearest, p.norm());
    return nearest;
  };
  CHECK(corner_distance(BoundaryCorners::Corner) == 0);
  CHECK(corner_distance(BoundaryCorners::Smooth) > 0.1);
}

TEST_CASE("finite sharpness rounds off after so many levels") {
  PolyMesh mesh = cube_top_loop();
  for (Crease& crease : mesh.tags.creases) crease.sharpness = 2.5;
  const Subdivided result = subdivide(mesh, 6);
  CHECK(result.plan.level(2).sharp.size() == 16);
  for (const auto& tag : result.plan.level(2).sharp) CHECK(tag.sharpness == 0.5);
  CHECK(result.plan.level(3).sharp.empty());
  const auto angle = [&](int k) { return largest_untagged_dihedral(result.plan.level(k), result.points(k)); };
  CHECK(angle(3) == Approx(82).margin(0.5));
  CHECK(angle(4) == Approx(52).margin(0.5));
  CHECK(angle(5) / angle(4) == Approx(0.5).margin(0.1));
  CHECK(angle(6) / angle(5) == Approx(0.5).margin(0.1));
}

TEST_CASE("between whole numbers the shape follows the sharpness without a jump") {
  const auto level_one = [](double sharpness) {
    PolyMesh mesh = cube_top_loop();
    for (Crease& crease : mesh.tags.creases) crease.sharpness = sharpness;
    return subdivide(mesh, 1);
  };
  const Subdivided none = level_one(0), hardly = level_one(1e-9);
  const Subdivided almost = level_one(1 - 1e-9), half = level_one(0.5);
  REQUIRE(counts(none.topology(1)) == counts(almost.topology(1)));
  double small = 0, linear = 0;
  for (std::size_t v = 0; v < none.points(1).size(); ++v) {
    small = std::max(small, (none.points(1)[v] - hardly.points(1)[v]).norm());
    linear = std::max(linear, (0.5 * (none.points(1)[v] + almost.points(1)[v]) - half.points(1)[v]).norm());
  }
  CHECK(small < 1e-8);
  CHECK(linear < 1e-8);
  // Nearly sharp alone: the quad of the tagged edge has no width left.
  const Subdivided alone = subdivide(tagged(centred_cube(), std::array<VertexPair, 1>{{{4, 5}}}, 1 - 1e-9), 1);
  int quads = 0;
  for (Index face = 0; face < alone.topology(1).face_count(); ++face) {
    const auto origin = alone.plan.face_origin(1, face);
    if (origin.kind != subdivision::FaceKind::Edge || alone.cage.sharpness[origin.element] == 0) continue;
    const auto corners = alone.topology(1).face(face);
    CHECK((alone.points(1)[corners[1]] - alone.points(1)[corners[2]]).norm() < 1e-8);
    ++quads;
  }
  CHECK(quads == 1);
}

}  // namespace
}  // namespace croquis::test
