// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <catch2/catch.hpp>

#include "io/mesh_compare.h"
#include "support/meshes/mesh_shapes.h"

using namespace croquis;
using namespace croquis::test;

namespace {

const std::string rows = "0 0 0\n1 0 0\n0 1 0\n";

PolyMesh mesh_of(const std::string& bytes) { return read(bytes, MeshFormat::Off).mesh; }

template <typename T>
std::vector<T> values_of(const PolyMesh& mesh, const char* name, Domain domain) {
  const AttributeChannel* channel = mesh.channel(name, domain);
  REQUIRE(channel != nullptr);
  return std::get<std::vector<T>>(channel->data);
}

}  // namespace

TEST_CASE("OFF counts may stand on the first line or the next, with or without edges, between comments") {
  for (const std::string start : {"OFF\n3 1 0\n", "OFF 3 1 0\n", "# made\n\nOFF # keyword\n\n# counts\n3 1\n",
                                  "OFF\r\n3 1 3\r\n", "  OFF\n\t3 1 0\n"}) {
    INFO(start);
    const PolyMesh mesh = mesh_of(start + "0 0 0 # first\n\n1 0 0\n0 1 0\n3 0 1 2\n# end\n");
    CHECK(mesh.vertex_count() == 3);
    CHECK(mesh.corners == std::vector<Index>{0, 1, 2});
  }
}

TEST_CASE("OFF vertices carry normals, colours and texture coordinates in that order") {
  const PolyMesh mesh = mesh_of(
      "STCNOFF\n3 1 0\n0 0 0 0 0 1 255 0 10 128 0.5 0.25\n1 0 0 0 0 1 1 2 3 4 1 0\n0 1 0 0 0 1 5 6 7 8 0 1\n3 0 1 2\n");
  CHECK(values_of<double>(mesh, "normal", Domain::Vertex) == std::vector<double>{0, 0, 1, 0, 0, 1, 0, 0, 1});
  CHECK(values_of<std::uint8_t>(mesh, "color", Domain::Vertex) ==
        std::vector<std::uint8_t>{255, 0, 10, 128, 1, 2, 3, 4, 5, 6, 7, 8});
  CHECK(values_of<double>(mesh, "uv", Domain::Vertex) == std::vector<double>{0.5, 0.25, 1, 0, 0, 1});
  const MeshWriteResult written = write(mesh, MeshFormat::Off);
  CHECK(written.warnings.empty());
  CHECK(difference(mesh_of(written.bytes), mesh) == "");
}

TEST_CASE("OFF face colours are bytes or numbers up to one, and faces may lack them") {
  const std::string start = "OFF\n3 2 0\n" + rows;
  CHECK(values_of<std::uint8_t>(mesh_of(start + "3 0 1 2 1 0 1\n3 0 2 1 255 128 0\n"), "color", Domain::Face) ==
        std::vector<std::uint8_t>{1, 0, 1, 255, 128, 0});
  CHECK(values_of<double>(mesh_of(start + "3 0 1 2 1.0 0 0.5\n3 0 2 1 0 0 0 0.25\n"), "color", Domain::Face) ==
        std::vector<double>{1, 0, 0.5, 1, 0, 0, 0, 0.25});
  const PolyMesh partial = mesh_of(start + "3 0 1 2\n3 0 2 1 51 0 255\n");
  const auto values = values_of<double>(partial, "color", Domain::Face);
  CHECK(std::isnan(values[0]));
  CHECK(values[3] == 0.2);
  CHECK(difference(mesh_of(write(partial, MeshFormat::Off).bytes), partial) == "");
  CHECK(read(start + "3 0 1 2 7\n3 0 2 1 8\n", MeshFormat::Off).warnings.at(0).code == "W_IGNORED");
}

