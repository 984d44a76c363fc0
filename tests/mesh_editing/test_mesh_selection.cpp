// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include <catch2/catch.hpp>

#include "croquis/mesh_editing/mesh_selection.h"
#include "support/meshes/cages.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"

namespace croquis {
namespace {

const std::vector<ComponentKind> kinds = {ComponentKind::Vertex, ComponentKind::Edge, ComponentKind::Face};

std::vector<PolyMesh> families() {
  return {test::tetrahedron(),
          test::cube(),
          test::uv_sphere(8, 5),
          test::torus(7, 5),
          test::grid(4, 3),
          test::double_torus(),
          test::moebius(6),
          test::tetrahedra_sharing_edge(),
          test::tetrahedra_sharing_vertex(),
          test::merged(test::cube(), test::translated(test::grid(2, 2), {5, 0, 0}))};
}

/// Edges whose ends both satisfy something.
template <typename Is>
Elements edges_where(const MeshTopology& topology, Is is) {
  Elements edges;
  for (Index edge = 0; edge < topology.edge_count(); ++edge) {
    const auto [a, b] = topology.edge_vertices(edge);
    if (is(a) && is(b)) edges.push_back(edge);
  }
  return edges;
}

TEST_CASE("a loop on a torus goes once around and closes") {
  const PolyMesh mesh = test::torus(7, 5);
  const MeshTopology topology(mesh);
  std::size_t along = 0;
  for (Index edge = 0; edge < topology.edge_count(); ++edge) {
    const Elements loop = edge_loop(topology, edge);
    CHECK((loop.size() == 7 || loop.size() == 5));
    CHECK(std::binary_search(loop.begin(), loop.end(), edge));
    CHECK(closes(topology, edge_loop(topology, edge, true)));
    for (const Index other : loop) CHECK(edge_loop(topology, other) == loop);
    const Elements ring = edge_ring(topology, edge);
    CHECK(ring.size() == 12 - loop.size());
    for (const Index other : ring) CHECK(edge_ring(topology, other) == ring);
    along += loop.size() == 7 ? 1U : 0U;
  }
  CHECK(along == 35);
}

TEST_CASE("loops end where other than four edges meet, and follow the rim") {
  const PolyMesh cube = test::cube();
  const MeshTopology of_cube(cube);
  for (Index edge = 0; edge < of_cube.edge_count(); ++edge) {
    CHECK(edge_loop(of_cube, edge) == Elements{edge});
    CHECK(edge_ring(of_cube, edge).size() == 4);
  }
  const PolyMesh grid = test::grid(4, 3);
  const MeshTopology topology(grid);
  const Elements rim = boundary_edges(topology);
  CHECK(rim.size() == 14);
  CHECK(edge_loop(topology, rim.front()) == rim);
  CHECK(closes(topology, edge_loop(topology, rim.front(), true)));
  const Elements column = edges_where(topology, [&](Index v) { return grid.positions[v].x() == 2; });
  CHECK(column.size() == 3);
  CHECK(edge_loop(topology, column[1]) == column);
  CHECK_FALSE(closes(topology, edge_loop(topology, column[1], true)));
  CHECK(edge_ring(topology, column[1]).size() == 5);
}

TEST_CASE("a loop goes around the face that closes a tube") {
  for (const Index sides : {5U, 6U, 12U}) {
    const PolyMesh prism = test::ring_stack(sides, std::array{test::Ring{1, 1}, test::Ring{1, 0}});
    const MeshTopology topology(prism);
    std::size_t around = 0;
    for (Index edge = 0; edge < topology.edge_count(); ++edge) {
      const auto [a, b] = topology.edge_vertices(edge);
      const bool upright = a / sides != b / sides;
      const Elements loop = edge_loop(topology, edge);
      CHECK(loop.size() == (upright ? 1 : sides));
      CHECK(closes(topology, edge_loop(topology, edge, true)) != upright);
      for (const Index other : loop) CHECK(edge_loop(topology, other) == loop);
      around += upright ? 0 : 1;
    }
    CHECK(around == 2 * sides);
  }
}

TEST_CASE("an ordered loop is a walk") {
  const PolyMesh mesh = test::uv_sphere(12, 7);
  const MeshTopology topology(mesh);
  for (Index edge = 0; edge < topology.edge_count(); ++edge) {
    const Elements loop = edge_loop(topology, edge, true);
    for (std::size_t i = 0; i + 1 < loop.size(); ++i) {
      const auto a = topology.edge_vertices(loop[i]);
      const auto b = topology.edge_vertices(loop[i + 1]);
      CHECK((a[0] == b[0] || a[0] == b[1] || a[1] == b[0] || a[1] == b[1]));
    }
    CHECK((loop.size() == 12 || loop.size() == 7));  // a circle of latitude, or from pole to pole
  }
}

TEST_CASE("growing is undone by shrinking on a closed row, and nothing outgrows its piece") {
  for (const PolyMesh& mesh : families()) {
    const MeshTopology topology(mesh);
    // Growing goes over a vertex that two pieces share; what is connected hangs together by edges.
    if (topology.component_count() > 1 && mesh.vertex_count() == 7) continue;
    for (const ComponentKind kind : kinds) {
      const std::size_t count = element_count(topology, kind);
      for (Index first = 0; first < count; first += 3) {
        const Elements seed = {first};
        const Elements more = grown(topology, kind, seed);
        CHECK(std::includes(more.begin(), more.end(), seed.begin(), seed.end()));
        const Elements piece = connected(topology, kind, seed);
        CHECK(std::includes(piece.begin(), piece.end(), more.begin(), more.end()));
        CHECK(grown(topology, kind, piece) == piece);
        CHECK(shrunk(topology, kind, piece) == piece);
        const Elements less = shrunk(topology, kind, more);
        CHECK(std::includes(more.begin(), more.end(), less.begin(), less.end()));
        // What shrinks away is what the others grow into.
        CHECK(less == inverted(grown(topology, kind, inverted(more, count)), count));
      }
    }
  }
}

TEST_CASE("growing again and again reaches the whole connected piece") {
  const PolyMesh mesh = test::merged(test::torus(6, 4), test::translated(test::cube(), {5, 0, 0}));
  const MeshTopology topology(mesh);
  for (const ComponentKind kind : kinds) {
    Elements reached = {0};
    for (int i = 0; i < 12; ++i) reached = grown(topology, kind, reached);
    CHECK(reached == connected(topology, kind, Elements{0}));
  }
  CHECK(connected(topology, ComponentKind::Face, Elements{0}).size() == 24);
}

TEST_CASE("converting there and back keeps what was selected") {
  test::Random random(4);
  for (const PolyMesh& mesh : families()) {
    const MeshTopology topology(mesh);
    for (const ComponentKind from : kinds) {
      Elements some;
      for (Index i = 0; i < element_count(topology, from); ++i)
        if (random.unit() < 0.3) some.push_back(i);
      for (const ComponentKind to : kinds) {
        // Towards fewer dimensions and back to what is contained nothing gets lost.
        if (to > from) continue;
        const Elements there = converted(topology, from, to, some);
        const Elements back = converted(topology, to, from, there, ConvertRule::Contained);
        CHECK(std::includes(back.begin(), back.end(), some.begin(), some.end()));
        const Elements touching = converted(topology, to, from, there);
        CHECK(std::includes(touching.begin(), touching.end(), back.begin(), back.end()));
      }
    }
  }
}

TEST_CASE("conversions of a cube's elements are what one counts") {
  const PolyMesh mesh = test::cube();
  const MeshTopology topology(mesh);
  const Elements corner = {0};
  CHECK(converted(topology, ComponentKind::Vertex, ComponentKind::Edge, corner).size() == 3);
  CHECK(converted(topology, ComponentKind::Vertex, ComponentKind::Face, corner).size() == 3);
  CHECK(converted(topology, ComponentKind::Vertex, ComponentKind::Edge, corner, ConvertRule::Contained).empty());
  CHECK(converted(topology, ComponentKind::Face, ComponentKind::Edge, corner).size() == 4);
  CHECK(converted(topology, ComponentKind::Face, ComponentKind::Vertex, corner).size() == 4);
  CHECK(converted(topology, ComponentKind::Edge, ComponentKind::Face, corner).size() == 2);
  const Elements around = converted(topology, ComponentKind::Face, ComponentKind::Edge, corner);
  CHECK(converted(topology, ComponentKind::Edge, ComponentKind::Face, around, ConvertRule::Contained) == corner);
}

TEST_CASE("the shortest way over a grid is as long as its steps") {
  const PolyMesh mesh = test::grid(6, 4);
  const MeshTopology topology(mesh);
  test::Random random(5);
  for (int i = 0; i < 50; ++i) {
    const Index from = random.below(static_cast<Index>(mesh.vertex_count()));
    const Index to = random.below(static_cast<Index>(mesh.vertex_count()));
    const Elements way = shortest_path(topology, mesh.positions, from, to);
    const Vec3 steps = (mesh.positions[to] - mesh.positions[from]).cwiseAbs();
    CHECK(static_cast<double>(way.size()) == steps.sum());
    // Every vertex but the ends lies on two of its edges.
    std::vector<int> uses(mesh.vertex_count(), 0);
    for (const Index edge : way) {
      for (const Index v : topology.edge_vertices(edge)) ++uses[v];
    }
    const auto odd = std::count_if(uses.begin(), uses.end(), [](int n) { return n % 2 != 0; });
    CHECK(odd == (from == to ? 0 : 2));
  }
}

TEST_CASE("the shortest way turns from long edges to short ones") {
  // A long detour of one edge against three short ones.
  PolyMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 5, 0}};
  mesh.add_triangle(0, 1, 3);
  mesh.add_triangle(1, 2, 3);
  const MeshTopology topology(mesh);
  CHECK(shortest_path(topology, mesh.positions, 0, 2) ==
        sorted_unique({find_edge(topology, 0, 1), find_edge(topology, 1, 2)}));
  const Elements far =
      shortest_edge_path(topology, mesh.positions, find_edge(topology, 0, 3), find_edge(topology, 1, 2));
  CHECK(far == sorted_unique({find_edge(topology, 0, 3), find_edge(topology, 0, 1), find_edge(topology, 1, 2)}));
  const PolyMesh apart = test::merged(test::cube(), test::translated(test::cube(), {3, 0, 0}));
  CHECK(shortest_path(MeshTopology(apart), apart.positions, 0, 9).empty());
}

