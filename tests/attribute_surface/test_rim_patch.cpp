// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "algorithms/attribute_surface/bridges/rim_face.h"
#include "croquis/attribute_surface/rim_patch.h"
#include "croquis/geometry/mesh_report.h"
#include "croquis/geometry/mesh_topology.h"
#include "support/meshes/cages.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"

namespace croquis::test {
namespace {

/// A closed shape with a distance to it that is known: of a point near it, to first order.
struct TrueShape {
  std::string name;
  PolyMesh mesh;
  std::function<double(const Vec3&)> error;
};

/// r = 1 + bumps, a shape without symmetry.
double bumpy_radius(const Vec3& u) {
  return 1 + 0.15 * std::sin(2 * u.x() + 1) * std::cos(3 * u.y()) + 0.1 * u.z() * u.x();
}

TrueShape sphere(Index segments) {
  PolyMesh mesh = triangulated(rotated(uv_sphere(segments, segments / 2), 0.7, Vec3(1, 2, 0.5).normalized()));
  return {"sphere", std::move(mesh), [](const Vec3& p) { return std::abs(p.norm() - 1); }};
}

TrueShape bumpy(Index segments) {
  PolyMesh mesh = sphere(segments).mesh;
  for (Vec3& p : mesh.positions) p *= bumpy_radius(p.normalized());
  return {"bumpy", std::move(mesh), [](const Vec3& p) { return std::abs(p.norm() - bumpy_radius(p.normalized())); }};
}

TrueShape ring(Index segments) {
  return {"torus", triangulated(torus(2 * segments, segments)),
          [](const Vec3& p) { return std::abs(std::hypot(std::hypot(p.x(), p.y()) - 1, p.z()) - 0.4); }};
}

/// Without the faces that have a vertex in the ball.
PolyMesh without_ball(const PolyMesh& mesh, const Vec3& centre, double radius) {
  std::vector<Index> gone;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto is_inside = [&](Index v) { return (mesh.positions[v] - centre).norm() < radius; };
    if (std::ranges::any_of(mesh.face(f), is_inside)) gone.push_back(f);
  }
  return without_faces(mesh, gone);
}

std::vector<std::vector<Index>> rims_of(const PolyMesh& mesh) {
  const MeshTopology topology(mesh);
  std::vector<std::vector<Index>> rims;
  for (std::size_t r = 0; r < topology.boundary_loops().size(); ++r) {
    const auto loop = topology.boundary_loops()[r];
    rims.emplace_back(loop.begin(), loop.end());
  }
  return rims;
}

RimPatches patched(const PolyMesh& mesh, const RimPatchOptions& options = {}) {
  Progress progress;
  return patch_rims(mesh, rims_of(mesh), options, progress);
}

MeshReport figures_of(const PolyMesh& mesh) {
  Progress progress;
  return inspect(mesh, true, progress);
}

void check_kept(const PolyMesh& before, const PolyMesh& after) {
  CHECK(std::equal(before.positions.begin(), before.positions.end(), after.positions.begin()));
  CHECK(std::equal(before.face_offsets.begin(), before.face_offsets.end(), after.face_offsets.begin()));
  CHECK(std::equal(before.corners.begin(), before.corners.end(), after.corners.begin()));
}

void check_closed(const PolyMesh& mesh) {
  const MeshReport report = figures_of(mesh);
  CHECK(report.closed);
  CHECK(report.oriented);
  CHECK(report.nonmanifold_edges == 0);
  CHECK(report.nonmanifold_vertices == 0);
  CHECK(report.degenerate_faces == 0);
  CHECK(report.self_intersections == 0);
}

std::vector<TrueShape> shapes() { return {sphere(80), bumpy(96), ring(40)}; }

/// The same rim closed by a fan around its middle: what has no slopes.
double flat_error(const TrueShape& shape, const PolyMesh& holed) {
  double sum = 0, count = 0;
  for (const std::vector<Index>& rim : rims_of(holed)) {
    Vec3 middle = Vec3::Zero();
    for (const Index v : rim) middle += holed.positions[v];
    middle /= static_cast<double>(rim.size());
    for (const Index v : rim) {
      for (const double t : {0.0, 0.25, 0.5, 0.75}) {
        const double error = shape.error(middle + t * (holed.positions[v] - middle));
        sum += (1 - t) * error * error;  // by area
        count += 1 - t;
      }
    }
  }
  return std::sqrt(sum / count);
}

/// Of the new vertices: between them triangles are flat in any case.
double patch_error(const TrueShape& shape, const PolyMesh& holed, const PolyMesh& closed) {
  double sum = 0;
  for (std::size_t v = holed.vertex_count(); v < closed.vertex_count(); ++v)
    sum += std::pow(shape.error(closed.positions[v]), 2);
  return std::sqrt(sum / static_cast<double>(closed.vertex_count() - holed.vertex_count()));
}

TEST_CASE("patches close holes: closed, oriented, manifold, and nothing else is touched") {
  for (const TrueShape& shape : shapes()) {
    const Vec3 centre = shape.mesh.positions[shape.mesh.vertex_count() / 3];
    for (const double radius : {0.12, 0.25, 0.35}) {
      for (const bool smooth : {true, false}) {
        INFO(shape.name << ", radius " << radius << ", smooth " << smooth);
        const PolyMesh holed = without_ball(shape.mesh, centre, radius);
        RimPatchOptions options;
        options.smooth = smooth;
        const RimPatches result = patched(holed, options);
        for (const RimOutcome& outcome : result.outcomes) CHECK(outcome.reason.empty());
        check_kept(holed, result.mesh);
        check_closed(result.mesh);
        CHECK(figures_of(result.mesh).genus == (shape.name == "torus" ? 1 : 0));
      }
    }
  }
}

TEST_CASE("patches come much nearer to the shape that was there than flat ones") {
  const std::vector<double> most{0.1, 0.1, 0.3};  // of the flat patch's error
  for (std::size_t s = 0; s < shapes().size(); ++s) {
    const TrueShape shape = shapes()[s];
    for (const double radius : {0.15, 0.2}) {
      const Vec3 centre = shape.mesh.positions[shape.mesh.vertex_count() / 3];
      const PolyMesh holed = without_ball(shape.mesh, centre, radius);
      const double smooth = patch_error(shape, holed, patched(holed).mesh);
      const double flat = flat_error(shape, holed);
      INFO(shape.name << ", radius " << radius << ": " << smooth << " against " << flat << ", " << smooth / flat);
      CHECK(smooth < most[s] * flat);
    }
  }
}

/// The greatest angle between faces at edges of the rim.
double rim_angle(const PolyMesh& holed, const PolyMesh& closed) {
  const MeshTopology topology(closed);
  const auto area = [&](Index f) {
    const auto face = closed.face(f);
    const Vec3& a = closed.positions[face[0]];
    return Vec3((closed.positions[face[1]] - a).cross(closed.positions[face[2]] - a));
  };
  double greatest = 0;
  for (Index edge = 0; edge < topology.edge_count(); ++edge) {
    const auto corners = topology.edge_corners(edge);
    if (corners.size() != 2) continue;
    const Index a = topology.face(corners[0]), b = topology.face(corners[1]);
    if ((a < holed.face_count()) != (b < holed.face_count()))
      greatest = std::max(greatest, angle_between(area(a), area(b)));
  }
  return greatest;
}

PolyMesh capped_sphere(Index segments) {
  const PolyMesh mesh = triangulated(uv_sphere(segments, segments / 2));
  return without_ball(mesh, Vec3(0, 0, 1), 0.6);
}

TEST_CASE("along round rims patches go on smoothly, and with finer meshes more so") {
  double before = 1;
  for (const Index segments : {32U, 64U, 128U}) {
    const PolyMesh holed = capped_sphere(segments);
    RimPatchOptions crease;
    crease.smooth = false;
    const double smooth = rim_angle(holed, patched(holed).mesh),
                 creased = rim_angle(holed, patched(holed, crease).mesh);
    INFO(segments << " segments: " << smooth << ", as a crease " << creased);
    CHECK(creased > 0.4);
    CHECK(smooth < 0.7 * before);
    before = smooth;
  }
}

TEST_CASE("a cap cut off a sphere comes back") {
  const TrueShape whole = sphere(8);
  for (const Index segments : {32U, 64U, 128U}) {
    const PolyMesh holed = capped_sphere(segments);
    const PolyMesh closed = patched(holed).mesh;
    const double ratio = patch_error(whole, holed, closed) / flat_error(whole, holed);
    INFO(segments << " segments: " << ratio);
    CHECK(ratio < 0.16);
    check_closed(closed);
  }
}

TEST_CASE("plane holes stay plane, with sides at their corners") {
  const PolyMesh plate = grid(12, 9);
  std::vector<Index> gone;
  for (Index row = 3; row < 6; ++row) {
    for (Index column = 4; column < 8; ++column) gone.push_back(row * 12 + column);
  }
  const PolyMesh holed = without_faces(plate, gone);
  std::vector<std::vector<Index>> rims = rims_of(holed);
  std::erase_if(rims, [](const auto& rim) { return rim.size() != 14; });
  REQUIRE(rims.size() == 1);
  Progress progress;
  const RimPatches result = patch_rims(holed, rims, {}, progress);
  REQUIRE(result.outcomes[0].closed);
  CHECK(result.outcomes[0].sides == 4);
  for (const Vec3& p : result.mesh.positions) CHECK(std::abs(p.z()) < 1e-12);
  const MeshReport report = figures_of(result.mesh);
  CHECK(report.area == Approx(12 * 9));
  CHECK(report.self_intersections == 0);
}

TEST_CASE("every polygon becomes a patch of as many sides, whatever its size") {
  for (Index sides = 3; sides <= 12; ++sides) {
    const PolyMesh holed = without_faces(pyramid(sides), std::vector<Index>{0});
    const auto rims = rims_of(holed);
    REQUIRE(rims.size() == 1);
    RimPatchOptions options;
    options.smooth = false;
    options.density = 0.5;
    Progress progress;
    const RimPatches result = patch_rims(holed, rims, options, progress);
    INFO(sides << " sides: " << result.outcomes[0].reason);
    CHECK(result.outcomes[0].closed);
    check_closed(result.mesh);
  }
}

TEST_CASE("rims cut into sides at corners, else evenly") {
  for (const std::size_t n : {3U, 5U, 8U, 20U, 100U}) {
    std::vector<Vec3> circle;
    for (std::size_t i = 0; i < n; ++i) {
      const double t = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
      circle.push_back({std::cos(t), std::sin(t), 0});
    }
    for (const std::size_t sides : {0U, 3U, 7U, 12U}) {
      const RimCuts cuts = cut_rim(circle, 40 * std::numbers::pi / 180, sides);
      CHECK(cuts.at.size() == std::min<std::size_t>(sides == 0 ? 4 : sides, n));
      CHECK(std::ranges::is_sorted(cuts.at));
      CHECK(std::ranges::adjacent_find(cuts.at) == cuts.at.end());
      CHECK(std::ranges::count(cuts.is_corner, true) == 0);
    }
  }
}

TEST_CASE("attributes go on: faces as those beside, vertices as those of the rim") {
  PolyMesh holed = capped_sphere(24);
  std::vector<std::int32_t> groups(holed.face_count(), 3);
  holed.channels.push_back({"group", Domain::Face, 1, groups, {"a", "b", "c", "d"}});
  holed.channels.push_back({"color", Domain::Vertex, 3, std::vector<float>(3 * holed.vertex_count(), 0.5F), {}});
  const PolyMesh closed = patched(holed).mesh;
  CHECK(validate(closed).empty());
  const auto& made = std::get<std::vector<std::int32_t>>(closed.channel("group", Domain::Face)->data);
  CHECK(std::ranges::count(made, 3) == static_cast<std::ptrdiff_t>(closed.face_count()));
  const auto& colors = std::get<std::vector<float>>(closed.channel("color", Domain::Vertex)->data);
  CHECK(std::ranges::count(colors, 0.5F) == static_cast<std::ptrdiff_t>(3 * closed.vertex_count()));
}

TEST_CASE("rims that can't be closed stay open with a reason, the others are closed") {
  PolyMesh two = merged(capped_sphere(24), translated(capped_sphere(24), {5, 0, 0}));
  const auto rims = rims_of(two);
  REQUIRE(rims.size() == 2);
  Progress progress;
  const std::vector<std::vector<Index>> wrong{{rims[0].rbegin(), rims[0].rend()}, rims[1], {0, 1}};
  const RimPatches result = patch_rims(two, wrong, {}, progress);
  CHECK(!result.outcomes[0].closed);
  CHECK(result.outcomes[0].reason == "the faces along its rim don't agree in direction");
  CHECK(result.outcomes[1].closed);
  CHECK(!result.outcomes[2].closed);
  CHECK(figures_of(result.mesh).boundary_loops == 1);
}

TEST_CASE("a patch that would run through the mesh is left out") {
  // A plate that stands upright in the opening, where the cap will be.
  const PolyMesh upright = rotated(scaled(grid(4, 4), 0.1), std::numbers::pi / 2, Vec3::UnitX());
  const PolyMesh blocked = merged(capped_sphere(32), translated(upright, {-0.2, 0.01, 0.8}));
  std::vector<std::vector<Index>> rims = rims_of(blocked);
  REQUIRE(rims.size() == 2);
  rims.pop_back();  // the plate's own outline
  Progress progress;
  const RimPatches result = patch_rims(blocked, rims, {}, progress);
  CHECK(!result.outcomes[0].closed);
  CHECK(result.outcomes[0].reason.find("cut through") != std::string::npos);
  CHECK(result.mesh.face_count() == blocked.face_count());
  CHECK(result.mesh.positions == blocked.positions);
}

}  // namespace
}  // namespace croquis::test