TEST_CASE("vertex colours are understood without the C in the first line") {
  const PolyMesh mesh = mesh_of("OFF\n3 1 0\n0 0 0 1 2 3\n1 0 0 4 5 6\n0 1 0 7 8 9\n3 0 1 2\n");
  CHECK(values_of<std::uint8_t>(mesh, "color", Domain::Vertex) == std::vector<std::uint8_t>{1, 2, 3, 4, 5, 6, 7, 8, 9});
}

TEST_CASE("dark byte colours are not mistaken for numbers up to one, nor bright numbers for bytes") {
  PolyMesh mesh = tetrahedron();
  mesh.channels = {{"color", Domain::Vertex, 3, std::vector<std::uint8_t>(12, 1), {}},
                   {"color", Domain::Face, 3, std::vector<double>(12, 1.0), {}}};
  CHECK(difference(mesh_of(write(mesh, MeshFormat::Off).bytes), mesh) == "");
}

TEST_CASE("each damage of an OFF is refused with its code and line") {
  struct Case {
    std::string text, code;
    std::int64_t line;
  };
  const std::vector<Case> cases = {
      {"# nothing\n", "E_EMPTY", 1},
      {"OFX\n3 1 0\n" + rows + "3 0 1 2\n", "E_SYNTAX", 1},
      {"4OFF\n3 1 0\n" + rows + "3 0 1 2\n", "E_SYNTAX", 1},
      {"OFF BINARY\n", "E_SYNTAX", 1},
      {"OFF\n", "E_TRUNCATED", 1},
      {"OFF\n3\n" + rows, "E_COUNT", 2},
      {"OFF\n3 -1 0\n" + rows, "E_COUNT", 2},
      {"OFF\n3 one 0\n" + rows, "E_COUNT", 2},
      {"OFF\n3 1 0 0\n" + rows, "E_COUNT", 2},
      {"OFF\n4000000000 1 0\n" + rows, "E_TRUNCATED", 2},
      {"OFF\n3 18446744073709551615 0\n" + rows, "E_TRUNCATED", 2},
      {"OFF\n3 2 0\n" + rows + "3 0 1 2\n", "E_TRUNCATED", 6},
      {"OFF\n3 1 0\n0 0 0\n1 0 0\n", "E_TRUNCATED", 2},
      {"OFF\n3 1 0\n" + rows + "3 0 1 2\n3 0 1 2\n", "E_COUNT", 7},
      {"OFF\n3 1 0\n" + rows + "3 0 1 3\n", "E_INDEX", 6},
      {"OFF\n3 1 0\n" + rows + "3 0 1 -1\n", "E_INDEX", 6},
      {"OFF\n3 1 0\n" + rows + "3 0 1 x\n", "E_SYNTAX", 6},
      {"OFF\n3 1 0\n" + rows + "3 0 1\n", "E_COUNT", 6},
      {"OFF\n3 1 0\n" + rows + "99999999999 0 1 2\n", "E_COUNT", 6},
      {"OFF\n3 1 0\n" + rows + "3 0 1 2 9 9\n", "E_COUNT", 6},
      {"OFF\n3 1 0\n" + rows + "2 0 1\n", "E_FACE_DEGENERATE", 6},
      {"OFF\n3 1 0\n0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "E_COUNT", 3},
      {"OFF\n3 1 0\n0 0 x\n1 0 0\n0 1 0\n3 0 1 2\n", "E_SYNTAX", 3},
      {"OFF\n3 1 0\n0 0 inf\n1 0 0\n0 1 0\n3 0 1 2\n", "E_NOT_FINITE", 3},
      {"COFF\n3 1 0\n0 0 0 1 2 x\n1 0 0\n0 1 0\n3 0 1 2\n", "E_SYNTAX", 3},
  };
  for (const Case& c : cases) {
    INFO(c.text);
    const Findings findings = refusal(c.text, MeshFormat::Off);
    REQUIRE(findings.size() == 1);
    CHECK(findings[0].code == c.code);
    CHECK(findings[0].subjects.at(0).line == c.line);
  }
}
