// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "io/mesh_compare.h"
#include "support/meshes/mesh_shapes.h"

using namespace croquis;
using namespace croquis::test;

namespace {

const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string triangle_rows = "0 0 0\n1 0 0\n0 1 0\n";

std::string header(const std::string& body, const char* format = "ascii") {
  return std::string("ply\nformat ") + format + " 1.0\n" + body + "end_header\n";
}

std::string triangle(const std::string& faces, std::size_t count = 1) {
  return header("element vertex 3\n" + xyz + "element face " + std::to_string(count) +
                "\nproperty list uchar int vertex_indices\n") +
         triangle_rows + faces;
}

PolyMesh mesh_of(const std::string& bytes) { return read(bytes, MeshFormat::Ply).mesh; }

// The same file with every number's bytes turned round: rows of 3 doubles, then faces of uchar and int.
std::string to_big_endian(std::string bytes, std::size_t vertices, std::size_t faces) {
  const std::size_t body = bytes.find("end_header\n") + 11;
  bytes.replace(bytes.find("little"), 6, "big");
  std::size_t at = body - 3;
  const auto turn = [&](std::size_t size) {
    std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(at),
                 bytes.begin() + static_cast<std::ptrdiff_t>(at + size));
    at += size;
  };
  for (std::size_t i = 0; i < 3 * vertices; ++i) turn(8);
  for (std::size_t f = 0; f < faces; ++f) {
    const auto count = static_cast<unsigned char>(bytes[at++]);
    for (unsigned char i = 0; i < count; ++i) turn(4);
  }
  return bytes;
}

}  // namespace

TEST_CASE("PLY keeps every attribute in its own type, as text and as bytes") {
  for (const PolyMesh& shape : {cube(), uv_sphere(7, 5), grid(4, 3)}) {
    const PolyMesh mesh = with_attributes(shape);
    for (const bool ascii : {false, true}) {
      const MeshWriteResult written = write(mesh, MeshFormat::Ply, {0, ascii});
      CHECK(written.warnings.empty());
      CHECK(difference(mesh_of(written.bytes), mesh) == "");
    }
  }
}

TEST_CASE("both byte orders of PLY give the same mesh") {
  const PolyMesh mesh = rotated(torus(9, 5), 0.3, Vec3(1, 2, 3));
  const std::string little = write(mesh, MeshFormat::Ply).bytes;
  const std::string big = to_big_endian(little, mesh.vertex_count(), mesh.face_count());
  REQUIRE(big.find("binary_big_endian") != std::string::npos);
  CHECK(difference(mesh_of(big), mesh) == "");
  CHECK(difference(mesh_of(little), mesh) == "");
}

TEST_CASE("lengths of lists that are whole numbers of four bytes are read in both byte orders") {
  for (const bool big : {false, true}) {
    std::string bytes = header(
        "element vertex 3\nproperty int x\nproperty int y\nproperty int z\nelement face 1\n"
        "property list int int vertex_indices\n",
        big ? "binary_big_endian" : "binary_little_endian");
    for (const char number : std::string("\0\0\0\7\0\0\0\7\0\3\0\1\2", 13)) {
      const std::string zeros(3, '\0');
      bytes += big ? zeros + number : number + zeros;
    }
    const PolyMesh mesh = mesh_of(bytes);
    CHECK(mesh.positions == std::vector<Vec3>{{0, 0, 0}, {7, 0, 0}, {0, 7, 0}});
    REQUIRE(mesh.face_count() == 1);
    CHECK(std::ranges::equal(mesh.face(0), std::vector<Index>{0, 1, 2}));
  }
}

