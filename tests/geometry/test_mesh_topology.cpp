// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/geometry/mesh_topology.h"
#include "support/meshes/mesh_shapes.h"

using namespace croquis;
using namespace croquis::test;

namespace {

std::vector<PolyMesh> family() {
  return {PolyMesh{},
          tetrahedron(),
          cube(),
          uv_sphere(6, 4),
          torus(5, 3),
          double_torus(),
          grid(3, 2),
          moebius(5),
          tetrahedra_sharing_edge(),
          tetrahedra_sharing_vertex(),
          merged(grid(2, 2), tetrahedron()),
          flipped_face(cube(), 2),
          random_soup(3, 9),
          without_faces(grid(5, 5), std::vector<Index>{6, 12, 18, 8})};
}

std::pair<Index, Index> ends(const MeshTopology& topology, Index corner) {
  return std::minmax({topology.vertex(corner), topology.vertex(topology.next(corner))});
}

/// Edge use counts by a tree, the slow way.
std::map<std::pair<Index, Index>, std::size_t> counted_edges(const PolyMesh& mesh) {
  std::map<std::pair<Index, Index>, std::size_t> edges;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t i = 0; i < face.size(); ++i) {
      const auto [low, high] = std::minmax({face[i], face[(i + 1) % face.size()]});
      if (low != high) ++edges[{low, high}];
    }
  }
  return edges;
}

}  // namespace

TEST_CASE("edges are the distinct pairs of neighbours with all their corners") {
  for (const PolyMesh& mesh : family()) {
    const MeshTopology topology(mesh);
    const auto expected = counted_edges(mesh);
    CHECK(topology.edge_count() == expected.size());
    Index previous_lowest = 0;
    for (Index edge = 0; edge < topology.edge_count(); ++edge) {
      const auto corners = topology.edge_corners(edge);
      REQUIRE_FALSE(corners.empty());
      CHECK(std::is_sorted(corners.begin(), corners.end()));
      CHECK((edge == 0 || corners.front() > previous_lowest));
      previous_lowest = corners.front();
      CHECK(corners.size() == expected.at(ends(topology, corners.front())));
      for (const Index corner : corners) {
        CHECK(topology.edge(corner) == edge);
        CHECK(ends(topology, corner) == ends(topology, corners.front()));
      }
    }
  }
}

TEST_CASE("next and previous run around each face and undo each other") {
  for (const PolyMesh& mesh : family()) {
    const MeshTopology topology(mesh);
    for (Index corner = 0; corner < topology.corner_count(); ++corner) {
      CHECK(topology.previous(topology.next(corner)) == corner);
      CHECK(topology.face(topology.next(corner)) == topology.face(corner));
      Index last = corner;
      for (std::size_t i = 0; i < mesh.face(topology.face(corner)).size(); ++i) last = topology.next(last);
      CHECK(last == corner);
    }
  }
}

TEST_CASE("opposite corners point at each other where an edge has two faces, and nowhere else") {
  for (const PolyMesh& mesh : family()) {
    const MeshTopology topology(mesh);
    for (Index corner = 0; corner < topology.corner_count(); ++corner) {
      const Index other = topology.opposite(corner);
      REQUIRE((other != no_index) == (topology.edge_corners(topology.edge(corner)).size() == 2));
      if (other == no_index) continue;
      CHECK(other != corner);
      CHECK(topology.opposite(other) == corner);
    }
  }
}

TEST_CASE("vertex corners list each corner once, at its vertex") {
  for (const PolyMesh& mesh : family()) {
    const MeshTopology topology(mesh);
    std::size_t listed = 0;
    for (Index vertex = 0; vertex < topology.vertex_count(); ++vertex) {
      const auto corners = topology.vertex_corners(vertex);
      CHECK(std::is_sorted(corners.begin(), corners.end()));
      listed += corners.size();
      std::set<Index> fans;
      for (const Index corner : corners) {
        CHECK(topology.vertex(corner) == vertex);
        fans.insert(topology.fan(corner));
      }
      CHECK(fans.size() == topology.fan_count(vertex));
      CHECK((fans.empty() || *fans.rbegin() + 1 == fans.size()));
    }
    CHECK(listed == mesh.corners.size());
  }
}

TEST_CASE("closed surfaces have one fan per vertex and no rim") {
  for (const PolyMesh& mesh : {tetrahedron(), cube(), uv_sphere(5, 4), torus(4, 3), double_torus()}) {
    const MeshTopology topology(mesh);
    CHECK(topology.boundary_loops().size() == 0);
    for (Index vertex = 0; vertex < topology.vertex_count(); ++vertex) {
      CHECK(topology.fan_count(vertex) == 1);
      CHECK(topology.is_manifold(vertex));
    }
  }
}

TEST_CASE("a common vertex has two fans and joins no components") {
  const MeshTopology topology(tetrahedra_sharing_vertex());
  CHECK(topology.fan_count(0) == 2);
  CHECK_FALSE(topology.is_manifold(0));
  for (Index vertex = 1; vertex < 7; ++vertex) CHECK(topology.is_manifold(vertex));
  CHECK(topology.component_count() == 2);
  CHECK(topology.component(0) == 0);
  CHECK(topology.component(7) == 1);
}

TEST_CASE("a common edge makes its two ends non-manifold and joins the components") {
  const MeshTopology topology(tetrahedra_sharing_edge());
  CHECK(topology.component_count() == 1);
  for (Index vertex = 0; vertex < 6; ++vertex) CHECK(topology.is_manifold(vertex) == (vertex > 1));
  std::size_t shared = 0;
  for (Index edge = 0; edge < topology.edge_count(); ++edge) {
    if (topology.edge_corners(edge).size() == 2) continue;
    CHECK(topology.edge_corners(edge).size() == 4);
    ++shared;
  }
  CHECK(shared == 1);
}

