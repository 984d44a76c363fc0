// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "algorithms/hole_filling/fairing/even_fairing.h"
#include "algorithms/hole_filling/fairing/patch_relaxation.h"
#include "support/random.h"
#include "support/scans/scans.h"

using namespace croquis;
using namespace croquis::hole_filling;
using namespace croquis::test;

namespace {

struct Case {
  FairingInput input;
  FairingResult patch;

  Vec3& point(Index v) { return v < input.points.size() ? input.points[v] : patch.new_points[v - input.points.size()]; }
};

/// A sheet of squares whose middle is the patch; its inner vertices are thrown about.
template <typename Height>
Case middle_of_sheet(Index size, const Height& height) {
  const PolyMesh mesh = sheet(size, size);
  const auto is_inside = [&](const Vec3& p) {
    return std::max(std::abs(p.x() - size / 2.0), std::abs(p.y() - size / 2.0)) < 2;
  };
  Case result;
  Random random(1);
  std::vector<Index> number(mesh.vertex_count());
  for (const bool inside : {false, true}) {
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      Vec3 p = mesh.positions[v];
      if (is_inside(p) != inside) continue;
      number[v] = static_cast<Index>(result.input.points.size() + result.patch.new_points.size());
      p.z() = height(p);
      if (inside)
        result.patch.new_points.push_back(p + Vec3(0.3 * random.unit(), 0.3 * random.unit(), random.unit()));
      else
        result.input.points.push_back(p);
    }
  }
  for (Index f = 0; f < mesh.face_count(); ++f) {
    Triangle t = {mesh.face(f)[0], mesh.face(f)[1], mesh.face(f)[2]};
    const Vec3 middle = (mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) / 3;
    for (Index& v : t) v = number[v];
    (is_inside(middle) ? result.patch.patch : result.input.surroundings).push_back(t);
  }
  return result;
}

/// Squared ways from vertices of the patch to the means of their neighbours, summed.
double bending(Case& at) {
  std::vector<std::set<Index>> neighbours(at.input.points.size() + at.patch.new_points.size());
  std::set<Index> counted;
  for (const auto* triangles : {&at.input.surroundings, &at.patch.patch}) {
    for (const Triangle& t : *triangles) {
      for (const Index v : t) neighbours[v].insert(t.begin(), t.end());
      if (triangles == &at.patch.patch) counted.insert(t.begin(), t.end());
    }
  }
  double sum = 0;
  for (const Index v : counted) {
    Vec3 mean = Vec3::Zero();
    for (const Index other : neighbours[v]) mean += other == v ? Vec3(0, 0, 0) : at.point(other);
    sum += (mean / static_cast<double>(neighbours[v].size() - 1) - at.point(v)).squaredNorm();
  }
  return sum;
}

}  // namespace

TEST_CASE("evenly faired vertices bend least: moving any of them bends more, and what is known stays") {
  Case wavy = middle_of_sheet(10, [](const Vec3& p) { return std::sin(p.x()) + 0.1 * p.y() * p.y(); });
  const std::vector<Vec3> known = wavy.input.points;
  const double thrown = bending(wavy);
  REQUIRE(fair_evenly(wavy.input, wavy.patch));
  CHECK(wavy.input.points == known);
  const double least = bending(wavy);
  CHECK(least < thrown / 2);
  for (Vec3& p : wavy.patch.new_points) {
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      for (const double step : {-1e-3, 1e-3}) {
        const double before = p[axis];
        p[axis] += step;
        CHECK(bending(wavy) > least);
        p[axis] = before;
      }
    }
  }
}

TEST_CASE("a patch in a flat sheet is faired flat, with its vertices where a sheet has them") {
  Case flat = middle_of_sheet(12, [](const Vec3& p) { return 0.5 * p.x() - 0.25 * p.y() + 3; });
  REQUIRE(fair_evenly(flat.input, flat.patch));
  for (const Vec3& p : flat.patch.new_points) {
    CHECK(p.z() == Approx(0.5 * p.x() - 0.25 * p.y() + 3).margin(1e-9));
    CHECK(std::abs(p.x() - std::round(p.x())) < 1e-6);
    CHECK(std::abs(p.y() - std::round(p.y())) < 1e-6);
  }
}

TEST_CASE("fairing without new vertices changes nothing") {
  Case none = middle_of_sheet(8, [](const Vec3&) { return 0.0; });
  none.patch.new_points.clear();
  none.patch.patch.clear();
  CHECK(fair_evenly(none.input, none.patch));
  CHECK(none.patch.new_points.empty());
}

TEST_CASE("vertices move to the mean of their triangles' centroids, weighted by area, fixed ones stay") {
  LoosePatch patch;
  patch.points = {{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {0, 2, 0}, {1, 1.5, 1}};
  patch.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  patch.sizes.assign(5, 0.7);
  Vec3 sum = Vec3::Zero();
  double areas = 0;
  for (const auto& [a, b, c] : patch.triangles) {
    const Vec3 &p = patch.points[a], &q = patch.points[b], &r = patch.points[c];
    const double area = (q - p).cross(r - p).norm() / 2;
    sum += area * (p + q + r) / 3;
    areas += area;
  }
  const std::vector<Vec3> before = patch.points;
  const std::vector<std::uint8_t> fixed = {1, 1, 1, 1, 0};
  relax(patch, fixed);
  CHECK(std::equal(before.begin(), before.begin() + 4, patch.points.begin()));
  CHECK((patch.points[4] - sum / areas).norm() < 1e-14);
  for (int round = 0; round < 200; ++round) relax(patch, fixed);
  CHECK((patch.points[4] - Vec3(2, 1, 0)).norm() < 1e-6);

  LoosePatch line = {{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}, {1, 1, 1}, {{0, 1, 2}}, 0};
  relax(line, std::vector<std::uint8_t>{0, 0, 0});
  CHECK(line.points[1] == Vec3(1, 0, 0));  // no area says where to
}

TEST_CASE("vertices come to rest nearer to where shorter edges are wanted") {
  LoosePatch patch = {{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {2, 2, 0}},
                      {1, 3, 3, 1, 2},
                      {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}},
                      4};
  const std::vector<std::uint8_t> fixed = {1, 1, 1, 1, 0};
  for (int round = 0; round < 200; ++round) relax(patch, fixed);
  CHECK(patch.points[4].x() < 1.8);
  CHECK(patch.points[4].x() > 1);
  CHECK((patch.points[4] - Vec3(patch.points[4].x(), 2, 0)).norm() < 1e-9);
}