TEST_CASE("all of PLY's types and their aliases are read") {
  const std::vector<std::pair<const char*, const char*>> names = {
      {"char", "int8"}, {"uchar", "uint8"}, {"short", "int16"},   {"ushort", "uint16"},
      {"int", "int32"}, {"uint", "uint32"}, {"float", "float32"}, {"double", "float64"}};
  for (std::size_t i = 0; i < names.size(); ++i) {
    for (const char* name : {names[i].first, names[i].second}) {
      const PolyMesh mesh =
          mesh_of(header("element vertex 3\n" + xyz + "property " + name + " extra\nelement face 1\nproperty list " +
                         (i < 6 ? name : "int") + " " + (i < 6 ? name : "short") + " vertex_index\n") +
                  "0 0 0 7\n1 0 0 8\n0 1 0 9\n3 0 1 2\n");
      const AttributeChannel* extra = mesh.channel("extra", Domain::Vertex);
      REQUIRE(extra != nullptr);
      CHECK(extra->data.index() == i);
      CHECK(mesh.face_count() == 1);
    }
  }
}

TEST_CASE("PLY elements may come in any order and unknown ones are passed over") {
  const MeshReadResult result =
      read(header("comment hello\nobj_info something\nelement face 1\nproperty list uchar int vertex_indices\n"
                  "element camera 2\nproperty float view\nproperty list uchar int seen\nelement vertex 3\n" +
                  xyz + "element nothing 4000000000\n") +
               "3 0 1 2\n1.5 2 4 5\n2.5 0\n" + triangle_rows,
           MeshFormat::Ply);
  CHECK(result.mesh.face_count() == 1);
  CHECK(result.mesh.positions[1] == Vec3(1, 0, 0));
  REQUIRE(result.warnings.size() == 1);
  CHECK_THAT(result.warnings[0].message, Catch::Contains("camera"));
}

TEST_CASE("PLY's names of normals, colours and coordinates become the common channels") {
  const PolyMesh mesh = mesh_of(
      header("element vertex 3\nproperty uchar red\n" + xyz +
             "property uchar green\nproperty uchar blue\nproperty float nx\nproperty float ny\nproperty float nz\n"
             "property float s\nproperty float t\nelement face 1\nproperty list uchar int vertex_indices\n"
             "property list uchar float texcoord\n") +
      "1 0 0 0 2 3 0 0 1 .5 .25\n4 1 0 0 5 6 0 0 1 0 0\n7 0 1 0 8 9 0 0 1 0 0\n3 0 1 2 6 0 .1 .2 .3 .4 .5\n");
  CHECK(std::get<std::vector<std::uint8_t>>(mesh.channel("color", Domain::Vertex)->data) ==
        std::vector<std::uint8_t>{1, 2, 3, 4, 5, 6, 7, 8, 9});
  CHECK(mesh.channel("normal", Domain::Vertex)->width == 3);
  CHECK(mesh.channel("uv", Domain::Vertex)->width == 2);
  CHECK(std::get<std::vector<float>>(mesh.channel("uv", Domain::Corner)->data) ==
        std::vector<float>{0, .1F, .2F, .3F, .4F, .5F});
}

TEST_CASE("triangle strips of scans are expanded with alternating orientation") {
  const PolyMesh mesh =
      mesh_of(header("element vertex 5\n" + xyz + "element tristrips 1\nproperty list int int vertex_indices\n") +
              "0 0 0\n0 1 0\n1 0 0\n1 1 0\n2 0 0\n9 0 2 1 3 -1 2 4 3 3\n");
  CHECK(mesh.corners == std::vector<Index>{0, 2, 1, 1, 2, 3, 2, 4, 3});
}

namespace {

// A view of rows × columns places over z = height(x, y), looked at from above; height NaN: nothing seen there.
template <typename Height>
std::string range_view(int rows, int columns, const Height& height, const std::string& info) {
  std::string vertices, places;
  int count = 0;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const double z = height(column, row);
      places += std::isnan(z) ? "0\n" : "1 " + std::to_string(count) + "\n";
      if (std::isnan(z)) continue;
      ++count;
      // Stanford's first row is the topmost.
      vertices += std::to_string(column) + " " + std::to_string(-row) + " " + std::to_string(z) + "\n";
    }
  }
  return header(info + "element vertex " + std::to_string(count) + "\n" + xyz + "element range_grid " +
                std::to_string(rows * columns) + "\nproperty list uchar int vertex_indices\n") +
         vertices + places;
}

