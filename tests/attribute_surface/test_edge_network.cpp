// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numbers>
#include <set>
#include <vector>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "algorithms/attribute_surface/bridges/rim_normal.h"
#include "croquis/attribute_surface/edge_network.h"
#include "croquis/base/error.h"
#include "croquis/geometry/bounds.h"
#include "croquis/geometry/mesh_topology.h"
#include "support/meshes/cages.h"
#include "support/meshes/mesh_shapes.h"

namespace croquis::test {
namespace {

std::vector<EdgeEnds> rim_of(const PolyMesh& mesh) {
  const MeshTopology topology(mesh);
  std::vector<EdgeEnds> edges;
  for (Index edge = 0; edge < topology.edge_count(); ++edge) {
    if (topology.edge_corners(edge).size() == 1) edges.push_back(topology.edge_vertices(edge));
  }
  return edges;
}

AttributeNetwork made(const PolyMesh& mesh, const std::vector<EdgeEnds>& edges,
                      const EdgeNetworkOptions& options = {}) {
  Progress progress;
  return network_of_edges(mesh, edges, options, progress);
}

/// The faces for which all vertices are below a height.
PolyMesh cut_above(const PolyMesh& mesh, double height) {
  std::vector<Index> gone;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    if (std::ranges::any_of(mesh.face(f), [&](Index v) { return mesh.positions[v].z() > height; })) gone.push_back(f);
  }
  return without_faces(mesh, gone);
}

double distance_to(const AttributeNetwork& network, const Vec3& point) {
  double least = 1e300;
  for (const AttributeCurve& curve : network.curves) {
    for (int i = 0; i <= 400; ++i)
      least = std::min(least, (bezier_point(control_polygon(network, curve), i / 400.0) - point).norm());
  }
  return least;
}

double diagonal_of(const PolyMesh& mesh) {
  const auto box = *bounds_of(mesh);
  return (box[1] - box[0]).norm();
}

TEST_CASE("the edges of a polyhedron become straight curves between nodes at its vertices") {
  for (const PolyMesh& mesh : {cube(), icosahedron(), house(), l_bracket(), double_torus()}) {
    const std::vector<VertexPair> edges = all_edges(mesh);
    const AttributeNetwork network = made(mesh, edges);
    CHECK(network.curves.size() == edges.size());
    CHECK(network.nodes.size() == mesh.vertex_count());
    for (const AttributeCurve& curve : network.curves) CHECK(curve.control.empty());
    for (const AttributeNode& node : network.nodes) CHECK(node.point == mesh.positions[std::stoul(node.id.substr(1))]);
    CHECK(validate(network).empty());
  }
}

void check_vertices_are_near(const PolyMesh& mesh, const std::vector<EdgeEnds>& rim, const AttributeNetwork& network) {
  std::set<Index> vertices;
  for (const EdgeEnds& edge : rim) vertices.insert(edge.begin(), edge.end());
  for (const Index vertex : vertices) CHECK(distance_to(network, mesh.positions[vertex]) < 0.0021 * diagonal_of(mesh));
  for (const AttributeNode& node : network.nodes) CHECK(node.point == mesh.positions[std::stoul(node.id.substr(1))]);
}

TEST_CASE("a round rim becomes four smooth curves near all its vertices") {
  for (const Index segments : {8U, 24U, 97U}) {
    const PolyMesh mesh = cut_above(uv_sphere(segments, 20), 0.55);
    const std::vector<EdgeEnds> rim = rim_of(mesh);
    EdgeNetworkOptions options;
    options.corner = std::numbers::pi;
    const AttributeNetwork network = made(mesh, rim, options);
    INFO(segments << " segments");
    REQUIRE(network.curves.size() == 4);
    check_vertices_are_near(mesh, rim, network);
    for (std::size_t k = 0; k < 4; ++k) {
      const auto a = control_polygon(network, network.curves[k]);
      const auto b = control_polygon(network, network.curves[(k + 1) % 4]);
      CHECK(angle_between(a.back() - a[a.size() - 2], b[1] - b[0]) < 1e-6);
    }
  }
}

TEST_CASE("curves come near all vertices of jagged rims too") {
  for (const Index segments : {8U, 24U, 97U}) {
    const PolyMesh mesh = cut_above(rotated(torus(segments, 24), 1, {1, 1, 0}), 0.3);
    const std::vector<EdgeEnds> rim = rim_of(mesh);
    check_vertices_are_near(mesh, rim, made(mesh, rim));
  }
}

TEST_CASE("rows of edges end at corners and where others meet") {
  const PolyMesh plate = grid(6, 4);
  const AttributeNetwork outline = made(plate, rim_of(plate));
  CHECK(outline.curves.size() == 4);

  std::vector<EdgeEnds> with_bar = rim_of(plate);
  for (Index row = 0; row < 4; ++row) with_bar.push_back({row * 7 + 3, row * 7 + 10});  // across the plate's middle
  const AttributeNetwork barred = made(plate, with_bar);
  CHECK(barred.curves.size() == 7);
  CHECK(barred.nodes.size() == 6);
}

TEST_CASE("curves don't depend on the order or direction of edges") {
  const PolyMesh mesh = cut_above(uv_sphere(30, 16), 0.5);
  std::vector<EdgeEnds> rim = rim_of(mesh);
  const AttributeNetwork before = made(mesh, rim);
  std::ranges::reverse(rim);
  for (EdgeEnds& edge : rim) std::swap(edge[0], edge[1]);
  rim.push_back(rim.front());
  const AttributeNetwork after = made(mesh, rim);
  REQUIRE(before.curves.size() == after.curves.size());
  for (std::size_t c = 0; c < before.curves.size(); ++c) CHECK(before.curves[c].control == after.curves[c].control);
}

/// The greatest angle between normals at a sphere's rim and the sphere's own, by the rule and by the faces' mean.
std::array<double, 2> normal_errors(const PolyMesh& mesh) {
  const MeshTopology topology(mesh);
  std::array<double, 2> greatest{0, 0};
  for (const EdgeEnds& edge : rim_of(mesh)) {
    const Vec3 exact = mesh.positions[edge[0]].normalized();
    Vec3 mean = Vec3::Zero();
    for (const Index corner : topology.vertex_corners(edge[0])) {
      const auto face = mesh.face(topology.face(corner));
      const Vec3& origin = mesh.positions[face[0]];
      for (std::size_t i = 1; i + 1 < face.size(); ++i)
        mean += (mesh.positions[face[i]] - origin).cross(mesh.positions[face[i + 1]] - origin);
    }
    greatest[0] = std::max(greatest[0], angle_between(rim_normal(mesh, topology, edge[0]), exact));
    greatest[1] = std::max(greatest[1], angle_between(mean, exact));
  }
  return greatest;
}

TEST_CASE("normals at a rim are carried on from the faces: their error falls faster than edges shorten") {
  std::vector<double> errors;
  for (const Index segments : {24U, 48U, 96U}) {
    const auto [carried, mean] = normal_errors(cut_above(uv_sphere(segments, segments / 2), 0.7));
    INFO(segments << " segments: " << carried << " against " << mean);
    CHECK(carried < 0.25 * mean);
    errors.push_back(carried);
  }
  CHECK(errors[2] < 0.22 * errors[0]);
}

TEST_CASE("slopes hold the mesh's normals along every curve") {
  const PolyMesh mesh = cut_above(uv_sphere(64, 32), 0.6);
  EdgeNetworkOptions options;
  options.slopes = true;
  const AttributeNetwork network = made(mesh, rim_of(mesh), options);
  REQUIRE(network.slopes.size() == network.curves.size());
  for (const SlopeAttribute& slope : network.slopes) {
    REQUIRE(slope.at.size() == slope.normals.size());
    CHECK(slope.at.front() == 0);
    CHECK(slope.at.back() == 1);
    CHECK(std::ranges::is_sorted(slope.at));
    const auto control = control_polygon(network, network.curves[slope.curve]);
    for (std::size_t i = 0; i < slope.at.size(); ++i) {
      const Vec3 place = bezier_point(control, slope.at[i]);  // a flat arc: its speed is nearly even
      CHECK(angle_between(slope.normals[i], place) < 0.02);
    }
  }
  CHECK(validate(network).empty());
}

TEST_CASE("a network of no edges is refused") { CHECK_THROWS_AS(made(cube(), {}), Error); }

}  // namespace
}  // namespace croquis::test
