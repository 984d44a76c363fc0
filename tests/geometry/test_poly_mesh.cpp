// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>
#include <string>

#include <catch2/catch.hpp>

#include "croquis/geometry/poly_mesh.h"
#include "support/meshes/mesh_shapes.h"

using namespace croquis;
using namespace croquis::test;

namespace {

std::size_t count_code(const Findings& findings, const std::string& code) {
  return static_cast<std::size_t>(
      std::count_if(findings.begin(), findings.end(), [&](const Finding& finding) { return finding.code == code; }));
}

}  // namespace

TEST_CASE("sound meshes have no findings") {
  CHECK(validate(PolyMesh{}).empty());
  CHECK(validate(tetrahedron()).empty());
  CHECK(validate(uv_sphere(7, 5)).empty());
  CHECK(validate(torus(5, 4)).empty());
  CHECK(validate(tetrahedra_sharing_edge()).empty());
  CHECK(validate(moebius(5)).empty());
  CHECK(validate(random_soup(1, 20)).empty());
}

TEST_CASE("every broken element is named, whatever its kind") {
  PolyMesh mesh = tetrahedron();
  mesh.positions[2].y() = std::numeric_limits<double>::quiet_NaN();
  mesh.positions[3].z() = std::numeric_limits<double>::infinity();
  mesh.corners[1] = 17;
  mesh.add_triangle(0, 1, 0);
  mesh.add_face(std::array<Index, 2>{0, 1});
  mesh.add_line(std::array<Index, 2>{0, 9});
  mesh.channels.push_back({"color", Domain::Vertex, 3, std::vector<float>(11), {}});
  const Findings findings = validate(mesh);
  CHECK(count_code(findings, "E_NOT_FINITE") == 2);
  CHECK(count_code(findings, "E_INDEX") == 2);
  CHECK(count_code(findings, "E_FACE_DEGENERATE") == 2);
  CHECK(count_code(findings, "E_COUNT") == 1);
  CHECK(findings.size() == 7);
  for (const Finding& finding : findings) {
    CHECK(finding.severity == Severity::Error);
    CHECK(finding.category == Category::Malformed);
    CHECK(finding.message.back() == '.');
    REQUIRE(finding.subjects.size() == 1);
  }
  const auto of_line = std::find_if(findings.begin(), findings.end(),
                                    [](const Finding& f) { return f.subjects[0].kind == SubjectKind::Line; });
  REQUIRE(of_line != findings.end());
  CHECK(of_line->subjects[0].index == 0);
  CHECK(of_line->message.find("vertex 9") != std::string::npos);
}

TEST_CASE("offsets that are missing, descend or end elsewhere are found without reading past the arrays") {
  const std::vector<std::vector<Index>> broken = {{}, {1, 3}, {0, 6, 3, 12}, {0, 3, 6, 9, 4000}, {0, 3}, {12, 0}};
  for (const auto& offsets : broken) {
    PolyMesh mesh = tetrahedron();
    mesh.face_offsets = offsets;
    CHECK(count_code(validate(mesh), "E_INDEX") == 1);
    mesh = tetrahedron();
    mesh.line_vertices.assign(12, 0);
    mesh.line_offsets = offsets;
    CHECK(count_code(validate(mesh), "E_INDEX") == 1);
  }
}

TEST_CASE("of many findings of a kind a hundred are listed and the last tells how many more there are") {
  PolyMesh mesh;
  mesh.positions.assign(357, Vec3::Constant(std::numeric_limits<double>::infinity()));
  Findings findings = validate(mesh);
  REQUIRE(findings.size() == 100);
  CHECK(findings[98].message.find("more") == std::string::npos);
  CHECK(findings[99].message.find("257 more") != std::string::npos);
  mesh.positions.resize(100);
  findings = validate(mesh);
  REQUIRE(findings.size() == 100);
  CHECK(findings[99].message.find("more") == std::string::npos);
}

TEST_CASE("a channel without a width is refused even when it is empty") {
  PolyMesh mesh = tetrahedron();
  mesh.channels.push_back({"empty", Domain::Line, 0, std::vector<double>{}, {}});
  CHECK(count_code(validate(mesh), "E_COUNT") == 1);
}