TEST_CASE("the rim of a grid runs with its faces, the lowest vertex first") {
  const MeshTopology topology(grid(2, 1));
  REQUIRE(topology.boundary_loops().size() == 1);
  const auto loop = topology.boundary_loops()[0];
  CHECK(std::vector<Index>(loop.begin(), loop.end()) == std::vector<Index>{0, 1, 2, 5, 4, 3});
}

TEST_CASE("holes and the outer rim are loops of their own") {
  const PolyMesh mesh = without_faces(grid(7, 7), std::vector<Index>{8, 24, 25, 38});
  const MeshTopology topology(mesh);
  REQUIRE(topology.boundary_loops().size() == 4);
  std::multiset<std::size_t> lengths;
  Index lowest = 0;
  for (std::size_t l = 0; l < 4; ++l) {
    const auto loop = topology.boundary_loops()[l];
    lengths.insert(loop.size());
    CHECK(loop.front() >= lowest);
    lowest = loop.front();
    CHECK(*std::min_element(loop.begin(), loop.end()) == loop.front());
  }
  CHECK(lengths == std::multiset<std::size_t>{4, 4, 6, 28});
}

TEST_CASE("rims that meet in a vertex are cut there") {
  // Two holes that touch at their corners, and a chequered board where every inner vertex is such a place.
  const MeshTopology touching(without_faces(grid(4, 4), std::vector<Index>{5, 10}));
  CHECK(touching.boundary_loops().size() == 3);
  std::vector<Index> black;
  for (Index f = 0; f < 25; ++f) {
    if (f % 2 == 1) black.push_back(f);
  }
  const MeshTopology board(without_faces(grid(5, 5), black));
  std::size_t edges = 0;
  for (std::size_t l = 0; l < board.boundary_loops().size(); ++l) {
    const auto loop = board.boundary_loops()[l];
    CHECK(std::set<Index>(loop.begin(), loop.end()).size() == loop.size());
    edges += loop.size();
  }
  CHECK(edges == 13 * 4);
  CHECK(board.boundary_loops().size() == 13);  // staying in a fan, each white square is walked around by itself
}

TEST_CASE("every boundary edge is in exactly one loop, whichever way faces are turned") {
  std::vector<PolyMesh> meshes = family();
  for (Index f = 0; f < 6; ++f) meshes.push_back(flipped_face(grid(3, 2), f));
  for (const PolyMesh& mesh : meshes) {
    const MeshTopology topology(mesh);
    std::multiset<std::pair<Index, Index>> in_loops;
    for (std::size_t l = 0; l < topology.boundary_loops().size(); ++l) {
      const auto loop = topology.boundary_loops()[l];
      for (std::size_t i = 0; i < loop.size(); ++i)
        in_loops.insert(std::minmax({loop[i], loop[(i + 1) % loop.size()]}));
    }
    std::multiset<std::pair<Index, Index>> rim;
    for (const auto& [edge, uses] : counted_edges(mesh)) {
      if (uses == 1) rim.insert(edge);
    }
    CHECK(in_loops == rim);
  }
}

TEST_CASE("a Moebius strip has one loop around twice") {
  const MeshTopology topology(moebius(6));
  REQUIRE(topology.boundary_loops().size() == 1);
  CHECK(topology.boundary_loops()[0].size() == 12);
}

TEST_CASE("a fin on a closed body has one rim that ends at the non-manifold edge") {
  PolyMesh mesh = cube();
  const std::array<Index, 2> hinge = {mesh.corners[0], mesh.corners[1]};
  mesh.positions.emplace_back(-1, -1, 0);
  mesh.positions.emplace_back(-1, -1, 1);
  mesh.add_face(std::array<Index, 4>{hinge[0], hinge[1], 9, 8});
  const MeshTopology topology(mesh);
  REQUIRE(topology.boundary_loops().size() == 1);
  CHECK(topology.boundary_loops()[0].size() == 4);
}

TEST_CASE("three pages on a spine: every rim edge is walked once") {
  PolyMesh mesh;
  mesh.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}};
  mesh.add_triangle(0, 1, 2);
  mesh.add_triangle(0, 1, 3);
  mesh.add_triangle(0, 1, 4);
  const MeshTopology topology(mesh);
  CHECK(topology.boundary_loops().size() == 2);
  CHECK(topology.fan_count(0) == 3);
}

TEST_CASE("faces with repeated vertices are taken as they stand") {
  PolyMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.add_triangle(0, 0, 0);
  mesh.add_triangle(0, 0, 1);
  mesh.add_face(std::array<Index, 1>{2});
  mesh.add_face(std::span<const Index>{});
  const MeshTopology topology(mesh);
  CHECK(topology.edge_count() == 1);
  CHECK(topology.edge(0) == no_index);
  CHECK(topology.edge_corners(0).size() == 2);
  CHECK(topology.component_count() == 4);
  CHECK(topology.fan_count(0) == 2);
  CHECK(topology.boundary_loops().size() == 0);
}

TEST_CASE("indices out of range are refused with all findings") {
  PolyMesh mesh = tetrahedron();
  mesh.corners[0] = 4;
  mesh.corners[7] = no_index;
  try {
    MeshTopology topology(mesh);
    FAIL("accepted");
  } catch (const Error& error) {
    CHECK(error.findings().size() == 2);
    CHECK(error.findings()[0].code == "E_INDEX");
  }
  mesh = tetrahedron();
  mesh.face_offsets.back() = 11;
  CHECK_THROWS_AS(MeshTopology(mesh), Error);
}
