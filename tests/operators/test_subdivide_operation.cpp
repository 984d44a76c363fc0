// SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/document/content_hash.h"
#include "croquis/document/memo.h"
#include "croquis/io/mesh_tags_file.h"
#include "croquis/operators/subdivide_result.h"
#include "operators/operations.h"
#include "operators/subdivide_tags.h"
#include "support/check_operation.h"
#include "support/meshes/cages.h"
#include "support/meshes/mesh_shapes.h"

namespace croquis {
namespace {

Values inputs_of(const PolyMesh& cage) { return {{"cage", std::make_shared<const PolyMesh>(cage)}}; }

OperationResult subdivide(const PolyMesh& cage, const ParameterValues& parameters = {},
                          Quality quality = Quality::Final, Memo* memo = nullptr) {
  Progress progress;
  Context context{progress, quality, memo};
  return run(*subdivide_operation(), inputs_of(cage), parameters, context);
}

const PolyMesh& mesh_of(const OperationResult& result, const char* port = "mesh") {
  return result.outputs.at(port).get<PolyMesh>();
}

const Report& report_of(const OperationResult& result, const char* port = "details") {
  return result.outputs.at(port).get<Report>();
}

PolyMesh soft_torus() {
  return test::tagged(test::torus(12, 8), std::vector<test::VertexPair>{{0, 1}, {1, 2}, {2, 3}}, 1.5);
}

TEST_CASE("subdividing is a function of its arguments, in every scheme") {
  for (const char* scheme : {"doo-sabin", "catmull-clark", "loop"}) {
    for (const bool limit : {false, true}) {
      const ParameterValues parameters = {{"scheme", std::string(scheme)}, {"limit", limit}};
      test::check_operation(*subdivide_operation(), inputs_of(test::bolt_loop()), parameters);
      test::check_operation(*subdivide_operation(), inputs_of(soft_torus()), parameters);
    }
  }
  test::check_operation(*subdivide_operation(), inputs_of(test::mixed_disc()),
                        {{"preset", std::string("paper")}, {"provenance", true}, {"sharp-angle", 10.0}});
}

TEST_CASE("subdividing refuses a cage with the same findings every time") {
  PolyMesh cage = test::centred_cube();
  cage.add_triangle(0, 1, 6);
  cage.add_triangle(1, 0, 7);
  test::check_operation(*subdivide_operation(), inputs_of(cage), {});
  CHECK_THROWS_AS(subdivide(cage), Error);
}

TEST_CASE("tags of the second input count before the cage's own") {
  Values inputs = inputs_of(test::tagged(test::bolt(), std::vector<test::VertexPair>{{8, 9}}, 0.5));
  inputs["tags"] = std::make_shared<const Report>(report_of(test::bolt_loop().tags));
  Progress progress;
  Context context{progress};
  const OperationResult result = run(*subdivide_operation(), inputs, {}, context);
  CHECK(content_hash(result.outputs.at("mesh")) == content_hash(subdivide(test::bolt_loop()).outputs.at("mesh")));
  CHECK(read_mesh_tags(report_of(result, "tags-out")).tags == mesh_of(result).tags);
  test::check_operation(*subdivide_operation(), inputs, {});
}

TEST_CASE("a draft has the mesh of the final result") {
  for (const char* scheme : {"doo-sabin", "catmull-clark"}) {
    const ParameterValues parameters = {{"scheme", std::string(scheme)}};
    const OperationResult draft = subdivide(test::bolt_loop(), parameters, Quality::Draft);
    const OperationResult final = subdivide(test::bolt_loop(), parameters);
    for (const char* port : {"mesh", "chains", "tags-out"}) {
      CHECK(content_hash(draft.outputs.at(port)) == content_hash(final.outputs.at(port)));
    }
    CHECK(report_of(draft).at("levels").as_array().size() == 3);
    CHECK(report_of(final).find("chains") != nullptr);
  }
}

TEST_CASE("dragging points keeps the plan; tags, rules and levels make another") {
  Memo memo;
  PolyMesh cage = test::bolt_loop();
  subdivide(cage, {}, Quality::Draft, &memo);
  const std::size_t kept = memo.bytes();
  REQUIRE(kept > 0);
  for (int i = 0; i < 5; ++i) {
    cage.positions[3] += Vec3(0.1, -0.2, 0.3);
    const OperationResult warm = subdivide(cage, {}, Quality::Draft, &memo);
    CHECK(memo.bytes() == kept);
    CHECK(content_hash(warm.outputs.at("mesh")) == content_hash(subdivide(cage).outputs.at("mesh")));
  }
  std::size_t last = kept;
  const auto makes_another = [&](const PolyMesh& other, const ParameterValues& parameters) {
    subdivide(other, parameters, Quality::Draft, &memo);
    const bool grew = memo.bytes() > last;
    last = memo.bytes();
    return grew;
  };
  for (const auto& [name, value] : std::map<std::string, ParameterValue>{{"levels", std::int64_t{1}},
                                                                         {"scheme", std::string("loop")},
                                                                         {"weights", std::string("average")},
                                                                         {"profile", std::string("plain")},
                                                                         {"chain-ends", std::string("pin")},
                                                                         {"boundary-corners", std::string("smooth")}}) {
    INFO(name);
    CHECK(makes_another(cage, {{name, value}}));
    CHECK_FALSE(makes_another(cage, {{name, value}}));
  }
  PolyMesh other = cage;
  other.tags.creases[0].sharpness = 3;
  CHECK(makes_another(other, {}));
  other.tags.pins = {8};
  CHECK(makes_another(other, {}));
  std::rotate(other.corners.begin(), other.corners.begin() + 1, other.corners.begin() + 4);
  CHECK(makes_another(other, {}));
  CHECK_FALSE(makes_another(cage, {{"weights", std::string("classical")}}));  // the preset's own
}

TEST_CASE("chains come out as curves with a name each") {
  const OperationResult result = subdivide(test::bolt_loop());
  CHECK(std::get<bool>(report_of(result).at("chains").as_array().at(0).at("planar").value()));
  const PolyMesh& lines = mesh_of(result, "chains");
  REQUIRE(lines.line_count() == 1);
  CHECK(lines.line(0).front() == lines.line(0).back());
  CHECK(lines.channel("object", Domain::Line)->labels == std::vector<std::string>{"chain 1"});
  for (const Vec3& point : lines.positions) {
    CHECK(point.z() == 0);
    CHECK(point.norm() >= 1 - 1e-4);
    CHECK(point.norm() <= 1.0606602);  // 3 sqrt(2) / 4
  }
  PolyMesh pinned = test::bolt_loop();
  pinned.tags.pins = {8, 9, 10, 11};
  CHECK(mesh_of(subdivide(pinned), "chains").line_count() == 4);
  CHECK(mesh_of(subdivide(test::bolt()), "chains").line_count() == 0);
  const OperationResult open = subdivide(test::bolt_open_chain());
  const Report& chain = report_of(open).at("chains").as_array().at(0);
  CHECK(chain.at("ends").as_array().at(0).as_string() == "dart");
}

TEST_CASE("chains tell which tagged edges of the cage they descend from, in all schemes") {
  const std::string scheme = GENERATE("doo-sabin", "catmull-clark", "loop");
  // The upper chain of a cube is gone after one level; the lower one stays, whichever of them is tagged first.
  PolyMesh cage = test::cube();
  std::set<std::vector<Index>> lasting;
  for (std::size_t f = 0; f < cage.face_count(); ++f) {
    const auto face = cage.face(f);
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Index a = face[i], b = face[(i + 1) % face.size()];
      if (a > b || cage.positions[a].z() != cage.positions[b].z()) continue;
      const bool upper = cage.positions[a].z() > 0;
      cage.tags.creases.push_back({{a, b}, upper ? 1 : infinite_sharpness});
      if (!upper) lasting.insert({a, b});
    }
  }
  const OperationResult result = subdivide(cage, {{"scheme", scheme}, {"levels", std::int64_t{2}}});
  const Report::Array& chains = report_of(result).at("chains").as_array();
  REQUIRE(chains.size() == 1);
  std::set<std::vector<Index>> told;
  for (const Report& edge : chains.front().at("cage_edges").as_array()) {
    told.insert({static_cast<Index>(edge.as_array().at(0).as_integer()),
                 static_cast<Index>(edge.as_array().at(1).as_integer())});
  }
  CHECK(told.size() == 4);
  CHECK(told == lasting);

