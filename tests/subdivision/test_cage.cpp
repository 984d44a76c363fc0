// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/geometry/mesh_topology.h"
#include "croquis/subdivision/cage.h"
#include "subdivision/subdivided.h"
#include "support/meshes/cages.h"
#include "support/meshes/mesh_shapes.h"

namespace croquis::test {
namespace {

using subdivision::Cage;
using subdivision::CageResult;
using subdivision::CageUse;
using subdivision::make_cage;
using subdivision::Preset;
using subdivision::Rules;

std::vector<std::string> codes(const Findings& findings) {
  std::vector<std::string> result;
  for (const Finding& finding : findings) result.push_back(finding.code);
  return result;
}

Findings errors_of(const PolyMesh& mesh) {
  try {
    make_cage(mesh);
  } catch (const Error& error) {
    return error.findings();
  }
  return {};
}

using Codes = std::vector<std::string>;

TEST_CASE("cages of all kinds pass without a word and without a change") {
  for (const NamedCage& named : all_cages()) {
    INFO(named.name);
    const CageResult result = make_cage(named.mesh);
    CHECK(codes(result.warnings).empty());
    CHECK(fault(result.cage.topology) == "");
    CHECK(result.cage.positions == named.mesh.positions);
    CHECK(std::equal(named.mesh.corners.begin(), named.mesh.corners.end(), result.cage.topology.corner_vertex.begin()));
  }
}

TEST_CASE("an edge of three faces is refused, naming edge and faces") {
  const Findings findings = errors_of(tetrahedra_sharing_edge());
  REQUIRE(codes(findings) == Codes{"E_EDGE_SHARED"});
  CHECK(findings[0].category == Category::Geometry);
  CHECK(findings[0].message.find("edge (") == 0);
  CHECK(findings[0].message.find("is shared by faces ") != std::string::npos);
  CHECK(findings[0].subjects.size() == 5);
  CHECK(findings[0].subjects[0].kind == SubjectKind::Edge);
  CHECK(findings[0].subjects[1].kind == SubjectKind::Face);
}

TEST_CASE("faces that turn the wrong way are turned over and named") {
  PolyMesh mesh = bolt_loop();
  for (const Index face : {3u, 7u, 9u}) mesh = flipped_face(mesh, face);
  mesh.tags = bolt_loop().tags;
  const CageResult result = make_cage(mesh);
  REQUIRE(codes(result.warnings) == Codes{"W_FLIPPED"});
  CHECK(result.warnings[0].message == "3 faces were turned over to agree with the neighbours: 3, 7, 9.");
  CHECK(result.cage.flipped_faces == std::vector<Index>{3, 7, 9});
  CHECK(fault(result.cage.topology) == "");
  CHECK(std::count(result.cage.sharpness.begin(), result.cage.sharpness.end(), infinite_sharpness) == 4);
  // The same surface, with the same tags, as from faces that turn right.
  const Subdivided repaired = subdivide(mesh, 2), right = subdivide(bolt_loop(), 2);
  CHECK(volume(repaired.topology(2), repaired.points(2)) == Approx(volume(right.topology(2), right.points(2))));
  CHECK(same_points(repaired.points(2), right.points(2), 1e-12));
}

TEST_CASE("a surface with one side is refused, naming an edge of it") {
  const Findings findings = errors_of(moebius(7));
  REQUIRE(codes(findings) == Codes{"E_NOT_ORIENTABLE"});
  REQUIRE(findings[0].subjects.size() == 1);
  CHECK(findings[0].subjects[0].kind == SubjectKind::Edge);
  const std::vector<VertexPair> edges = all_edges(moebius(7));
  CHECK(std::any_of(edges.begin(), edges.end(), [&](const VertexPair& edge) {
    const std::array<std::int64_t, 2> there{edge[0], edge[1]}, back{edge[1], edge[0]};
    return findings[0].subjects[0].vertices == there || findings[0].subjects[0].vertices == back;
  }));
}

TEST_CASE("surfaces that touch in a vertex become two, each with its own") {
  PolyMesh mesh = tetrahedra_sharing_vertex();
  const auto shared = static_cast<Index>(MeshTopology(mesh).fan_count(0) == 2 ? 0 : 3);
  mesh.tags.pins = {shared};
  const std::vector<VertexPair> edges = all_edges(mesh);
  for (const VertexPair& edge : edges) {
    if (edge[0] == shared || edge[1] == shared) mesh.tags.creases.push_back({edge, infinite_sharpness});
  }
  const CageResult result = make_cage(mesh);
  REQUIRE(codes(result.warnings) == Codes{"W_BOWTIE"});
  CHECK(result.warnings[0].message.find("vertex " + std::to_string(shared)) != std::string::npos);
  CHECK(counts(result.cage.topology) == Counts{8, 12, 8});
  CHECK(fault(result.cage.topology) == "");
  CHECK(std::count(result.cage.source_vertex.begin(), result.cage.source_vertex.end(), shared) == 2);
  CHECK(std::count(result.cage.pinned.begin(), result.cage.pinned.end(), 1) == 2);
  CHECK(std::count(result.cage.sharpness.begin(), result.cage.sharpness.end(), infinite_sharpness) == 6);
}

TEST_CASE("faces with too few or repeated vertices are refused by name") {
  PolyMesh mesh = bolt();
  mesh.add_face(std::array<Index, 2>{0, 1});
  mesh.add_face(std::array<Index, 4>{0, 1, 2, 1});
  const Findings findings = errors_of(mesh);
  REQUIRE(codes(findings) == Codes{"E_FACE_DEGENERATE", "E_FACE_DEGENERATE"});
  for (const Finding& finding : findings) CHECK(finding.category == Category::Geometry);
  CHECK(findings[0].message.find("14") != std::string::npos);
  CHECK(findings[1].message.find("15") != std::string::npos);
}

TEST_CASE("indices out of range and positions that are no numbers are malformed") {
  PolyMesh mesh = bolt();
  mesh.corners[5] = 99;
  Findings findings = errors_of(mesh);
  REQUIRE(codes(findings) == Codes{"E_INDEX"});
  CHECK(findings[0].category == Category::Malformed);

  mesh = bolt();
  mesh.positions[7].y() = std::nan("");
  findings = errors_of(mesh);
  REQUIRE(codes(findings) == Codes{"E_NOT_FINITE"});
  CHECK(findings[0].category == Category::Malformed);
  CHECK(findings[0].message.find("7") != std::string::npos);
}

TEST_CASE("all errors of a mesh come at once") {
  PolyMesh mesh = merged(merged(tetrahedra_sharing_edge(), moebius(5)), cube());
  mesh.positions.back().x() = std::numeric_limits<double>::infinity();
  mesh.add_face(std::array<Index, 3>{1, 1, 0});
  Codes found = codes(errors_of(mesh));
  std::sort(found.begin(), found.end());
  CHECK(found == Codes{"E_EDGE_SHARED", "E_FACE_DEGENERATE", "E_NOT_FINITE", "E_NOT_ORIENTABLE"});
}

TEST_CASE("vertices without faces are left out with a notice") {
  PolyMesh mesh = cube();
  mesh.positions.insert(mesh.positions.begin(), Vec3(9, 9, 9));
  for (Index& corner : mesh.corners) ++corner;
  const CageResult result = make_cage(mesh);
  REQUIRE(codes(result.warnings) == Codes{"W_LOOSE_VERTEX"});
  CHECK(result.warnings[0].subjects[0].index == 0);
  std::vector<Index> sources(8);
  std::iota(sources.begin(), sources.end(), Index{1});
  CHECK(result.cage.source_vertex == sources);
  CHECK(fault(result.cage.topology) == "");
}

TEST_CASE("a tag that is no edge or no sharpness is refused by name, the others are kept") {
  PolyMesh mesh = bolt_loop();
  mesh.tags.creases.push_back({{0, 2}, 1});
  mesh.tags.creases.push_back({{3, 500}, 1});
  mesh.tags.creases.push_back({{0, 1}, -1});
  mesh.tags.creases.push_back({{1, 2}, std::nan("")});
  mesh.tags.creases.push_back({{2, 3}, 11});
  mesh.tags.creases.push_back({{3, 0}, 10});
  mesh.tags.creases.push_back({{5, 4}, 0});
  const CageResult result = make_cage(mesh);
  CHECK(codes(result.warnings) == Codes{"W_TAG_NO_EDGE", "W_TAG_NO_EDGE", "W_TAG_SHARPNESS", "W_TAG_SHARPNESS"});
  CHECK(result.warnings[0].message.find("edge (0,2)") != std::string::npos);
  CHECK(result.warnings[1].message.find("edge (3,500)") != std::string::npos);
  CHECK(result.warnings[2].message.find("edge (0,1)") != std::string::npos);
  CHECK(result.warnings[3].message.find("edge (1,2)") != std::string::npos);
  const auto& sharpness = result.cage.sharpness;
  CHECK(std::count(sharpness.begin(), sharpness.end(), infinite_sharpness) == 5);
  CHECK(std::count(sharpness.begin(), sharpness.end(), 10) == 1);
  CHECK(std::count(sharpness.begin(), sharpness.end(), 0) == 22);
}

TEST_CASE("a pin where nothing is sharp is reported") {
  PolyMesh mesh = bolt_loop();
  mesh.tags.pins = {0, 9, 77};
  const CageResult result = make_cage(mesh);
  REQUIRE(codes(result.warnings) == Codes{"W_PIN_NO_EFFECT", "W_PIN_NO_EFFECT"});
  CHECK(result.warnings[0].subjects[0].index == 77);
  CHECK(result.warnings[1].subjects[0].index == 0);
  CHECK(result.cage.pinned[9] == 1);

  // The other schemes hold every pinned vertex.
  const CageResult uniform = make_cage(mesh, {}, CageUse::UniformSchemes);
  REQUIRE(codes(uniform.warnings) == Codes{"W_PIN_NO_EFFECT"});
  CHECK(uniform.warnings[0].subjects[0].index == 77);
}

TEST_CASE("a tag that stands alone and retracts is reported, unless its ends hold it") {
  PolyMesh mesh = tagged(bolt(), std::array<VertexPair, 1>{{{8, 9}}});
  CHECK(codes(make_cage(mesh, Rules::of(Preset::Paper)).warnings) == Codes{"W_TAG_VANISHES"});
  CHECK(codes(make_cage(mesh, Rules::of(Preset::Refined)).warnings).empty());
  CHECK(codes(make_cage(mesh, Rules::of(Preset::Paper), CageUse::UniformSchemes).warnings).empty());
  mesh.tags.pins = {8};
  CHECK(codes(make_cage(mesh, Rules::of(Preset::Paper)).warnings).empty());
  CHECK(codes(make_cage(bolt_open_chain(), Rules::of(Preset::Paper)).warnings).empty());
}

TEST_CASE("a face far from convex is reported") {
  PolyMesh mesh;
  for (const Vec3& p : {Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(4, 4, 0), Vec3(1, 3, 0)}) mesh.positions.push_back(p);
  mesh.add_face(std::array<Index, 4>{0, 1, 2, 3});
  CHECK(codes(make_cage(mesh).warnings).empty());
  mesh.positions[3] = Vec3(3, 1.5, 0);
  CHECK(codes(make_cage(mesh).warnings) == Codes{"W_MAY_FOLD"});
}

TEST_CASE("coincident vertices and edges without length are no obstacle") {
  PolyMesh mesh = bolt_loop();
  mesh.positions[9] = mesh.positions[8];
  mesh.positions[1] = mesh.positions[2] = mesh.positions[0];
  const Subdivided result = subdivide(mesh, 3);
  CHECK(counts(result.topology(3)) == Counts{672, 1344, 674});
  for (const Vec3& point : result.points(3)) CHECK(point.allFinite());
}

TEST_CASE("hundreds of like findings are counted, not listed") {
  PolyMesh mesh = cube();
  for (int i = 0; i < 250; ++i) mesh.positions.emplace_back(i, 0, 0);
  const CageResult result = make_cage(mesh);
  CHECK(result.warnings.size() == 100);
  CHECK(result.warnings.back().message.find("150 more") != std::string::npos);
}

}  // namespace
}  // namespace croquis::test
