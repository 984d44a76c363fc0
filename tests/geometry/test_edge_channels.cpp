// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/geometry/edge_channels.h"
#include "croquis/geometry/mesh_part.h"
#include "support/meshes/mesh_shapes.h"

using namespace croquis;
using namespace croquis::test;

namespace {

/// Each edge's value is the distance of its ends, so that it can be checked in any mesh with the same vertices.
void add_lengths(PolyMesh& mesh) {
  const MeshTopology topology(mesh);
  std::vector<double> lengths;
  for (Index e = 0; e < topology.edge_count(); ++e) {
    const auto [a, b] = topology.edge_vertices(e);
    lengths.push_back((mesh.positions[a] - mesh.positions[b]).norm());
  }
  mesh.channels.push_back({"length", Domain::Edge, 1, lengths, {}});
}

}  // namespace

TEST_CASE("a mesh has as many edges as its topology, whatever it is made of") {
  std::vector<PolyMesh> meshes = {tetrahedron(),
                                  cube(),
                                  double_torus(),
                                  grid(5, 3),
                                  moebius(4),
                                  PolyMesh(),
                                  tetrahedra_sharing_edge(),
                                  tetrahedra_sharing_vertex(),
                                  random_soup(1, 50)};
  PolyMesh odd = grid(3, 3);
  odd.add_face(std::vector<Index>{1, 1, 2, 5, 2});
  odd.add_face(std::vector<Index>{3});
  odd.add_face(std::vector<Index>{});
  odd.add_face(std::vector<Index>{0, 9});
  meshes.push_back(odd);
  for (const PolyMesh& mesh : meshes) {
    CHECK(mesh.element_count(Domain::Edge) == MeshTopology(mesh).edge_count());
    CHECK_FALSE(mesh.has_edge_channels());
  }
}

TEST_CASE("channels of edges must have one value for each edge") {
  PolyMesh mesh = cube();
  mesh.channels.push_back({"weight", Domain::Edge, 2, std::vector<float>(24), {}});
  CHECK(mesh.has_edge_channels());
  CHECK(validate(mesh).empty());
  std::get<std::vector<float>>(mesh.channels[0].data).pop_back();
  REQUIRE(validate(mesh).size() == 1);
  CHECK(validate(mesh)[0].code == "E_COUNT");
}

TEST_CASE("edges are found by their ends, in both directions, and only those") {
  const PolyMesh mesh = grid(4, 4);
  const MeshTopology topology(mesh);
  std::size_t found = 0;
  for (Index a = 0; a < mesh.vertex_count(); ++a) {
    for (Index b = 0; b < mesh.vertex_count(); ++b) {
      const Index edge = find_edge(topology, a, b);
      CHECK(edge == find_edge(topology, b, a));
      if (edge == no_index) continue;
      ++found;
      const auto ends = topology.edge_vertices(edge);
      CHECK(std::minmax(ends[0], ends[1]) == std::minmax(a, b));
    }
  }
  CHECK(found == 2 * topology.edge_count());
  CHECK(find_edge(topology, no_index, 0) == no_index);
  CHECK(find_edge(topology, 0, 10000) == no_index);
}

TEST_CASE("the sharper of two tags on an edge counts, and tags on nothing are left out") {
  const MeshTopology topology(cube());
  MeshTags tags;
  const auto [a, b] = topology.edge_vertices(4);
  tags.creases = {{{a, b}, 2.5}, {{b, a}, 1}, {{a, a}, 3}, {{a, 4000}, 3}};
  std::vector<double> expected(12, 0);
  expected[4] = 2.5;
  CHECK(edge_sharpness(tags, topology) == expected);
  tags.creases.push_back({{b, a}, greatest_sharpness});
  expected[4] = infinite_sharpness;
  CHECK(edge_sharpness(tags, topology) == expected);
}

TEST_CASE("a part of a mesh keeps the values of the edges that remain") {
  PolyMesh mesh = uv_sphere(8, 6);
  add_lengths(mesh);
  std::vector<bool> vertices(mesh.vertex_count(), true), faces(mesh.face_count(), true);
  for (std::size_t i = 0; i < mesh.vertex_count(); i += 7) vertices[i] = false;
  for (std::size_t i = 0; i < mesh.face_count(); i += 5) faces[i] = false;
  PolyMesh part = part_of(mesh, vertices, faces).mesh;
  CHECK(validate(part).empty());
  const AttributeChannel kept = *part.channel("length", Domain::Edge);
  part.channels.clear();
  add_lengths(part);
  CHECK(kept.data == part.channels[0].data);
}

TEST_CASE("new edges have no value: NaN in floating channels, 0 in others") {
  const PolyMesh before = grid(2, 1);
  PolyMesh after = before;
  after.channels = {{"length", Domain::Edge, 1, std::vector<double>(7, 1), {}},
                    {"count", Domain::Edge, 1, std::vector<std::int32_t>(7, 1), {}},
                    {"short", Domain::Edge, 1, std::vector<std::int32_t>(3, 1), {}}};
  after.add_face(std::vector<Index>{0, 2, 5});
  renumber_edge_channels(before, {}, after);
  const MeshTopology topology(after);
  const auto& lengths = std::get<std::vector<double>>(after.channels[0].data);
  const auto& counts = std::get<std::vector<std::int32_t>>(after.channels[1].data);
  REQUIRE(lengths.size() == topology.edge_count());
  REQUIRE(counts.size() == topology.edge_count());
  const MeshTopology old(before);
  for (Index e = 0; e < topology.edge_count(); ++e) {
    const auto [a, b] = topology.edge_vertices(e);
    const bool was_there = find_edge(old, a, b) != no_index;
    CHECK(std::isnan(lengths[e]) == !was_there);
    CHECK(counts[e] == (was_there ? 1 : 0));
  }
  CHECK(after.channels[2].size() == 3);
}
