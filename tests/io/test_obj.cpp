// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <catch2/catch.hpp>

#include "io/mesh_compare.h"

using namespace croquis;
using namespace croquis::test;

namespace {

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

PolyMesh mesh_of(const std::string& text) { return read(text, MeshFormat::Obj).mesh; }

std::vector<Index> face_of(const PolyMesh& mesh, std::size_t f) { return {mesh.face(f).begin(), mesh.face(f).end()}; }

std::vector<std::string> labels_per_element(const PolyMesh& mesh, const char* name, Domain domain) {
  const AttributeChannel* channel = mesh.channel(name, domain);
  REQUIRE(channel != nullptr);
  std::vector<std::string> labels;
  for (const std::int32_t value : std::get<std::vector<std::int32_t>>(channel->data)) {
    labels.push_back(value < 0 ? "" : channel->labels.at(static_cast<std::size_t>(value)));
  }
  return labels;
}

struct DamagedObj {
  std::string text, code;
  std::int64_t line;
};

void check_refusals(const std::vector<DamagedObj>& cases) {
  for (const DamagedObj& c : cases) {
    INFO(c.text);
    const Findings findings = refusal(c.text, MeshFormat::Obj);
    REQUIRE(findings.size() == 1);
    CHECK(findings[0].code == c.code);
    CHECK(findings[0].category == Category::Malformed);
    CHECK(findings[0].subjects.at(0).line == c.line);
    CHECK(findings[0].subjects.at(0).id == "file");
    CHECK_THAT(findings[0].message, Catch::StartsWith("'file', line " + std::to_string(c.line)));
  }
}

}  // namespace

TEST_CASE("OBJ faces are understood in every form of reference") {
  const std::string tables = "vt 0 0\nvt 1 0\nvn 0 0 1\n";
  for (const std::string face :
       {"f 1 2 3 4", "f 1/1 2/2 3/1 4/2", "f 1//1 2//1 3//1 4//1", "f 1/1/1 2/2/1 3/1/1 4/2/1", "f -4 -3 -2 -1",
        "f -4/-2/-1 -3/-1/-1 -2/-1/-1 -1/-2/-1", "f 1// 2/ 3 4//", "f 1 2 \\\n 3 4 # all four", "f\t+1 2\t3 4\r"}) {
    INFO(face);
    const PolyMesh mesh = mesh_of(square + tables + face + "\n");
    REQUIRE(mesh.face_count() == 1);
    CHECK(face_of(mesh, 0) == std::vector<Index>{0, 1, 2, 3});
  }
}

TEST_CASE("an OBJ reads the same with any ends of lines, and without the last one") {
  const std::string text = square + "f 1 2 3\nf 1 3 4";
  std::string returns, both;
  for (const char c : text) {
    returns += c == '\n' ? '\r' : c;
    both += c == '\n' ? std::string("\r\n") : std::string(1, c);
  }
  const PolyMesh mesh = mesh_of(text);
  CHECK(difference(mesh_of(returns), mesh) == "");
  CHECK(difference(mesh_of(both), mesh) == "");
  CHECK(difference(mesh_of(text + "\n"), mesh) == "");
}

TEST_CASE("OBJ faces may stand before their vertices, where the indices are absolute") {
  CHECK(face_of(mesh_of("f 1 2 3\n" + square), 0) == std::vector<Index>{0, 1, 2});
  const Findings findings = refusal("f 1 2 5\nf -1 1 2\n" + square, MeshFormat::Obj);
  REQUIRE(findings.size() == 2);
  CHECK(findings[0].subjects.front().line == 2);
  CHECK(findings[1].subjects.front().line == 1);
}

TEST_CASE("groups, objects, materials and smoothing groups are kept per face and per line") {
  const PolyMesh mesh = mesh_of(square +
                                "f 1 2 3\no box\ng left side\nf 1 2 4\nusemtl red\ns 3\nf 2 3 4\n"
                                "g right\ns off\nf 1 3 4\ng left side\no wire\nl 1 2 3\n");
  using Labels = std::vector<std::string>;
  CHECK(labels_per_element(mesh, "group", Domain::Face) == Labels{"", "left side", "left side", "right"});
  CHECK(labels_per_element(mesh, "object", Domain::Face) == Labels{"", "box", "box", "box"});
  CHECK(labels_per_element(mesh, "material", Domain::Face) == Labels{"", "", "red", "red"});
  CHECK(labels_per_element(mesh, "object", Domain::Line) == Labels{"wire"});
  CHECK(labels_per_element(mesh, "group", Domain::Line) == Labels{"left side"});
  const auto* smoothing = mesh.channel("smoothing_group", Domain::Face);
  REQUIRE(smoothing != nullptr);
  CHECK(std::get<std::vector<std::int32_t>>(smoothing->data) == std::vector<std::int32_t>{0, 0, 3, 0});
  CHECK(difference(mesh_of(write(mesh, MeshFormat::Obj).bytes), mesh) == "");
}

