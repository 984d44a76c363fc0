// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <map>

#include <catch2/catch.hpp>
#include <tiny_gltf.h>

#include "io/mesh_compare.h"
#include "support/meshes/mesh_shapes.h"

using namespace croquis;
using namespace croquis::test;

namespace {

template <typename T>
void put(std::string& bytes, T value) {
  const auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
  bytes.append(raw.data(), raw.size());
}

void put_floats(std::string& bytes, std::initializer_list<float> values) {
  for (const float value : values) put(bytes, value);
}

std::string chunk(std::uint32_t type, std::string content, char padding) {
  while (content.size() % 4 != 0) content += padding;
  std::string bytes;
  put(bytes, static_cast<std::uint32_t>(content.size()));
  put(bytes, type);
  return bytes + content;
}

/// A file put together by hand, from the specification alone.
std::string glb(const std::string& json, const std::string& binary) {
  std::string chunks = chunk(0x4e4f534a, json, ' ');
  if (!binary.empty()) chunks += chunk(0x004e4942, binary, '\0');
  std::string bytes = "glTF";
  put(bytes, std::uint32_t{2});
  put(bytes, static_cast<std::uint32_t>(12 + chunks.size()));
  return bytes + chunks;
}

MeshReadResult read_glb(const std::string& bytes) { return read(bytes, MeshFormat::Glb); }

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  REQUIRE(text.find(what) != std::string::npos);
  return text.replace(text.find(what), what.size(), with);
}

/// A square of two triangles, its positions and byte colours in turn (16 bytes a vertex), 16-bit indices at byte 64.
std::string square_binary() {
  std::string binary;
  const std::array<std::array<float, 2>, 4> places = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  for (std::size_t v = 0; v < 4; ++v) {
    put_floats(binary, {places[v][0], places[v][1], 0});
    binary += {static_cast<char>(10 * v), 0, '\x7f', '\xff'};
  }
  for (const int i : {0, 1, 2, 0, 2, 3}) put(binary, static_cast<std::uint16_t>(i));
  return binary;
}

const std::string square_json = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
"nodes":[{"name":"frame","scale":[2,2,2],"children":[1]},{"name":"pane","translation":[1,0,5],"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0,"COLOR_0":1},"indices":2,"material":0}]}],
"materials":[{"name":"glass"}],
"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
{"bufferView":0,"byteOffset":12,"componentType":5121,"normalized":true,"count":4,"type":"VEC4"},
{"bufferView":1,"componentType":5123,"count":6,"type":"SCALAR"}],
"bufferViews":[{"buffer":0,"byteLength":64,"byteStride":16},{"buffer":0,"byteOffset":64,"byteLength":12}],
"buffers":[{"byteLength":76}]})";

std::string square_with(const std::string& what, const std::string& with) {
  return glb(replaced(square_json, what, with), square_binary());
}

}  // namespace

TEST_CASE("a GLB made by hand is read as the specification says") {
  const MeshReadResult result = read_glb(glb(square_json, square_binary()));
  CHECK(result.warnings.empty());
  const PolyMesh& mesh = result.mesh;
  CHECK(mesh.positions == std::vector<Vec3>{{2, 0, 10}, {4, 0, 10}, {4, 2, 10}, {2, 2, 10}});
  CHECK(mesh.corners == std::vector<Index>{0, 1, 2, 0, 2, 3});
  const AttributeChannel* colour = mesh.channel("color", Domain::Vertex);
  REQUIRE(colour != nullptr);
  CHECK(colour->width == 4);
  CHECK(std::get<std::vector<std::uint8_t>>(colour->data) ==
        std::vector<std::uint8_t>{0, 0, 127, 255, 10, 0, 127, 255, 20, 0, 127, 255, 30, 0, 127, 255});
  CHECK(mesh.channel("object", Domain::Face)->labels == std::vector<std::string>{"pane"});
  CHECK(mesh.channel("material", Domain::Face)->labels == std::vector<std::string>{"glass"});

  tinygltf::Model model;  // another reader finds nothing wrong with it either
  std::string error, warning;
  const std::string bytes = glb(square_json, square_binary());
  CHECK(tinygltf::TinyGLTF().LoadBinaryFromMemory(&model, &error, &warning,
                                                  reinterpret_cast<const unsigned char*>(bytes.data()),
                                                  static_cast<unsigned int>(bytes.size())));
  CHECK(error + warning == "");
}

