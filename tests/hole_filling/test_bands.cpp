// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "algorithms/hole_filling/triangulation/triangulations.h"
#include "hole_filling/fill_invariants.h"
#include "support/random.h"
#include "support/scans/scans.h"

using namespace croquis;
using namespace croquis::test;
using namespace croquis::hole_filling;

namespace {

/// Loops that run so that a band between them lies on their left: the first around z, the second the other way.
RimPolygon two_circles(Index first, Index second, double distance, double noise) {
  RimPolygon rims;
  Random random(first);
  for (Index i = 0; i < first; ++i) {
    const double angle = 2 * std::numbers::pi * i / first;
    rims.points.emplace_back(std::cos(angle), std::sin(angle), noise * random.unit());
  }
  rims.loop_ends.push_back(first);
  for (Index i = 0; i < second; ++i) {
    const double angle = 0.3 - 2 * std::numbers::pi * i / second;
    rims.points.emplace_back(std::cos(angle), std::sin(angle), distance + noise * random.unit());
  }
  rims.loop_ends.push_back(first + second);
  return rims;
}

/// How often each edge comes, as it runs.
std::size_t count_of(const std::vector<std::array<Index, 3>>& triangles, Index a, Index b) {
  std::size_t count = 0;
  for (const auto& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) count += t[i] == a && t[(i + 1) % 3] == b ? 1U : 0U;
  }
  return count;
}

/// Every rim edge once as it runs, every other edge once each way.
void check_band(const RimPolygon& rims, const std::vector<std::array<Index, 3>>& triangles) {
  CHECK(triangles.size() + (rims.loop_count() == 1 ? 2 : 0) == rims.points.size());
  for (Index p = 0; p < rims.points.size(); ++p) CHECK(count_of(triangles, p, rims.next(p)) == 1);
  for (const auto& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Index a = t[i], b = t[(i + 1) % 3];
      CHECK(count_of(triangles, a, b) == 1);
      if (rims.next(a) != b) CHECK(count_of(triangles, b, a) == 1);
    }
  }
}

double area_of(const RimPolygon& rims, const std::vector<std::array<Index, 3>>& triangles) {
  double area = 0;
  for (const auto& [a, b, c] : triangles)
    area += 0.5 * (rims.points[b] - rims.points[a]).cross(rims.points[c] - rims.points[a]).norm();
  return area;
}

/// A flat sheet with a slit two squares wide at most and many long.
PolyMesh slit_sheet() {
  PolyMesh mesh = sheet(40, 12);
  PolyMesh open;
  open.positions = mesh.positions;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto c = mesh.face(f);
    const Vec3 middle = (mesh.positions[c[0]] + mesh.positions[c[1]] + mesh.positions[c[2]]) / 3;
    if (middle.y() > 6 && middle.y() < 7 && middle.x() > 5 && middle.x() < 35) continue;
    open.add_triangle(c[0], c[1], c[2]);
  }
  for (Vec3& p : open.positions) p.z() = 0.02 * (p.x() - 20) * (p.x() - 20);  // bent along its length
  return open;
}

/// Two tubes in one line with a gap, each with `rings` rings.
PolyMesh tubes_apart(double gap, Index segments) {
  PolyMesh mesh = open_tube(1, 3, segments, 10);
  const auto given = static_cast<Index>(mesh.vertex_count());
  const PolyMesh other = open_tube(1, 3, segments + 5, 10);
  for (const Vec3& p : other.positions) mesh.positions.push_back(p + Vec3(0, 0, 3 + gap));
  for (std::size_t f = 0; f < other.face_count(); ++f) {
    const auto c = other.face(f);
    mesh.add_triangle(c[0] + given, c[1] + given, c[2] + given);
  }
  return mesh;
}

FillOptions bridging(std::vector<Index> holes, Fairness fairness) {
  FillOptions options;
  options.selection = Selection::None;
  options.fairness = fairness;
  HoleRequest request;
  request.holes = std::move(holes);
  request.bridge = true;
  options.requests = {request};
  return options;
}

/// The two rims nearest to each other, in the middle of the tubes.
std::vector<Index> facing_rims(const PolyMesh& mesh) {
  Progress progress;
  const HoleAnalysis analysis = analyse_holes(mesh, progress);
  std::vector<Index> best;
  double least = 1e300;
  for (const Hole& a : analysis.holes) {
    for (const Hole& b : analysis.holes) {
      const double distance = (a.centre - b.centre).norm();
      if (a.id >= b.id || distance >= least) continue;
      least = distance;
      best = {a.id, b.id};
    }
  }
  return best;
}

}  // namespace

TEST_CASE("a band between two rims uses every rim edge once and runs one way") {
  Progress progress;
  for (const auto& [first, second] : std::vector<std::pair<Index, Index>>{{12, 12}, {7, 31}, {40, 5}, {3, 3}}) {
    for (const BandCost cost : {BandCost::Area, BandCost::Length}) {
      const RimPolygon rims = two_circles(first, second, 0.8, 0.05);
      const auto triangles = band_triangulation(rims, cost, progress);
      REQUIRE(triangles);
      check_band(rims, *triangles);
    }
  }
}