std::string grid_size(int rows, int columns) {
  return "obj_info num_cols " + std::to_string(columns) + "\nobj_info num_rows " + std::to_string(rows) + "\n";
}

constexpr double unseen = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("a range view's grid becomes triangles that look at the scanner") {
  const auto bowl = [](int x, int y) { return 0.05 * (x * x + y * y); };
  const std::string bytes = range_view(5, 7, bowl, grid_size(5, 7));
  const MeshReadResult result = read(bytes, MeshFormat::Ply);
  CHECK(result.warnings.empty());
  REQUIRE(result.mesh.face_count() == 2 * 4 * 6);
  for (std::size_t f = 0; f < result.mesh.face_count(); ++f) {
    const auto face = result.mesh.face(f);
    const Vec3 &a = result.mesh.positions[face[0]], &b = result.mesh.positions[face[1]];
    CHECK((b - a).cross(result.mesh.positions[face[2]] - a).z() > 0);
  }
}

TEST_CASE("places of a range view that saw nothing leave holes, with one triangle where three saw something") {
  // One place in the middle of 4 × 4: each of the four cells around it keeps three corners.
  const auto dent = [](int x, int y) { return x == 1 && y == 1 ? unseen : 0.0; };
  CHECK(mesh_of(range_view(4, 4, dent, grid_size(4, 4))).face_count() == 2 * 5 + 4);
  // A whole row away: two strips.
  const auto gap = [](int, int y) { return y == 2 ? unseen : 0.0; };
  CHECK(mesh_of(range_view(5, 4, gap, grid_size(5, 4))).face_count() == 2 * 2 * 3);
}

TEST_CASE("steps in depth of a range view are left open, and told") {
  const auto step = [](int x, int) { return x < 4 ? 0.0 : 10.0; };
  const MeshReadResult result = read(range_view(6, 8, step, grid_size(6, 8)), MeshFormat::Ply);
  CHECK(result.mesh.face_count() == 2 * 5 * 6);
  REQUIRE(result.warnings.size() == 1);
  CHECK(result.warnings[0].code == "W_RANGE_STEPS");
  CHECK_THAT(result.warnings[0].message, Catch::Contains("10 triangles"));
}

TEST_CASE("a range grid that doesn't fit its header or its vertices is refused") {
  const auto flat = [](int, int) { return 0.0; };
  const auto refused_with = [](const std::string& bytes) { return refusal(bytes, MeshFormat::Ply).front(); };
  CHECK(refused_with(range_view(3, 4, flat, "")).code == "E_COUNT");
  CHECK(refused_with(range_view(3, 4, flat, grid_size(3, 5))).code == "E_COUNT");
  CHECK(refused_with(range_view(3, 4, flat, grid_size(4, 4))).code == "E_COUNT");
  std::string two = range_view(3, 4, flat, grid_size(3, 4));
  const std::size_t last = two.rfind("1 11");
  CHECK_THAT(refused_with(two.replace(last, 4, "2 10 11")).message, Catch::Contains("place 11"));
  std::string far = range_view(3, 4, flat, grid_size(3, 4));
  const Finding beyond = refused_with(far.replace(far.rfind("1 11"), 4, "1 12"));
  CHECK(beyond.code == "E_INDEX");
  CHECK_THAT(beyond.message, Catch::Contains("12 vertices"));
}