TEST_CASE("strips, fans, lines and loops are taken apart, with and without indices") {
  const auto faces = [](const std::string& mode, bool indices) {
    std::string json = replaced(square_json, "\"indices\":2", "\"mode\":" + mode + ",\"indices\":2");
    if (!indices) json = replaced(json, ",\"indices\":2", "");
    Progress progress;
    const std::string bytes = glb(json, square_binary());
    return read_mesh({bytes, MeshFormat::Glb, "file", false}, progress).mesh;
  };
  CHECK(faces("5", false).corners == std::vector<Index>{0, 1, 2, 1, 3, 2});
  CHECK(faces("6", false).corners == std::vector<Index>{0, 1, 2, 0, 2, 3});
  CHECK(faces("5", true).corners ==
        std::vector<Index>{0, 1, 2, 1, 0, 2, 0, 3, 2});  // triangles without area sew strips together
  CHECK(faces("0", true).face_count() == 0);
  CHECK(faces("1", false).line_vertices == std::vector<Index>{0, 1, 2, 3});
  CHECK(faces("1", false).line_count() == 2);
  CHECK(faces("2", false).line_vertices == std::vector<Index>{0, 1, 2, 3, 0});
  CHECK(faces("3", false).line_vertices == std::vector<Index>{0, 1, 2, 3});
}

TEST_CASE("matrices, rotations and mirrors put meshes where they belong, facing outwards") {
  const auto place = [](const std::string& members) {
    return read_glb(square_with("\"translation\":[1,0,5]", members)).mesh;
  };
  const PolyMesh turned = place("\"rotation\":[0,0,0.7071067811865476,0.7071067811865476]");
  CHECK((turned.positions[1] - Vec3(0, 2, 0)).norm() < 1e-12);
  const PolyMesh moved = place("\"matrix\":[0,1,0,0,-1,0,0,0,0,0,1,0,7,8,9,1]");
  CHECK(moved.positions[1] == Vec3(14, 18, 18));
  const PolyMesh mirrored = place("\"scale\":[-1,1,1]");
  CHECK(mirrored.positions[1] == Vec3(-2, 0, 0));
  CHECK(mirrored.corners == std::vector<Index>{0, 2, 1, 0, 3, 2});
}

TEST_CASE("whole numbers stand for parts of one, and sparse accessors for their exceptions") {
  std::string binary = square_binary();
  const std::size_t at = binary.size();
  for (const int v : {0, 0, 0, 127, 0, 0, 127, 127, 0, -128, 127, 0}) binary += static_cast<char>(v);
  binary += '\x02';  // one exception: vertex 2
  binary += {'\x00', '\x00', '\x00', '\x00', '\x7f', '\x00'};
  std::string json = replaced(
      square_json, R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],"max":[1,1,0]})",
      R"({"bufferView":2,"componentType":5120,"normalized":true,"count":4,"type":"VEC3","sparse":
{"count":1,"indices":{"bufferView":2,"byteOffset":12,"componentType":5121},"values":{"bufferView":2,"byteOffset":16}}})");
  json = replaced(json, R"("byteLength":12}])",
                  R"("byteLength":12},{"buffer":0,"byteOffset":)" + std::to_string(at) + R"(,"byteLength":19}])");
  json = replaced(json, R"({"byteLength":76})", R"({"byteLength":95})");
  const PolyMesh mesh = read_glb(glb(json, binary)).mesh;
  CHECK(mesh.positions == std::vector<Vec3>{{2, 0, 10}, {4, 0, 10}, {2, 2, 10}, {0, 2, 10}});
}

TEST_CASE("vertices that a file repeats are one vertex, and what differs between them goes to the corners") {
  PolyMesh mesh = triangulated(cube());
  std::vector<float> normals;
  PolyMesh split;  // every triangle has its own three vertices, as flat shaded exports do
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    const Vec3& a = mesh.positions[face[0]];
    const Vec3 normal = (mesh.positions[face[1]] - a).cross(mesh.positions[face[2]] - a).normalized();
    for (const Index v : face) {
      split.positions.push_back(mesh.positions[v]);
      for (const double x : normal) normals.push_back(static_cast<float>(x));
    }
    const auto first = static_cast<Index>(3 * f);
    split.add_triangle(first, first + 1, first + 2);
  }
  split.channels.push_back({"normal", Domain::Vertex, 3, normals, {}});
  const PolyMesh back = read_glb(write(split, MeshFormat::Glb).bytes).mesh;
  CHECK(back.vertex_count() == 8);
  CHECK(back.face_count() == 12);
  CHECK(back.channel("normal", Domain::Vertex) == nullptr);
  REQUIRE(back.channel("normal", Domain::Corner) != nullptr);
  CHECK(std::get<std::vector<float>>(back.channel("normal", Domain::Corner)->data) == normals);
}

