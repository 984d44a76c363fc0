// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstring>

#include <catch2/catch.hpp>
#include <tiny_gltf.h>

#include "io/mesh_compare.h"
#include "support/meshes/mesh_shapes.h"

using namespace croquis;
using namespace croquis::test;

namespace {

tinygltf::Model load(const std::string& bytes) {
  tinygltf::Model model;
  tinygltf::TinyGLTF loader;
  std::string error, warning;
  const bool good =
      loader.LoadBinaryFromMemory(&model, &error, &warning, reinterpret_cast<const unsigned char*>(bytes.data()),
                                  static_cast<unsigned int>(bytes.size()));
  INFO(error << warning);
  REQUIRE(good);
  REQUIRE(warning.empty());
  return model;
}

template <typename T>
std::vector<T> values_of(const tinygltf::Model& model, int accessor) {
  const auto& entry = model.accessors.at(static_cast<std::size_t>(accessor));
  const auto& view = model.bufferViews.at(static_cast<std::size_t>(entry.bufferView));
  std::vector<T> values(view.byteLength / sizeof(T));
  REQUIRE(view.byteOffset + view.byteLength <= model.buffers.at(0).data.size());
  std::memcpy(values.data(), model.buffers[0].data.data() + view.byteOffset, view.byteLength);
  return values;
}

}  // namespace

TEST_CASE("a GLB holds the triangles, their positions and bounds") {
  const PolyMesh mesh = translated(triangulated(cube()), Vec3(1, 2, 3));
  const MeshWriteResult written = write(mesh, MeshFormat::Glb);
  CHECK(written.warnings.empty());
  const tinygltf::Model model = load(written.bytes);
  const tinygltf::Primitive& primitive = model.meshes.at(0).primitives.at(0);
  CHECK(primitive.mode == TINYGLTF_MODE_TRIANGLES);
  CHECK(values_of<std::uint32_t>(model, primitive.indices) == mesh.corners);
  const auto& positions = model.accessors.at(static_cast<std::size_t>(primitive.attributes.at("POSITION")));
  CHECK(positions.count == 8);
  CHECK(positions.minValues == std::vector<double>{1, 2, 3});
  CHECK(positions.maxValues == std::vector<double>{2, 3, 4});
  const auto values = values_of<float>(model, primitive.attributes.at("POSITION"));
  for (std::size_t v = 0; v < 8; ++v)
    CHECK(Vec3(values[3 * v], values[3 * v + 1], values[3 * v + 2]) == mesh.positions[v]);
}

TEST_CASE("a GLB carries vertex attributes and polylines, and tells what is lost") {
  PolyMesh mesh = with_attributes(cube());
  mesh.add_line(std::array<Index, 3>{0, 1, 2});
  const MeshWriteResult written = write(mesh, MeshFormat::Glb);
  const tinygltf::Model model = load(written.bytes);
  REQUIRE(model.meshes.at(0).primitives.size() == 2);
  const tinygltf::Primitive& lines = model.meshes[0].primitives[1];
  CHECK(lines.mode == TINYGLTF_MODE_LINE);
  CHECK(values_of<std::uint32_t>(model, lines.indices) == std::vector<std::uint32_t>{0, 1, 1, 2});
  CHECK(model.accessors[static_cast<std::size_t>(lines.attributes.at("COLOR_0"))].type == TINYGLTF_TYPE_VEC4);
  const auto colours = values_of<float>(model, lines.attributes.at("COLOR_0"));
  const auto& bytes = std::get<std::vector<std::uint8_t>>(mesh.channel("color", Domain::Vertex)->data);
  for (std::size_t i = 0; i < bytes.size(); ++i) CHECK(colours[i] == static_cast<float>(bytes[i] / 255.0));
  REQUIRE(written.warnings.size() == 1);
  CHECK_THAT(written.warnings[0].message, Catch::Contains("'confidence'") && Catch::Contains("polygons"));
}

TEST_CASE("an empty mesh is a valid GLB") { CHECK(load(write(PolyMesh{}, MeshFormat::Glb).bytes).meshes.empty()); }