TEST_CASE("a uv seam stays a seam through OBJ and shared vertices stay shared") {
  const std::string text = square +
                           "vt 0 0\nvt 1 0\nvt 1 1\nvt 0.25 0.5\nvn 0 0 1\nvn 1 0 0\n"
                           "f 1/1/1 2/2/1 3/3/2\nf 1/4/1 3/3/2 4/1/1\nf 1 2 4\n";
  const PolyMesh mesh = mesh_of(text);
  CHECK(mesh.vertex_count() == 4);
  const AttributeChannel* uv = mesh.channel("uv", Domain::Corner);
  REQUIRE(uv != nullptr);
  const auto& values = std::get<std::vector<double>>(uv->data);
  CHECK(values[0] == 0);
  CHECK(values[6] == 0.25);
  CHECK(std::isnan(values[12]));
  const MeshWriteResult written = write(mesh, MeshFormat::Obj);
  CHECK(written.warnings.empty());
  CHECK(difference(mesh_of(written.bytes), mesh) == "");
}

TEST_CASE("OBJ normals and uv that follow the vertices belong to the vertices") {
  const PolyMesh mesh = mesh_of(
      "v 0 0 0\nvt 0 0 0.5\nvn 0 0 1\nv 1 0 0\nvt 1 0 0\nvn 0 1 0\nv 0 1 0\nvt 0 1 0\n"
      "vn 1 0 0\nf 1/1/1 2/2/2 3/3/3\n");
  REQUIRE(mesh.channel("normal", Domain::Vertex) != nullptr);
  REQUIRE(mesh.channel("uv", Domain::Vertex) != nullptr);
  CHECK(mesh.channel("uv", Domain::Vertex)->width == 3);
  CHECK(difference(mesh_of(write(mesh, MeshFormat::Obj).bytes), mesh) == "");
}

TEST_CASE("OBJ vertex colours are kept, also where some vertices have none") {
  const PolyMesh mesh = mesh_of("v 0 0 0 1 0.5 0.1\nv 1 0 0\nv 0 1 0 0 0 0\nf 1 2 3\n");
  const AttributeChannel* colour = mesh.channel("color", Domain::Vertex);
  REQUIRE(colour != nullptr);
  CHECK(std::get<std::vector<double>>(colour->data)[1] == 0.5);
  CHECK(std::isnan(std::get<std::vector<double>>(colour->data)[3]));
  CHECK(difference(mesh_of(write(mesh, MeshFormat::Obj).bytes), mesh) == "");
  const PolyMesh clear = mesh_of("v 0 0 0 1 0.5 0.1 0.3\nv 1 0 0 0 0 0 1\nv 0 1 0 0 0 0 1\nf 1 2 3\n");
  CHECK(clear.channel("color", Domain::Vertex)->width == 4);
  CHECK(difference(mesh_of(write(clear, MeshFormat::Obj).bytes), clear) == "");
}

TEST_CASE("polylines alone are a mesh where faces are not asked for") {
  const std::string text = square + "o a\nl 1 2 3\no b\nl -1 -2\n";
  CHECK(refusal(text, MeshFormat::Obj).front().code == "E_NO_FACES");
  Progress progress;
  const PolyMesh mesh = read_mesh({text, MeshFormat::Obj, "file", false}, progress).mesh;
  REQUIRE(mesh.line_count() == 2);
  CHECK(std::vector<Index>(mesh.line(1).begin(), mesh.line(1).end()) == std::vector<Index>{3, 2});
}

TEST_CASE("OBJ statements that a mesh can't hold are passed over with one warning each") {
  const MeshReadResult result =
      read("mtllib a.mtl\n" + square + "p 1\np 2\nf 1 2 3\nt hole 1/0/0 0\nt creasemethod 0/0/1 chaikin\nlod 1\n",
           MeshFormat::Obj);
  REQUIRE(result.warnings.size() == 5);
  for (const Finding& warning : result.warnings) CHECK(warning.code == "W_IGNORED");
  CHECK_THAT(result.warnings[4].message, Catch::Contains("'t hole'") && Catch::Contains("line 9"));
}