TEST_CASE("OBJ to GLB and back keeps 32-bit positions and all triangles") {
  for (const PolyMesh& shape : {cube(), uv_sphere(12, 7), torus(8, 6), moebius(9), double_torus(), grid(5, 4)}) {
    const PolyMesh mesh = read(write(shape, MeshFormat::Obj).bytes, MeshFormat::Obj).mesh;
    const MeshWriteResult written = write(mesh, MeshFormat::Glb);
    const MeshReadResult back = read_glb(written.bytes);
    CHECK(back.warnings.empty());
    CHECK(back.mesh.vertex_count() == mesh.vertex_count());
    CHECK(back.mesh.positions == as_written(mesh, MeshFormat::Glb, {}).positions);
    std::size_t triangles = 0;
    bool polygons = false;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
      triangles += mesh.face(f).size() - 2;
      polygons = polygons || mesh.face(f).size() > 3;
    }
    CHECK(back.mesh.face_count() == triangles);
    CHECK((!written.warnings.empty() && written.warnings[0].message.find("triangles") != std::string::npos) ==
          polygons);
    CHECK(difference(read(write(back.mesh, MeshFormat::Obj).bytes, MeshFormat::Obj).mesh, back.mesh) == "");
  }
}

TEST_CASE("colours, normals, texture places and lines come back from a GLB") {
  PolyMesh mesh = triangulated(cube());
  std::vector<float> normals, places;
  std::vector<float> colours;
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    normals.insert(normals.end(), {0, 0, 1});
    places.insert(places.end(), {static_cast<float>(v) / 8, 0.25F});
    colours.insert(colours.end(), {static_cast<float>(v) / 8, 0.5F, 1});
  }
  mesh.channels = {{"normal", Domain::Vertex, 3, normals, {}},
                   {"color", Domain::Vertex, 3, colours, {}},
                   {"uv", Domain::Vertex, 2, places, {}}};
  mesh.add_line(std::array<Index, 2>{0, 6});
  const PolyMesh back = read_glb(write(mesh, MeshFormat::Glb).bytes).mesh;
  CHECK(back.corners == mesh.corners);
  CHECK(back.line_vertices == mesh.line_vertices);
  CHECK(std::get<std::vector<float>>(back.channel("normal", Domain::Vertex)->data) == normals);
  CHECK(std::get<std::vector<float>>(back.channel("uv", Domain::Vertex)->data) == places);
  const AttributeChannel* colour = back.channel("color", Domain::Vertex);
  REQUIRE(colour != nullptr);
  REQUIRE(colour->width == 3);
  REQUIRE(colour->size() == colours.size());
}

TEST_CASE("several primitives share vertices and become groups by their materials") {
  std::string json =
      replaced(square_json, R"("indices":2,"material":0}])",
               R"("indices":2,"material":0},{"attributes":{"POSITION":0,"COLOR_0":1},"mode":6,"material":1}])");
  json = replaced(json, R"({"name":"glass"})", R"({"name":"glass"},{})");
  const PolyMesh mesh = read_glb(glb(json, square_binary())).mesh;
  CHECK(mesh.vertex_count() == 4);
  const AttributeChannel* materials = mesh.channel("material", Domain::Face);
  REQUIRE(materials != nullptr);
  CHECK(materials->labels == std::vector<std::string>{"glass", "Material 2"});
  CHECK(std::get<std::vector<std::int32_t>>(materials->data) == std::vector<std::int32_t>{0, 0, 1, 1});
}

TEST_CASE("what a mesh can't hold is told in one warning") {
  const Findings warnings =
      read_glb(square_with("\"scene\":0", R"("scene":0,"animations":[{}],"images":[{}],"textures":[{}],"skins":[{}])"))
          .warnings;
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].code == "W_IGNORED");
  CHECK_THAT(warnings[0].message, Catch::Contains("animations, skins and textures"));
  CHECK_THAT(read_glb(square_with("\"indices\":2", R"("targets":[{}],"indices":2)")).warnings.at(0).message,
             Catch::Contains("morph targets"));
}

