// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <catch2/catch.hpp>

#include "croquis/geometry/joined_meshes.h"
#include "croquis/geometry/mesh_topology.h"
#include "support/meshes/mesh_shapes.h"

using namespace croquis;

namespace {

NamedMesh named(const std::string& name, PolyMesh mesh, const Affine3& map = {}) {
  return {name, std::make_shared<const PolyMesh>(std::move(mesh)), map};
}

template <class Value>
const std::vector<Value>& values_of(const PolyMesh& mesh, const char* name, Domain domain) {
  return std::get<std::vector<Value>>(mesh.channel(name, domain)->data);
}

}  // namespace

TEST_CASE("joined meshes share nothing, stand where they are put, and have their names on their faces") {
  const Affine3 away{2 * Eigen::Matrix3d::Identity(), {10, 0, 0}};
  const PolyMesh all = joined({named("left", test::cube()), named("right", test::cube(), away)});
  CHECK(validate(all).empty());
  CHECK(all.vertex_count() == 16);
  CHECK(all.face_count() == 12);
  CHECK(MeshTopology(all).edge_count() == 24);
  for (Index v = 0; v < 8; ++v) CHECK(all.positions[v + 8] == away(all.positions[v]));
  for (std::size_t corner = 0; corner < 24; ++corner) CHECK(all.corners[24 + corner] == all.corners[corner] + 8);
  const auto& objects = values_of<std::int32_t>(all, "object", Domain::Face);
  CHECK(objects == std::vector<std::int32_t>{0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1});
  CHECK(all.channel("object", Domain::Face)->labels == std::vector<std::string>{"left", "right"});
}

TEST_CASE("channels that some joined meshes lack say so there; own objects become groups; tags go along") {
  PolyMesh painted = test::cube();
  painted.channels.push_back({"color", Domain::Vertex, 3, std::vector<float>(24, 0.5F), {}});
  painted.channels.push_back({"object", Domain::Face, 1, std::vector<std::int32_t>{0, 0, 0, 1, 1, 1}, {"a", "b"}});
  painted.channels.push_back({"flags", Domain::Face, 1, std::vector<std::uint8_t>(6, 1), {}});
  painted.tags.creases = {{{0, 1}, 3}};
  painted.tags.pins = {2};
  painted.tags.sets = {{"rim", 3, {{0, 1}}, {2}}};
  const PolyMesh all = joined({named("plain", test::cube()), named("one", painted), named("two", painted)});
  CHECK(validate(all).empty());
  const auto& colours = values_of<float>(all, "color", Domain::Vertex);
  REQUIRE(colours.size() == 72);
  CHECK(std::isnan(colours[23]));
  CHECK(colours[24] == 0.5F);
  const auto& groups = values_of<std::int32_t>(all, "group", Domain::Face);
  CHECK(groups == std::vector<std::int32_t>{-1, -1, -1, -1, -1, -1, 0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3});
  CHECK(all.channel("group", Domain::Face)->labels == std::vector<std::string>{"a", "b", "a", "b"});
  CHECK(all.channel("flags", Domain::Face) == nullptr);  // whole numbers have no "none"
  REQUIRE(all.tags.creases.size() == 2);
  CHECK(all.tags.creases[1].vertices == std::array<Index, 2>{16, 17});
  CHECK(all.tags.pins == std::vector<Index>{10, 18});
  REQUIRE(all.tags.sets.size() == 2);
  CHECK(all.tags.sets[1].name == "rim (two)");
}

TEST_CASE("a single mesh joined is the mesh, mapped") {
  const Affine3 map{Eigen::Matrix3d::Identity(), {1, 2, 3}};
  const PolyMesh one = joined({named("cube", test::cube(), map)});
  CHECK(one.channels.empty());
  CHECK(one.positions.front() == test::cube().positions.front() + Vec3(1, 2, 3));
}