TEST_CASE("tags for subdivision are read as OpenSubdiv writes them, many at once too") {
  const auto tags_of = [](const std::string& tags) { return mesh_of(tags + square + "f 1 2 3 4\n").tags; };
  const Crease inf{{0, 1}, infinite_sharpness}, soft{{2, 1}, 2.5};
  CHECK(tags_of("t crease 2/1/0 0 1 10\nt crease 2/1/0 2 1 2.5\n") == MeshTags{{inf, soft}, {}, {}});
  CHECK(tags_of("t crease 4/2/0 0 1 2 1 11 2.5\n") == MeshTags{{inf, soft}, {}, {}});
  CHECK(tags_of("t crease 4/4/1 0 1 2 1 inf 7 2.5 7 smooth # of edges\n") == MeshTags{{inf, soft}, {}, {}});
  CHECK(tags_of("t crease 4/1/0 0 1 2 1 10.0\n").creases[1].sharpness == infinite_sharpness);
  CHECK(tags_of("t corner 1/1/0 3 10\nt corner 2/2/0 0 2 10 99\n") == MeshTags{{}, {3, 0, 2}, {}});
  CHECK(tags_of("t crease 2/1/0 0 2 0.5\nt crease 2/1/0 7 4294967295 -1\n") ==
        MeshTags{{{{0, 2}, 0.5}, {{7, no_index}, -1}}, {}, {}});
}

TEST_CASE("a corner that isn't infinitely sharp becomes a pin with a warning") {
  const MeshReadResult result =
      read(square + "f 1 2 3\nt corner 1/1/0 3 2.8\nt corner 1/1/0 1 0\nt corner 1/1/0 2 nan\n", MeshFormat::Obj);
  CHECK(result.mesh.tags.pins == std::vector<Index>{3});
  REQUIRE(result.warnings.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(result.warnings[i].code == "W_TAG_SHARPNESS");
    CHECK(result.warnings[i].subjects.at(0).line == static_cast<std::int64_t>(6 + i));
  }
  CHECK_THAT(result.warnings[0].message, Catch::Contains("vertex 3 has the sharpness 2.8"));
}

TEST_CASE("settled corners come back from OBJ, and those of no vertex are refused") {
  PolyMesh mesh = mesh_of(square + "f 1 2 3 4\n");
  mesh.channels.push_back({"settled_corner", Domain::Vertex, 1, std::vector<std::uint8_t>{0, 1, 0, 1}, {}});
  const MeshWriteResult written = write(mesh, MeshFormat::Obj);
  CHECK(written.warnings.empty());
  CHECK(difference(mesh_of(written.bytes), mesh) == "");
  CHECK(difference(mesh_of("t settled 2/0/0 3 1\n" + square + "f 1 2 3 4\n"), mesh) == "");
  const Findings findings = refusal("t settled 2/0/0 3 4\n" + square + "f 1 2 3 4\n", MeshFormat::Obj);
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].code == "E_INDEX");
  CHECK(findings[0].subjects.at(0).line == 1);
}

TEST_CASE("tags come back from OBJ the same, but for their sets") {
  PolyMesh mesh = mesh_of(square + "f 1 2 3 4\n");
  mesh.tags.creases = {{{3, 2}, 0.1},          {{0, 1}, infinite_sharpness}, {{0, 9}, 1e-3},
                       {{1, 2}, std::nan("")}, {{2, 0}, 9.999999999999998},  {{1, 1}, -4}};
  mesh.tags.pins = {2, 0, 77};
  const MeshWriteResult written = write(mesh, MeshFormat::Obj);
  CHECK(written.warnings.empty());
  CHECK_THAT(written.bytes, Catch::Contains("t crease 2/1/0 3 2 0.1\nt crease 2/1/0 0 1 10\n") &&
                                Catch::Contains("t corner 1/1/0 2 10\nt corner 1/1/0 0 10\n"));
  CHECK(difference(mesh_of(written.bytes), mesh) == "");
  mesh.tags.sets = {{"rim", 3, {{2, 3}}, {}}};
  const Findings loss = write(mesh, MeshFormat::Obj).warnings;
  REQUIRE(loss.size() == 1);
  CHECK_THAT(loss[0].message, Catch::Contains("'rim'"));
  mesh.tags.creases[0].sharpness = 12;
  CHECK(mesh_of(write(mesh, MeshFormat::Obj).bytes).tags.creases[0].sharpness == infinite_sharpness);
}