TEST_CASE("each damage of a GLB is refused with its code and names the element") {
  struct Case {
    std::string what, with, code, named;
  };
  const std::vector<Case> cases = {
      {"\"2.0\"", "\"1.0\"", "E_SYNTAX", "version 2"},
      {"\"mesh\":0", "\"mesh\":7", "E_INDEX", "node 1"},
      {"\"mesh\":0", "\"mesh\":-1", "E_SYNTAX", "node 1"},
      {"\"children\":[1]", "\"children\":[2]", "E_INDEX", "node 0"},
      {"\"mesh\":0", "\"mesh\":0,\"children\":[0]", "E_SYNTAX", "descendant"},
      {"\"scale\":[2,2,2]", "\"scale\":[2,2]", "E_SYNTAX", "node 0"},
      {"\"POSITION\":0", "\"POSITION\":9", "E_INDEX", "primitive 0 of mesh 0"},
      {"\"POSITION\":0,", "", "E_SYNTAX", "primitive 0 of mesh 0"},
      {"\"POSITION\":0", "\"POSITION\":2", "E_SYNTAX", "accessor 2"},
      {"\"COLOR_0\":1", "\"COLOR_0\":2", "E_SYNTAX", "accessor 2"},
      {"\"indices\":2", "\"indices\":0", "E_SYNTAX", "accessor 0"},
      {"\"indices\":2", "\"mode\":9,\"indices\":2", "E_SYNTAX", "mode"},
      {"5126", "5127", "E_SYNTAX", "accessor 0"},
      {"\"count\":4", "\"count\":5", "E_COUNT", "accessor 0"},
      {"\"count\":4", "\"count\":4294967295", "E_COUNT", "accessor 0"},
      {"\"bufferView\":0,\"componentType\":5126,\"count\":4", "\"componentType\":5126,\"count\":4000000", "E_COUNT",
       "accessor 0"},
      {"\"count\":6", "\"count\":5", "E_COUNT", "whole number of triangles"},
      {"\"byteStride\":16", "\"byteStride\":8", "E_SYNTAX", "accessor 0"},
      {"\"byteLength\":64", "\"byteLength\":640", "E_COUNT", "buffer view 0"},
      {"\"byteOffset\":12", "\"byteOffset\":65", "E_COUNT", "accessor 1"},
      {"{\"byteLength\":76}", "{\"byteLength\":7600}", "E_TRUNCATED", "buffer 0"},
      {"{\"byteLength\":76}", "{\"byteLength\":76,\"uri\":\"../secret.bin\"}", "E_FORMAT", "buffer 0"},
      {"\"scene\":0", "\"extensionsRequired\":[\"KHR_draco_mesh_compression\"]", "E_FORMAT", "KHR_draco"},
      {"\"asset\"", "\"asset", "E_SYNTAX", ""},
  };
  for (const Case& c : cases) {
    INFO(c.what << " -> " << c.with);
    const Findings findings = refusal(square_with(c.what, c.with), MeshFormat::Glb);
    CHECK(findings[0].code == c.code);
    CHECK(findings[0].category == Category::Malformed);
    CHECK_THAT(findings[0].message, Catch::Contains(c.named));
  }
}

TEST_CASE("indices and positions out of range are refused by element") {
  std::string binary = square_binary();
  binary[64 + 8] = 4;
  const Findings index = refusal(glb(square_json, binary), MeshFormat::Glb);
  CHECK(index[0].code == "E_INDEX");
  CHECK_THAT(index[0].message, Catch::Contains("face 1 uses vertex 4"));
  binary = square_binary();
  const std::uint32_t nan = 0x7fc00000;
  std::memcpy(binary.data() + 16, &nan, 4);
  CHECK(refusal(glb(square_json, binary), MeshFormat::Glb)[0].code == "E_NOT_FINITE");
}

TEST_CASE("a GLB cut anywhere is refused, and bytes after it are told") {
  const std::string bytes = glb(square_json, square_binary());
  for (std::size_t size = 1; size < bytes.size(); ++size) {
    const std::string code = refusal(bytes.substr(0, size), MeshFormat::Glb)[0].code;
    CHECK(code == (size < 4 ? "E_SYNTAX" : "E_TRUNCATED"));
  }
  CHECK(read_glb(bytes + "more").warnings.at(0).code == "W_TRAILING");
  CHECK(refusal("solid", MeshFormat::Glb)[0].code == "E_SYNTAX");
}

TEST_CASE("a small file that repeats a mesh ten thousand times over and over is refused before it takes memory") {
  std::string nodes = R"("nodes":[{"mesh":0})";
  for (int i = 0; i < 9999; ++i) nodes += R"(,{"mesh":0})";
  std::string primitives = R"("primitives":[{"attributes":{"POSITION":0},"indices":2})";
  for (int i = 0; i < 9999; ++i) primitives += R"(,{"attributes":{"POSITION":0},"indices":2})";
  std::string json = square_json;
  json.replace(json.find("\"nodes\":[{\"name\""), json.find("\"meshes\"") - json.find("\"nodes\":[{\"name\""),
               nodes + "],\n");
  json.replace(json.find("\"primitives\""), json.find("}]}],\n\"materials\"") + 2 - json.find("\"primitives\""),
               primitives + "]");
  const Findings findings = refusal(glb(json, square_binary()), MeshFormat::Glb);
  CHECK(findings[0].code == "E_TOO_LARGE");
  CHECK(findings[0].category == Category::Limit);
}
