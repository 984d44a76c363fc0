// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <catch2/catch.hpp>

#include "croquis/geometry/affine3.h"
#include "croquis/geometry/edge_channels.h"
#include "croquis/geometry/mesh_report.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"

using namespace croquis;
using namespace croquis::test;

namespace {

Affine3 random_map(Random& random) {
  Affine3 map;
  for (double& number : map.linear.reshaped()) number = random.between(-2, 2);
  map.linear += 3 * Eigen::Matrix3d::Identity();
  for (double& number : map.offset) number = random.between(-5, 5);
  return map;
}

Affine3 mirror() {
  Affine3 map;
  map.linear(0, 0) = -1;
  return map;
}

MeshReport report_of(const PolyMesh& mesh) {
  Progress progress;
  return inspect(mesh, false, progress);
}

Vec3 area_vector(const PolyMesh& mesh, std::size_t face) {
  const auto v = mesh.face(face);
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < v.size(); ++i)
    sum += (mesh.positions[v[i]] - mesh.positions[v[0]]).cross(mesh.positions[v[i + 1]] - mesh.positions[v[0]]);
  return sum;
}

Drawing small_drawing() {
  Drawing drawing;
  Stroke stroke;
  stroke.id = "a";
  stroke.samples = {{Vec2(1, 2)}, {Vec2(-3, 0.5)}, {Vec2(4, 4)}};
  drawing.strokes = {stroke};
  drawing.plane = {Vec3(1, 2, 3), Vec3(0, 0.6, 0.8), Vec3(1, 0, 0)};
  return drawing;
}

std::vector<Vec3> places(const Drawing& drawing) {
  std::vector<Vec3> all;
  for (const StrokeSample& sample : drawing.strokes[0].samples)
    all.push_back(drawing.plane.origin + sample.position.x() * drawing.plane.u + sample.position.y() * drawing.plane.v);
  return all;
}

}  // namespace

TEST_CASE("maps of meshes change the volume by their determinant and keep closed solids oriented outwards") {
  Random random(3);
  for (int i = 0; i < 20; ++i) {
    const Affine3 map = i % 2 == 0 ? random_map(random) : composed(mirror(), random_map(random));
    REQUIRE(map.is_invertible());
    CHECK(map.mirrors() == (map.linear.determinant() < 0));
    const PolyMesh mesh = double_torus();
    const MeshReport report = report_of(transformed(mesh, map));
    CHECK(report.closed);
    CHECK(report.oriented);
    CHECK(report.genus == 2);
    CHECK(report.volume.value() == Approx(13 * std::abs(map.linear.determinant())));
  }
}

TEST_CASE("normals stay at right angles to their faces, and corner and edge values stay where they were") {
  Random random(4);
  PolyMesh mesh = double_torus();
  std::vector<double> normals;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const Vec3 normal = area_vector(mesh, f).normalized();
    normals.insert(normals.end(), normal.begin(), normal.end());
  }
  mesh.channels.push_back({"normal", Domain::Face, 3, normals, {}});
  std::vector<std::uint32_t> vertices(mesh.corners.begin(), mesh.corners.end());
  mesh.channels.push_back({"vertex", Domain::Corner, 1, vertices, {}});
  const MeshTopology topology(mesh);
  std::vector<std::uint32_t> sums;
  for (Index e = 0; e < topology.edge_count(); ++e)
    sums.push_back(topology.edge_vertices(e)[0] + 1000 * topology.edge_vertices(e)[1] + topology.edge_vertices(e)[1] +
                   1000 * topology.edge_vertices(e)[0]);
  mesh.channels.push_back({"ends", Domain::Edge, 1, sums, {}});
  // Numbers of that name that are no directions stay.
  const std::vector<double> pairs(2 * mesh.vertex_count(), 0.5);
  mesh.channels.push_back({"normal", Domain::Vertex, 2, pairs, {}});
  for (int i = 0; i < 10; ++i) {
    const Affine3 map = i % 2 == 0 ? random_map(random) : composed(random_map(random), mirror());
    const PolyMesh moved = transformed(mesh, map);
    CHECK(validate(moved).empty());
    CHECK(std::get<std::vector<double>>(moved.channel("normal", Domain::Vertex)->data) == pairs);
    const auto& turned = std::get<std::vector<double>>(moved.channel("normal", Domain::Face)->data);
    for (std::size_t f = 0; f < moved.face_count(); ++f) {
      const Vec3 normal(turned[3 * f], turned[3 * f + 1], turned[3 * f + 2]);
      CHECK((normal - area_vector(moved, f).normalized()).norm() < 1e-9);
    }
    const auto& at_corners = std::get<std::vector<std::uint32_t>>(moved.channel("vertex", Domain::Corner)->data);
    CHECK(at_corners == std::vector<std::uint32_t>(moved.corners.begin(), moved.corners.end()));
    const MeshTopology edges(moved);
    const auto& at_edges = std::get<std::vector<std::uint32_t>>(moved.channel("ends", Domain::Edge)->data);
    REQUIRE(at_edges.size() == edges.edge_count());
    for (Index e = 0; e < edges.edge_count(); ++e)
      CHECK(at_edges[e] == 1001 * (edges.edge_vertices(e)[0] + edges.edge_vertices(e)[1]));
  }
}