TEST_CASE("each damage of an OBJ's faces and lines is refused with its code and line") {
  check_refusals({
      {square + "f 1 2 5\n", "E_INDEX", 5},
      {square + "f 1 2 0\n", "E_INDEX", 5},
      {square + "f 1 2 -5\n", "E_INDEX", 5},
      {square + "f 1 2 99999999999\n", "E_INDEX", 5},
      {square + "f 1/1 2 3\n", "E_INDEX", 5},
      {square + "f 1//2 2 3\nvn 0 0 1\n", "E_INDEX", 5},
      {square + "l 1 7\n", "E_INDEX", 5},
      {square + "f 1 2\n", "E_FACE_DEGENERATE", 5},
      {square + "f\n", "E_FACE_DEGENERATE", 5},
      {square + "l 1\n", "E_SYNTAX", 5},
      {square + "f 1 2 x\n", "E_SYNTAX", 5},
      {square + "f 1 2 3/1/1/1\n", "E_SYNTAX", 5},
      {square + "f 1 2 /3\n", "E_SYNTAX", 5},
      {square + "f 1 2 99999999999999999999\n", "E_SYNTAX", 5},
  });
}

TEST_CASE("each damage of an OBJ's vertices and statements is refused with its code and line") {
  check_refusals({
      {"v 0 0\n" + square + "f 1 2 3\n", "E_SYNTAX", 1},
      {"v 0 0 zero\n" + square + "f 1 2 3\n", "E_SYNTAX", 1},
      {"v 0 0 0 0 0\n" + square + "f 1 2 3\n", "E_SYNTAX", 1},
      {"v 0 0 0 0 0 0 0 0\n" + square + "f 1 2 3\n", "E_SYNTAX", 1},
      {"vn 1 0\n" + square + "f 1 2 3\n", "E_SYNTAX", 1},
      {"vt\n" + square + "f 1 2 3\n", "E_SYNTAX", 1},
      {"s many\n" + square + "f 1 2 3\n", "E_SYNTAX", 1},
      {"hello world\n" + square + "f 1 2 3\n", "E_SYNTAX", 1},
      {"v nan 0 0\n" + square + "f 1 2 3\n", "E_NOT_FINITE", 1},
      {"v 0 -inf 0\n" + square + "f 1 2 3\n", "E_NOT_FINITE", 1},
      {"v 0 0 1e999\n" + square + "f 1 2 3\n", "E_NOT_FINITE", 1},
      {"v 0 0 1.#IND\n" + square + "f 1 2 3\n", "E_NOT_FINITE", 1},
  });
}

TEST_CASE("each damage of an OBJ's tags is refused with its code and line") {
  check_refusals({
      {"t\n" + square + "f 1 2 3\n", "E_SYNTAX", 1},
      {"t crease\n" + square + "f 1 2 3\n", "E_SYNTAX", 1},
      {"t crease 0 1 2\n" + square + "f 1 2 3\n", "E_SYNTAX", 1},
      {"t crease 2/1 0 1 2\n" + square + "f 1 2 3\n", "E_SYNTAX", 1},
      {"t crease 2/1/0/0 0 1 2\n" + square + "f 1 2 3\n", "E_SYNTAX", 1},
      {"t crease 2/1/0 0 1\n" + square + "f 1 2 3\n", "E_SYNTAX", 1},
      {"t crease 2/1/0 0 1 2 3\n" + square + "f 1 2 3\n", "E_SYNTAX", 1},
      {"t crease 2/0/0 0 1\n" + square + "f 1 2 3\n", "E_SYNTAX", 1},
      {"t crease 3/1/0 0 1 2 10\n" + square + "f 1 2 3\n", "E_SYNTAX", 1},
      {"t crease 6/2/0 0 1 2 3 0 1 10 10\n" + square + "f 1 2 3\n", "E_SYNTAX", 1},
      {"t crease 2/1/1 0 1 10\n" + square + "f 1 2 3\n", "E_SYNTAX", 1},
      {"t crease 2/1/0 0 -1 2\n" + square + "f 1 2 3\n", "E_SYNTAX", 1},
      {"t crease 2/1/0 0 1.5 2\n" + square + "f 1 2 3\n", "E_SYNTAX", 1},
      {"t crease 2/1/0 0 4294967296 2\n" + square + "f 1 2 3\n", "E_SYNTAX", 1},
      {"t crease 2/1/0 0 1 sharp\n" + square + "f 1 2 3\n", "E_SYNTAX", 1},
      {"t crease 99999999999999/1/0 0 1 2\n" + square + "f 1 2 3\n", "E_SYNTAX", 1},
      {"t corner 0/1/0 10\n" + square + "f 1 2 3\n", "E_SYNTAX", 1},
      {"t corner 1/2/0 0 1 2\n" + square + "f 1 2 3\n", "E_SYNTAX", 1},
  });
}

TEST_CASE("numbers too small for a double are zero, not damage") {
  const PolyMesh mesh = mesh_of("v 1e-999 -1e-400 4e-324\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  CHECK(mesh.positions[0] == Vec3(0, 0, 4e-324));
}