  PolyMesh pinned = test::bolt_loop();
  pinned.tags.pins = {8, 9, 10, 11};
  const OperationResult four = subdivide(pinned, {{"scheme", scheme}});
  std::set<std::string> edges;
  for (const Report& chain : report_of(four).at("chains").as_array()) {
    REQUIRE(chain.at("cage_edges").as_array().size() == 1);
    const Report::Array& ends = chain.at("cage_edges").as_array().front().as_array();
    edges.insert(std::to_string(ends.at(0).as_integer()) + " " + std::to_string(ends.at(1).as_integer()));
  }
  CHECK(edges == std::set<std::string>{"8 9", "9 10", "10 11", "8 11"});
}

TEST_CASE("united tags keep what only one side has, and take the added side's word else") {
  const MeshTags own{{{{0, 1}, 1}, {{3, 2}, 2}}, {4, 5}, {{"a", 1, {{0, 1}}, {}}, {"b", 2, {{2, 3}}, {4}}}};
  const MeshTags added{{{{2, 3}, infinite_sharpness}, {{5, 6}, 0}}, {5, 7}, {{"b", infinite_sharpness, {}, {}}}};
  const MeshTags united = united_tags(own, added);
  CHECK(united.creases == std::vector<Crease>{{{0, 1}, 1}, {{2, 3}, infinite_sharpness}, {{5, 6}, 0}});
  CHECK(united.pins == std::vector<Index>{4, 5, 7});
  REQUIRE(united.sets.size() == 2);
  CHECK(united.sets[0].name == "a");
  CHECK(united.sets[1] == CreaseSet{"b", infinite_sharpness, {}, {}});
  CHECK(united_tags(own, {}) == own);
  CHECK(united_tags({}, own) == own);
}

TEST_CASE("sharp angles look at faces as they are repaired, and leave out boundaries and tagged edges") {
  PolyMesh cube = test::centred_cube();
  std::reverse(cube.corners.begin() + 4, cube.corners.begin() + 8);
  CHECK(with_sharp_angles(cube, 1, {}).creases.size() == 12);
  CHECK(with_sharp_angles(cube, 1.58, {}).creases.empty());
  CHECK(with_sharp_angles(test::grid(3, 3), 0.1, {}).creases.empty());
  cube.tags.creases = {{{5, 4}, 0}, {{0, 1}, 2}};
  const MeshTags tags = with_sharp_angles(cube, 1, {});
  CHECK(tags.creases.size() == 12);
  CHECK(tags.creases[0] == cube.tags.creases[0]);
  CHECK(tags.creases[1] == cube.tags.creases[1]);
}

TEST_CASE("programs read of a subdivision what its mesh shows; chains are judged in final results alone") {
  const OperationResult result = subdivide(test::bolt_loop());
  const SubdivideResult& found = *result.details.get<SubdivideResult>();
  CHECK(found.levels.back().vertices == mesh_of(result).vertex_count());
  CHECK(found.levels.back().faces == mesh_of(result).face_count());
  CHECK(found.judged);
  REQUIRE(found.chains.size() == 1);
  CHECK(found.chains[0].edges == found.levels.back().sharp_edges);
  CHECK(found.chains[0].least_angle > 0);
  CHECK(found.chains[0].greatest_angle < std::numbers::pi);
  CHECK(found.continuity.size() == found.levels.size());

  const OperationResult draft = subdivide(test::bolt_loop(), {}, Quality::Draft);
  CHECK_FALSE(draft.details.get<SubdivideResult>()->judged);
  CHECK(draft.details.get<SubdivideResult>()->chains.empty());
  CHECK(draft.details.get<SubdivideResult>()->levels.size() == found.levels.size());
}

}  // namespace
}  // namespace croquis