TEST_CASE("a band between circles has the area of the tube between them, and one of least area no more") {
  Progress progress;
  const RimPolygon rims = two_circles(60, 47, 1.5, 0.05);
  const auto by_area = band_triangulation(rims, BandCost::Area, progress);
  const auto by_length = band_triangulation(rims, BandCost::Length, progress);
  REQUIRE((by_area && by_length));
  CHECK(area_of(rims, *by_area) <= area_of(rims, *by_length));
  CHECK(std::abs(area_of(rims, *by_area) - 2 * std::numbers::pi * 1.5) < 0.2);
}

TEST_CASE("rims of thousands of edges are joined by going on with the shorter edge") {
  Progress progress;
  const RimPolygon rims = two_circles(3000, 2500, 0.1, 0);
  const auto triangles = band_triangulation(rims, BandCost::Length, progress);
  REQUIRE(triangles);
  CHECK(triangles->size() == 5500);
  CHECK(std::abs(area_of(rims, *triangles) - 2 * std::numbers::pi * 0.1) < 0.05);
}

TEST_CASE("blocked edges are avoided by bands") {
  Progress progress;
  RimPolygon rims = two_circles(12, 12, 0.8, 0.05);
  const auto before = band_triangulation(rims, BandCost::Length, progress);
  REQUIRE(before);
  std::array<Index, 2> between{0, 0};
  for (const auto& t : *before) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (t[i] < 12 && t[(i + 1) % 3] >= 12) between = {t[i], t[(i + 1) % 3]};
    }
  }
  rims.blocked = {between};
  const auto after = band_triangulation(rims, BandCost::Length, progress);
  REQUIRE(after);
  CHECK(count_of(*after, between[0], between[1]) == 0);
  check_band(rims, *after);
}

TEST_CASE("a slit is closed by triangles as short as its edges") {
  const PolyMesh mesh = slit_sheet();
  FillOptions options;
  const FillResult result = fill(mesh, options);
  const auto slit = std::find_if(result.analysis.holes.begin(), result.analysis.holes.end(),
                                 [](const Hole& hole) { return hole.kind == HoleClass::Slit; });
  REQUIRE(slit != result.analysis.holes.end());
  const HoleOutcome& outcome = result.outcomes[slit->id];
  CHECK(outcome.action == FillAction::Fill);
  CHECK(outcome.reason.empty());
  CHECK(outcome.min_angle > 0.3);  // 45 degrees for halved squares, 27 where a corner is cut
  for (std::size_t f = mesh.face_count(); f < result.mesh.face_count(); ++f) {
    const auto c = result.mesh.face(f);
    for (std::size_t i = 0; i < 3; ++i)
      CHECK((result.mesh.positions[c[i]] - result.mesh.positions[c[(i + 1) % 3]]).norm() < 2.5);
  }
}

TEST_CASE("the gap of a tube is closed by a round band of new vertices, whatever its width") {
  for (const double gap : {0.7, 1.0, 2.0}) {
    const PolyMesh mesh = tubes_apart(gap, 28);
    const FillResult result = fill(mesh, bridging(facing_rims(mesh), Fairness::Implicit));
    const MeshReport report = report_of(result.mesh);
    INFO(gap << " " << result.outcomes[facing_rims(mesh)[0]].method << " "
             << result.outcomes[facing_rims(mesh)[0]].reason);
    CHECK(result.new_vertices > 10);
    CHECK(report.components == 1);
    CHECK(*report.self_intersections == 0);
    CHECK(report.boundary_loops == 2);
    for (std::size_t v = mesh.vertex_count(); v < result.mesh.vertex_count(); ++v) {
      const Vec3& p = result.mesh.positions[v];
      CHECK(std::abs(std::hypot(p.x(), p.y()) - 1) < 0.03);
    }
  }
}

TEST_CASE("a tunnel through a box joins two of its sides, by every fairness") {
  PolyMesh mesh = cut(divided_box(12), Vec3(0.5, 0.5, 1), 0.26).mesh;
  mesh = cut(mesh, Vec3(0.5, 0.5, 0), 0.26).mesh;
  for (const Fairness fairness : {Fairness::Implicit, Fairness::Tangent, Fairness::Flat}) {
    const FillResult result = fill(mesh, bridging({0, 1}, fairness));
    const MeshReport report = report_of(result.mesh);
    INFO(static_cast<int>(fairness) << " " << result.outcomes[0].method << ": " << result.outcomes[0].reason);
    CHECK(result.outcomes[0].action == FillAction::Fill);
    CHECK(report.boundary_loops == 0);
    CHECK(report.euler_characteristic == 0);  // a torus
    CHECK(*report.self_intersections == 0);
    CHECK((fairness == Fairness::Flat) == (result.new_vertices == 0));
  }
}