TEST_CASE("a part of a closed row is its shorter side") {
  const Elements row = {10, 11, 12, 13, 14, 15, 16, 17};
  CHECK(part_between(row, 11, 13, true) == Elements{11, 12, 13});
  CHECK(part_between(row, 16, 11, true) == Elements{10, 11, 16, 17});
  CHECK(part_between(row, 16, 11, false) == Elements{11, 12, 13, 14, 15, 16});
  CHECK(part_between(row, 16, 99, true).empty());
}

TEST_CASE("dihedral angles of known bodies are exact") {
  const PolyMesh cube = test::rotated(test::cube(), 0.7, Vec3(1, 2, 3).normalized());
  const auto check_angle = [](const PolyMesh& mesh, double degrees) {
    const MeshTopology topology(mesh);
    CHECK(edges_sharper_than(topology, mesh, degrees * (1 - 1e-12)).size() == topology.edge_count());
    CHECK(edges_sharper_than(topology, mesh, degrees * (1 + 1e-12)).empty());
  };
  check_angle(cube, 90);
  check_angle(test::flipped_face(test::cube(), 2), 90);
  PolyMesh regular;
  regular.positions = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  for (const std::array<Index, 3>& f : {std::array<Index, 3>{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}})
    regular.add_triangle(f[0], f[1], f[2]);
  check_angle(regular, 180 - std::acos(1.0 / 3) * 180 / 3.14159265358979323846);
  const PolyMesh flat = test::grid(3, 3);
  CHECK(edges_sharper_than(MeshTopology(flat), flat, 0.001).empty());
}

