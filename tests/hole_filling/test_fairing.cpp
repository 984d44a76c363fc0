// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <span>
#include <vector>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "algorithms/hole_filling/fairing/fairing.h"
#include "support/random.h"
#include "support/scans/scans.h"

using namespace croquis;
using namespace croquis::hole_filling;
using namespace croquis::test;

namespace {

/// A sheet of squares whose middle is the patch; its inner vertices are thrown about.
template <typename Height>
LoosePatch middle_of_sheet(Index size, const Height& height) {
  const PolyMesh mesh = sheet(size, size);
  const auto is_inside = [&](const Vec3& p) {
    return std::max(std::abs(p.x() - size / 2.0), std::abs(p.y() - size / 2.0)) < 2;
  };
  LoosePatch result;
  Random random(1);
  std::vector<Index> number(mesh.vertex_count());
  for (const bool inside : {false, true}) {
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      Vec3 p = mesh.positions[v];
      if (is_inside(p) != inside) continue;
      number[v] = static_cast<Index>(result.points.size());
      p.z() = height(p);
      result.points.push_back(inside ? p + Vec3(0.3 * random.unit(), 0.3 * random.unit(), random.unit()) : p);
      result.known += inside ? 0U : 1U;
    }
  }
  for (Index f = 0; f < mesh.face_count(); ++f) {
    Triangle t = {mesh.face(f)[0], mesh.face(f)[1], mesh.face(f)[2]};
    const Vec3 middle = (mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) / 3;
    for (Index& v : t) v = number[v];
    (is_inside(middle) ? result.triangles : result.surroundings).push_back(t);
  }
  return result;
}

/// Squared ways from vertices of the patch to the means of their neighbours, summed.
double bending(const LoosePatch& at) {
  std::vector<std::set<Index>> neighbours(at.points.size());
  std::set<Index> counted;
  for (const auto* triangles : {&at.surroundings, &at.triangles}) {
    for (const Triangle& t : *triangles) {
      for (const Index v : t) neighbours[v].insert(t.begin(), t.end());
      if (triangles == &at.triangles) counted.insert(t.begin(), t.end());
    }
  }
  double sum = 0;
  for (const Index v : counted) {
    Vec3 mean = Vec3::Zero();
    for (const Index other : neighbours[v]) mean += other == v ? Vec3(0, 0, 0) : at.points[other];
    sum += (mean / static_cast<double>(neighbours[v].size() - 1) - at.points[v]).squaredNorm();
  }
  return sum;
}

/// A regular polygon in the plane z = 0 as a fan, and nothing around it.
LoosePatch disc(Index corners, double radius) {
  LoosePatch input;
  input.known = corners;
  for (Index i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    input.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
  }
  for (Index i = 1; i + 1 < corners; ++i) input.triangles.push_back({0, i, i + 1});
  return input;
}

struct DiscMeasures {
  double area = 0, mean_edge = 0;
  std::size_t boundary_edges = 0, nonmanifold_edges = 0;
};

DiscMeasures measure(const LoosePatch& refined) {
  const std::vector<Vec3>& points = refined.points;
  DiscMeasures measures;
  std::map<std::pair<Index, Index>, int> edges;
  for (const Triangle& t : refined.triangles) {
    measures.area += triangle_area(points[t[0]], points[t[1]], points[t[2]]);
    for (std::size_t i = 0; i < 3; ++i) ++edges[std::minmax(t[i], t[(i + 1) % 3])];
  }
  for (const auto& [edge, count] : edges) {
    measures.mean_edge += (points[edge.first] - points[edge.second]).norm() / static_cast<double>(edges.size());
    measures.boundary_edges += count == 1;
    measures.nonmanifold_edges += count > 2;
  }
  return measures;
}

}  // namespace

