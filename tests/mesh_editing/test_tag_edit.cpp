// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/mesh_editing/tag_edit.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"

namespace croquis {
namespace {

const double infinity = infinite_sharpness;

struct Cube {
  PolyMesh mesh = test::cube();
  MeshTopology topology{mesh};
};

TEST_CASE("edges get, change and lose their sharpness one by one") {
  const Cube cube;
  MeshTags tags = with_sharpness({}, cube.topology, Elements{0, 3, 5}, 2);
  std::vector<double> expected(12, 0);
  expected[0] = expected[3] = expected[5] = 2;
  CHECK(edge_sharpness(tags, cube.topology) == expected);
  CHECK(tagged_edges(tags, cube.topology) == Elements{0, 3, 5});
  tags = with_sharpness_changed(tags, cube.topology, Elements{3, 4}, 1.5);
  expected[3] = 3.5;
  expected[4] = 1.5;
  CHECK(edge_sharpness(tags, cube.topology) == expected);
  tags = with_sharpness_changed(tags, cube.topology, Elements{0, 4}, -1.75);
  expected[0] = 0.25;
  expected[4] = 0;
  CHECK(edge_sharpness(tags, cube.topology) == expected);
  tags = with_sharpness(tags, cube.topology, all_elements(12), 0);
  CHECK(tags.empty());
}

TEST_CASE("ten levels and more are infinite, and infinite comes down from ten") {
  const Cube cube;
  MeshTags tags = with_sharpness({}, cube.topology, Elements{1}, 10);
  CHECK(tags.creases.front().sharpness == infinity);
  tags = with_sharpness_changed(tags, cube.topology, Elements{1}, -3);
  CHECK(tags.creases.front().sharpness == 7);
  tags = with_sharpness_changed(tags, cube.topology, Elements{1}, 3);
  CHECK(tags.creases.front().sharpness == infinity);
  CHECK(with_sharpness_changed(tags, cube.topology, Elements{1}, 0) == tags);
  CHECK(with_sharpness({}, cube.topology, Elements{1}, -2).empty());
  CHECK(with_sharpness({}, cube.topology, Elements{1}, std::nan("")).empty());
}

TEST_CASE("tags are found whichever way round their edges are written, and strangers stay") {
  const Cube cube;
  const auto [a, b] = cube.topology.edge_vertices(7);
  MeshTags tags;
  tags.creases = {{{b, a}, 1}, {{90, 91}, 4}};
  tags = with_sharpness(tags, cube.topology, Elements{7}, 3);
  REQUIRE(tags.creases.size() == 2);
  CHECK(tags.creases[0].sharpness == 3);
  CHECK(tags.creases[1].sharpness == 4);
  CHECK(tagged_edges(tags, cube.topology) == Elements{7});
}

TEST_CASE("changing some edges never touches the others") {
  const PolyMesh mesh = test::uv_sphere(9, 6);
  const MeshTopology topology(mesh);
  test::Random random(6);
  MeshTags tags;
  std::vector<double> known(topology.edge_count(), 0);
  for (int round = 0; round < 60; ++round) {
    Elements some;
    for (Index edge = 0; edge < topology.edge_count(); ++edge)
      if (random.unit() < 0.2) some.push_back(edge);
    const double value = std::floor(random.between(-6, 14));
    const bool sets = random.unit() < 0.5;
    tags = sets ? with_sharpness(tags, topology, some, value) : with_sharpness_changed(tags, topology, some, value);
    for (const Index edge : some) {
      const double now = sets ? value : std::min(known[edge], 10.0) + value;
      if (!sets && value == 0) continue;
      known[edge] = now <= 0 ? 0 : now >= 10 ? infinity : now;
    }
    CHECK(edge_sharpness(tags, topology) == known);
    CHECK(tags.creases.size() == tagged_edges(tags, topology).size());
  }
}

TEST_CASE("pins come and go") {
  MeshTags tags = with_pins({}, Elements{4, 2, 4}, true);
  CHECK(sorted_unique(tags.pins) == Elements{2, 4});
  tags = with_pins(tags, Elements{2, 6}, true);
  CHECK(tags.pins.size() == 3);
  tags = with_pins(tags, Elements{4, 5}, false);
  CHECK(sorted_unique(tags.pins) == Elements{2, 6});
}

TEST_CASE("members follow their set, and leave it when they are untagged") {
  const Cube cube;
  MeshTags tags = with_sharpness({}, cube.topology, Elements{9}, 1);
  tags = with_set(tags, cube.topology, "collar", Elements{0, 1, 2}, Elements{5}, 4);
  const CreaseSet* set = find_set(tags, "collar");
  REQUIRE(set != nullptr);
  CHECK(set_edges(*set, cube.topology) == Elements{0, 1, 2});
  CHECK(set_vertices(*set, cube.topology) == Elements{5});
  CHECK(tags.pins == Elements{5});
  tags = with_set_sharpness(tags, "collar", 6);
  const std::vector<double> sharpness = edge_sharpness(tags, cube.topology);
  CHECK(std::vector<double>(sharpness.begin(), sharpness.begin() + 3) == std::vector<double>{6, 6, 6});
  CHECK(sharpness[9] == 1);
  // One member may differ and still belong to it.
  tags = with_sharpness(tags, cube.topology, Elements{1}, 2);
  CHECK(set_edges(*find_set(tags, "collar"), cube.topology) == Elements{0, 1, 2});
  tags = with_sharpness(tags, cube.topology, Elements{1}, 0);
  CHECK(set_edges(*find_set(tags, "collar"), cube.topology) == Elements{0, 2});
  tags = with_pins(tags, Elements{5}, false);
  tags = with_sharpness(tags, cube.topology, Elements{0, 2}, 0);
  CHECK(find_set(tags, "collar") == nullptr);
  CHECK(tagged_edges(tags, cube.topology) == Elements{9});
}

TEST_CASE("an edge is in one set at most; sets merge, are renamed and go") {
  const Cube cube;
  MeshTags tags = with_set({}, cube.topology, "a", Elements{0, 1}, {}, 2);
  tags = with_set(tags, cube.topology, "b", Elements{1, 2}, {}, 5);
  CHECK(set_edges(*find_set(tags, "a"), cube.topology) == Elements{0});
  tags = with_set_renamed(tags, "b", "c");
  CHECK(find_set(tags, "b") == nullptr);
  tags = with_sets_merged(tags, "a", "c");
  REQUIRE(tags.sets.size() == 1);
  CHECK(set_edges(tags.sets[0], cube.topology) == Elements{0, 1, 2});
  for (std::size_t edge = 0; edge < 3; ++edge) CHECK(edge_sharpness(tags, cube.topology)[edge] == 2);
  CHECK(tagged_edges(without_set(tags, "a", false), cube.topology).size() == 3);
  CHECK(without_set(tags, "a", true).empty());
}

TEST_CASE("sets that can't be are refused by name") {
  const Cube cube;
  const MeshTags tags = with_set({}, cube.topology, "a", Elements{0}, {}, 2);
  CHECK_THROWS_AS(with_set(tags, cube.topology, "a", Elements{1}, {}, 2), Error);
  CHECK_THROWS_AS(with_set(tags, cube.topology, "", Elements{1}, {}, 2), Error);
  CHECK_THROWS_AS(with_set(tags, cube.topology, "b", {}, {}, 2), Error);
  CHECK_THROWS_AS(with_set(tags, cube.topology, "b", Elements{1}, {}, 0), Error);
  CHECK_THROWS_AS(with_set_renamed(tags, "x", "y"), Error);
  CHECK_THROWS_AS(with_set_sharpness(tags, "x", 1), Error);
  CHECK_THROWS_AS(with_sets_merged(tags, "a", "a"), Error);
  CHECK_THROWS_AS(without_set(tags, "x", true), Error);
  CHECK(new_set_name(tags) == "crease set 1");
}

}  // namespace
}  // namespace croquis