TEST_CASE("PLY edges are polylines of two vertices with their attributes") {
  PolyMesh mesh = cube();
  mesh.add_line(std::array<Index, 2>{0, 6});
  mesh.add_line(std::array<Index, 2>{1, 7});
  mesh.channels.push_back({"weight", Domain::Line, 1, std::vector<float>{0.5F, 2}, {}});
  CHECK(difference(mesh_of(write(mesh, MeshFormat::Ply).bytes), mesh) == "");
  mesh.add_line(std::array<Index, 3>{1, 2, 3});
  mesh.channels.clear();
  const MeshWriteResult written = write(mesh, MeshFormat::Ply);
  REQUIRE(written.warnings.size() == 1);
  CHECK(written.warnings[0].code == "W_FORMAT_LOSS");
  CHECK(mesh_of(written.bytes).line_count() == 4);
}

TEST_CASE("a header that ends its lines with returns is read, also before binary data") {
  for (const bool ascii : {true, false}) {
    for (const std::string end : {"\r\n", "\r"}) {
      const std::string bytes = write(cube(), MeshFormat::Ply, {0, ascii}).bytes;
      const std::size_t body = bytes.find("end_header\n") + 11;
      std::string changed;
      for (std::size_t i = 0; i < bytes.size(); ++i) {
        const bool ends_line = bytes[i] == '\n' && (i < body || ascii);
        changed += ends_line ? end : std::string(1, bytes[i]);
      }
      CHECK(difference(mesh_of(changed), cube()) == "");
    }
  }
}

TEST_CASE("PLY positions are floats exactly when floats hold them") {
  CHECK(write(cube(), MeshFormat::Ply).bytes.find("property float x") != std::string::npos);
  for (int k = 0; k < 3; ++k) {
    PolyMesh mesh = cube();
    mesh.positions[3][k] = 0.1;
    CHECK(write(mesh, MeshFormat::Ply).bytes.find("property double x") != std::string::npos);
  }
}

TEST_CASE("polygons with more corners than a byte counts are written to PLY") {
  PolyMesh mesh;
  std::vector<Index> ring;
  for (Index i = 0; i < 300; ++i) {
    mesh.positions.emplace_back(std::cos(i * 0.02), std::sin(i * 0.02), 0);
    ring.push_back(i);
  }
  mesh.add_face(ring);
  for (const bool ascii : {true, false}) {
    CHECK(difference(mesh_of(write(mesh, MeshFormat::Ply, {0, ascii}).bytes), mesh) == "");
  }
}