TEST_CASE("evenly faired vertices bend least: moving any of them bends more, and what is known stays") {
  LoosePatch wavy = middle_of_sheet(10, [](const Vec3& p) { return std::sin(p.x()) + 0.1 * p.y() * p.y(); });
  const LoosePatch given = wavy;
  const double thrown = bending(wavy);
  REQUIRE(fair_evenly(wavy));
  CHECK(std::ranges::equal(std::span(wavy.points).first(wavy.known), std::span(given.points).first(given.known)));
  const double least = bending(wavy);
  CHECK(least < thrown / 2);
  for (Vec3& p : std::span(wavy.points).subspan(wavy.known)) {
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
  LoosePatch flat = middle_of_sheet(12, [](const Vec3& p) { return 0.5 * p.x() - 0.25 * p.y() + 3; });
  REQUIRE(fair_evenly(flat));
  for (const Vec3& p : std::span(flat.points).subspan(flat.known)) {
    CHECK(p.z() == Approx(0.5 * p.x() - 0.25 * p.y() + 3).margin(1e-9));
    CHECK(std::abs(p.x() - std::round(p.x())) < 1e-6);
    CHECK(std::abs(p.y() - std::round(p.y())) < 1e-6);
  }
}

TEST_CASE("fairing without new vertices changes nothing") {
  LoosePatch none = middle_of_sheet(8, [](const Vec3&) { return 0.0; });
  none.points.resize(none.known);
  none.triangles.clear();
  CHECK(fair_evenly(none));
  CHECK(none.points.size() == none.known);
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

TEST_CASE("refining keeps a patch's rim and its area, and gives the edges asked for") {
  for (const double coarseness : {1.0, 2.0}) {
    for (const Index corners : {12u, 60u, 240u}) {
      LoosePatch patch = disc(corners, 1);
      const double edge = (patch.points[0] - patch.points[1]).norm();
      REQUIRE(refine_evenly(patch, coarseness));
      const DiscMeasures measures = measure(patch);
      CHECK(measures.area == Approx(0.5 * corners * std::sin(2 * std::numbers::pi / corners)));
      CHECK(measures.boundary_edges == corners);
      CHECK(measures.nonmanifold_edges == 0);
      if (corners > 12) CHECK(measures.mean_edge / edge == Approx(coarseness).epsilon(0.3));
    }
  }
}

TEST_CASE("refining refuses triangles that are no surface") {
  LoosePatch input = disc(12, 1);
  input.triangles.push_back(input.triangles.front());
  CHECK_FALSE(refine_evenly(input, 1));
}

TEST_CASE("harmonic values are the mean of their neighbours', and exact where the rim has one value") {
  LoosePatch input = disc(100, 3);
  REQUIRE(refine_evenly(input, 1));
  const auto given = static_cast<Index>(input.known);
  const HolePatch patch{{0}, {input.points.begin() + given, input.points.end()}, input.triangles};
  const HarmonicValues harmonic(patch, given);
  REQUIRE(harmonic.rim_vertices().size() == given);

  CHECK((harmonic.continued(Eigen::VectorXd::Constant(given, 0.1)).array() == 0.1).all());

  Eigen::MatrixXd known(given, 2);
  std::vector<double> all;
  for (const Index v : harmonic.rim_vertices()) {
    all.push_back(std::sin(5 * input.points[v].x()) + input.points[v].y());
    known.row(std::ssize(all) - 1) << all.back(), 1 - all.back();
  }
  const Eigen::MatrixXd found = harmonic.continued(known);
  REQUIRE(found.rows() == std::ssize(patch.points));
  all.insert(all.end(), found.col(0).begin(), found.col(0).end());
  std::vector<double> sums(all.size(), 0), counts(all.size(), 0);
  for (const auto& t : patch.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      sums[t[i]] += all[t[(i + 1) % 3]] + all[t[(i + 2) % 3]];
      counts[t[i]] += 2;
    }
  }
  for (std::size_t v = given; v < all.size(); ++v) CHECK(all[v] == Approx(sums[v] / counts[v]).margin(1e-7));
  CHECK((found.col(0) + found.col(1) - Eigen::VectorXd::Ones(found.rows())).norm() < 1e-6);
}
