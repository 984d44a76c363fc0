// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstring>

#include <catch2/catch.hpp>

#include "io/mesh_compare.h"
#include "support/meshes/mesh_shapes.h"

using namespace croquis;
using namespace croquis::test;

namespace {

const std::string facet =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";

PolyMesh mesh_of(const std::string& bytes) { return read(bytes, MeshFormat::Stl).mesh; }

// A binary file of one triangle with that title.
std::string binary_triangle(const std::string& title) {
  PolyMesh mesh;
  mesh.positions = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  mesh.add_triangle(0, 1, 2);
  std::string bytes = write(mesh, MeshFormat::Stl).bytes;
  bytes.replace(0, title.size(), title);
  return bytes;
}

}  // namespace

TEST_CASE("equal corners of STL facets are joined, in both encodings") {
  for (const PolyMesh& shape : {cube(), uv_sphere(12, 7), torus(8, 6), moebius(9), double_torus()}) {
    for (const bool ascii : {false, true}) {
      const PolyMesh back = mesh_of(write(shape, MeshFormat::Stl, {0, ascii}).bytes);
      CHECK(back.vertex_count() == shape.vertex_count());
      std::size_t triangles = 0;
      for (std::size_t f = 0; f < shape.face_count(); ++f) triangles += shape.face(f).size() - 2;
      CHECK(back.face_count() == triangles);
      CHECK(same_connectivity(mesh_of(write(back, MeshFormat::Stl, {0, ascii}).bytes), back));
    }
  }
}

TEST_CASE("0 and -0 are the same coordinate where STL corners are joined") {
  std::string text = facet;
  text.replace(text.find("vertex 0 0 0"), 12, "vertex -0 0 -0");
  CHECK(mesh_of("solid\n" + facet + text + "endsolid\n").vertex_count() == 3);
}

TEST_CASE("a binary STL whose title begins with solid is read as binary") {
  for (const std::string title : {"solid", "solid name\nfacet normal 0 0 1\nouter loop\n"}) {
    const PolyMesh mesh = mesh_of(binary_triangle(title));
    CHECK(mesh.face_count() == 1);
    CHECK(mesh.vertex_count() == 3);
  }
}

TEST_CASE("STL attribute bytes are kept in binary and lost in text with a warning") {
  std::string bytes = binary_triangle("x");
  bytes[bytes.size() - 2] = 0x34;
  bytes[bytes.size() - 1] = 0x12;
  const PolyMesh mesh = mesh_of(bytes);
  const AttributeChannel* attribute = mesh.channel("attribute", Domain::Face);
  REQUIRE(attribute != nullptr);
  CHECK(std::get<std::vector<std::uint16_t>>(attribute->data) == std::vector<std::uint16_t>{0x1234});
  const MeshWriteResult binary = write(mesh, MeshFormat::Stl);
  CHECK(binary.warnings.empty());
  CHECK(difference(mesh_of(binary.bytes), mesh) == "");
  CHECK_THAT(write(mesh, MeshFormat::Stl, {0, true}).warnings.at(0).message, Catch::Contains("'attribute'"));
}

TEST_CASE("the solids of a text STL are objects") {
  const std::string text = "solid left part\n" + facet + "endsolid left part\nsolid\n" + facet + "endsolid\nSOLID b\n" +
                           facet + "EndSolid b\n";
  const PolyMesh mesh = mesh_of(text);
  const AttributeChannel* objects = mesh.channel("object", Domain::Face);
  REQUIRE(objects != nullptr);
  CHECK(objects->labels == std::vector<std::string>{"left part", "b"});
  CHECK(std::get<std::vector<std::int32_t>>(objects->data) == std::vector<std::int32_t>{0, -1, 1});
  CHECK(difference(mesh_of(write(mesh, MeshFormat::Stl, {0, true}).bytes), mesh) == "");
  CHECK_THAT(write(mesh, MeshFormat::Stl).warnings.at(0).message, Catch::Contains("names of objects"));
}

TEST_CASE("polygons are cut for STL without folding at a reflex corner") {
  PolyMesh arrow;  // the fan from its first corner would leave the polygon
  arrow.positions = {Vec3(0, 0, 0), Vec3(2, 2, 0), Vec3(0, 0.5, 0), Vec3(-2, 2, 0)};
  arrow.add_face(std::array<Index, 4>{1, 2, 3, 0});
  const PolyMesh back = mesh_of(write(arrow, MeshFormat::Stl).bytes);
  REQUIRE(back.face_count() == 2);
  for (std::size_t f = 0; f < 2; ++f) {
    const auto t = back.face(f);
    const Vec3 &a = back.positions[t[0]], &b = back.positions[t[1]], &c = back.positions[t[2]];
    CHECK((b - a).cross(c - a).z() > 0);
  }
}