TEST_CASE("a chain of tags goes on until it forks, ends or is pinned") {
  PolyMesh mesh = test::grid(6, 2);
  const MeshTopology topology(mesh);
  const Elements line = edges_where(topology, [&](Index v) { return mesh.positions[v].y() == 1; });
  REQUIRE(line.size() == 6);
  MeshTags tags;
  for (const Index edge : line) tags.creases.push_back({topology.edge_vertices(edge), 2});
  CHECK(tagged_chain(topology, tags, line[2]) == line);
  const auto vertex_at = [&](double x, double y) {
    for (Index v = 0; v < mesh.vertex_count(); ++v)
      if (mesh.positions[v].x() == x && mesh.positions[v].y() == y) return v;
    return no_index;
  };
  MeshTags pinned = tags;
  pinned.pins = {vertex_at(4, 1)};
  CHECK(tagged_chain(topology, pinned, find_edge(topology, vertex_at(0, 1), vertex_at(1, 1))).size() == 4);
  MeshTags forked = tags;
  forked.creases.push_back({{vertex_at(2, 0), vertex_at(2, 1)}, 1});
  CHECK(tagged_chain(topology, forked, find_edge(topology, vertex_at(0, 1), vertex_at(1, 1))).size() == 2);
  CHECK(tagged_chain(topology, tags, find_edge(topology, vertex_at(2, 0), vertex_at(2, 1))).size() == 1);
}

}  // namespace
}  // namespace croquis