TEST_CASE("maps without an inverse are known, however small or unequal the scales are") {
  Affine3 map;
  CHECK(map.is_identity());
  CHECK(map.is_invertible());
  map.linear *= 1e-100;
  map.linear(1, 1) = 1e30;
  CHECK(map.is_invertible());
  map.linear.col(2).setZero();
  CHECK_FALSE(map.is_invertible());
  map = {};
  map.linear.col(0) = map.linear.col(1);
  CHECK_FALSE(map.is_invertible());
  map = {};
  map.offset.x() = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(map.is_invertible());
  map = {};
  map.linear(0, 1) = std::numeric_limits<double>::infinity();
  CHECK_FALSE(map.is_invertible());
}

TEST_CASE("a mapped drawing lies where the map takes its samples, on an orthonormal plane") {
  Random random(5);
  const Drawing drawing = small_drawing();
  for (int i = 0; i < 20; ++i) {
    const Affine3 map = i % 2 == 0 ? random_map(random) : composed(mirror(), random_map(random));
    const Drawing moved = transformed(drawing, map);
    CHECK(moved.plane.is_orthonormal());
    const std::vector<Vec3> before = places(drawing), after = places(moved);
    for (std::size_t k = 0; k < before.size(); ++k) CHECK((after[k] - map(before[k])).norm() < 1e-9);
  }
}

TEST_CASE("a rigid map leaves the strokes of a drawing as they were drawn") {
  const Drawing drawing = small_drawing();
  Affine3 map;
  map.linear = Eigen::AngleAxisd(0.7, Vec3(1, 2, -1).normalized()).toRotationMatrix();
  map.offset = Vec3(5, -1, 2);
  const Drawing moved = transformed(drawing, map);
  for (std::size_t i = 0; i < drawing.strokes[0].samples.size(); ++i)
    CHECK(moved.strokes[0].samples[i].position == drawing.strokes[0].samples[i].position);
  CHECK((moved.plane.u - map.linear * drawing.plane.u).norm() < 1e-12);
  CHECK((moved.plane.v - map.linear * drawing.plane.v).norm() < 1e-12);
}

TEST_CASE("the frame of a plane is rigid and takes its axes to space") {
  const DrawingPlane plane = small_drawing().plane;
  const Affine3 frame = frame_of(plane);
  CHECK((frame.linear.transpose() * frame.linear).isIdentity(1e-12));
  CHECK_FALSE(frame.mirrors());
  CHECK(frame(Vec3::Zero()) == plane.origin);
  CHECK(frame(Vec3(1, 0, 0)) == Vec3(plane.origin + plane.u));
  CHECK(frame(Vec3(0, 1, 0)) == Vec3(plane.origin + plane.v));
  CHECK(frame_of(DrawingPlane()).is_identity());
}