TEST_CASE("writing STL says what it can't hold") {
  CHECK(write(cube(), MeshFormat::Stl).warnings.at(0).code == "W_FORMAT_LOSS");
  CHECK_THAT(write(cube(), MeshFormat::Stl).warnings.at(0).message, Catch::Contains("polygons"));
  CHECK_THAT(write(scaled(tetrahedron(), 0.1), MeshFormat::Stl).warnings.at(0).message, !Catch::Contains("32-bit"));
  PolyMesh single;
  single.positions = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  single.add_triangle(0, 1, 2);
  CHECK(write(single, MeshFormat::Stl).warnings.empty());
  CHECK(write(flipped(single), MeshFormat::Stl).warnings.size() == 1);
}

TEST_CASE("points alone are refused when writing STL, which could hold nothing of them") {
  PolyMesh points;
  points.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  MeshWriteOptions options;
  options.ascii = GENERATE(false, true);
  Progress progress;
  try {
    write_mesh(points, MeshFormat::Stl, options, progress);
    FAIL("it was written");
  } catch (const Error& error) {
    CHECK(error.findings()[0].code == "E_NO_FACES");
    CHECK(error.findings()[0].category == Category::Geometry);
  }
}

TEST_CASE("coordinates beyond 32-bit numbers are refused when writing STL and GLB") {
  for (const MeshFormat format : {MeshFormat::Stl, MeshFormat::Glb}) {
    try {
      write(scaled(cube(), 1e39), format);
      FAIL("it was written");
    } catch (const Error& error) {
      CHECK(error.findings()[0].code == "E_OUT_OF_RANGE");
      CHECK(error.findings()[0].category == Category::Geometry);
    }
  }
}

TEST_CASE("each damage of a text STL is refused with its code and line") {
  struct Case {
    std::string text, code;
    std::int64_t line;
  };
  const auto changed = [](const std::string& from, const std::string& to) {
    std::string text = "solid a\n" + facet + "endsolid a\n";
    return text.replace(text.find(from), from.size(), to);
  };
  const std::vector<Case> cases = {
      {changed("endsolid a\n", ""), "E_TRUNCATED", 8},
      {changed("endfacet\nendsolid a\n", ""), "E_TRUNCATED", 7},
      {changed("endfacet", "endface"), "E_SYNTAX", 8},
      {changed("vertex 1 0 0", "vertex 1 0 x"), "E_SYNTAX", 5},
      {changed("vertex 1 0 0", "vertex 1 0"), "E_SYNTAX", 6},
      {changed("vertex 1 0 0", "vertex 1 0 nan"), "E_NOT_FINITE", 5},
      {changed("vertex 1 0 0\n", ""), "E_FACE_DEGENERATE", 7},
      {changed("vertex 1 0 0\n", "vertex 1 0 0\nvertex 1 1 0\n"), "E_COUNT", 9},
      {changed("outer", "inner"), "E_SYNTAX", 3},
      {changed("endsolid a\n", "endsolid a\ngarbage\n"), "E_SYNTAX", 10},
  };
  for (const Case& c : cases) {
    INFO(c.text);
    const Findings findings = refusal(c.text, MeshFormat::Stl);
    CHECK(findings[0].code == c.code);
    CHECK(findings[0].subjects.at(0).line == c.line);
  }
  CHECK(refusal("solid a\nendsolid a\n", MeshFormat::Stl)[0].code == "E_NO_FACES");
}

TEST_CASE("a binary STL with a wrong count is refused, and one cut anywhere too") {
  const std::string bytes = write(tetrahedron(), MeshFormat::Stl).bytes;
  for (std::size_t size = 1; size < bytes.size(); ++size) {
    CHECK(refusal(bytes.substr(0, size), MeshFormat::Stl)[0].code == "E_TRUNCATED");
  }
  std::string fewer = bytes, more = bytes, cursed = bytes;
  fewer[80] = 3;
  CHECK(refusal(fewer, MeshFormat::Stl)[0].code == "E_COUNT");
  more[83] = 0x7f;
  CHECK(refusal(more, MeshFormat::Stl)[0].code == "E_TRUNCATED");
  const std::uint32_t nan = 0x7fc00000;
  std::memcpy(cursed.data() + 84 + 50 + 12, &nan, 4);
  const Findings findings = refusal(cursed, MeshFormat::Stl);
  CHECK(findings[0].code == "E_NOT_FINITE");
  CHECK_THAT(findings[0].message, Catch::Contains("byte 134"));
  CHECK(read(bytes + "end", MeshFormat::Stl).warnings.at(0).code == "W_TRAILING");
}