TEST_CASE("each damage of a PLY is refused with its code and place") {
  const std::string list = "element face 1\nproperty list uchar int vertex_indices\n";
  struct Case {
    std::string bytes, code, place;
  };
  const std::vector<Case> cases = {
      {"plx\n", "E_SYNTAX", "line 1"},
      {"ply\nformat ascii 1.0\nelement vertex 3\n", "E_TRUNCATED", "line 3"},
      {"ply\nformat ascii 2.0\nend_header\n", "E_SYNTAX", "line 2"},
      {"ply\nformat morse 1.0\nend_header\n", "E_SYNTAX", "line 2"},
      {"ply\nelement vertex 3\nend_header\n", "E_SYNTAX", "line 3"},
      {header("element vertex -3\n"), "E_COUNT", "line 3"},
      {header("element vertex 99999999999999999999999\n"), "E_COUNT", "line 3"},
      {header("element vertex 3\nproperty quad x\n"), "E_SYNTAX", "line 4"},
      {header("element vertex 3\nproperty float x\nproperty float x\n"), "E_SYNTAX", "line 5"},
      {header("element vertex 3\nelement vertex 3\n"), "E_SYNTAX", "line 4"},
      {header("property float x\n"), "E_SYNTAX", "line 3"},
      {header("element vertex 3\nproperty list float int x\n"), "E_SYNTAX", "line 4"},
      {header("element vertex 3\nproprety float x\n"), "E_SYNTAX", "line 4"},
      {header("element vertex 3\nproperty float x\nproperty float y\n" + list) + "0 0\n1 0\n0 1\n3 0 1 2\n", "E_SYNTAX",
       "lack x, y or z"},
      {header(list) + "3 0 1 2\n", "E_SYNTAX", "no element 'vertex'"},
      {header("element vertex 3\n" + xyz + "element face 1\nproperty int vertex_indices\n") + triangle_rows + "3\n",
       "E_SYNTAX", "no list vertex_indices"},
      {header("element vertex 3\n" + xyz + "element face 1\nproperty list uchar float vertex_indices\n") +
           triangle_rows + "3 0 1 2\n",
       "E_SYNTAX", "no list vertex_indices"},
      {triangle("3 0 1 3\n"), "E_INDEX", "line 13"},
      {triangle("3 0 1 -1\n"), "E_INDEX", "line 13"},
      {triangle("\n\n3 0 1 2\n\n3 0 1 3\n", 2), "E_INDEX", "line 17"},
      {triangle("2 0 1\n"), "E_FACE_DEGENERATE", "line 13"},
      {triangle("0\n"), "E_FACE_DEGENERATE", "line 13"},
      {triangle("3 0 1\n"), "E_COUNT", "line 13"},
      {triangle("3 0 1 2 2\n"), "E_COUNT", "line 13"},
      {triangle("-3 0 1 2\n"), "E_COUNT", "line 13"},
      {triangle("3 0 1 x\n"), "E_SYNTAX", "line 13"},
      {triangle("3 0 1 1.5\n"), "E_SYNTAX", "line 13"},
      {triangle("3 0 1 2\n3 0 1 2\n"), "E_COUNT", "line 14"},
      {triangle("3 0 1 2\n", 2), "E_TRUNCATED", "line 13"},
      {triangle("", 2000000000), "E_TRUNCATED", "byte"},
      {header("element vertex 3\n" + xyz + list) + "0 0 0\n0 nan 0\n0 1 0\n3 0 1 2\n", "E_NOT_FINITE", "line 11"},
      {header("element vertex 4000000000\n" + xyz + "element face 9000000000\n", "binary_little_endian"), "E_TRUNCATED",
       "4000000000 elements 'vertex'"},
  };
  for (const Case& c : cases) {
    INFO(c.bytes);
    const Findings findings = refusal(c.bytes, MeshFormat::Ply);
    REQUIRE(findings.size() == 1);
    CHECK(findings[0].code == c.code);
    CHECK(findings[0].category == Category::Malformed);
    CHECK_THAT(findings[0].message, Catch::Contains(c.place));
  }
}

TEST_CASE("a binary PLY cut anywhere is refused as truncated, naming a byte") {
  const std::string bytes = write(with_attributes(cube()), MeshFormat::Ply).bytes;
  const std::size_t body = bytes.find("end_header\n") + 11;
  for (std::size_t size = body; size < bytes.size(); ++size) {
    const Findings findings = refusal(bytes.substr(0, size), MeshFormat::Ply);
    REQUIRE(findings.front().code == "E_TRUNCATED");
    REQUIRE_THAT(findings.front().message, Catch::Contains("byte"));
  }
  CHECK(refusal(bytes + "x", MeshFormat::Ply).front().code == "E_COUNT");
  CHECK(difference(mesh_of(bytes + "\n"), with_attributes(cube())) == "");
}

TEST_CASE("a binary PLY names the byte of the face with a bad index") {
  std::string bytes = write(cube(), MeshFormat::Ply).bytes;
  const std::size_t faces = bytes.find("end_header\n") + 11 + 8 * 12;
  bytes[faces + 2 * 17 + 1] = 99;
  const Findings findings = refusal(bytes, MeshFormat::Ply);
  CHECK(findings.front().code == "E_INDEX");
  CHECK_THAT(findings.front().message, Catch::Contains("byte " + std::to_string(faces + 2 * 17)) &&
                                           Catch::Contains("face 2") && Catch::Contains("vertex 99"));
}
