// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstring>

#include <catch2/catch.hpp>
#include <tiny_gltf.h>

#include "croquis/geometry/mesh_report.h"
#include "croquis/geometry/mesh_topology.h"
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

std::vector<Vec3> vectors_of(const tinygltf::Model& model, int accessor) {
  const auto values = values_of<float>(model, accessor);
  std::vector<Vec3> vectors;
  for (std::size_t i = 0; i < values.size(); i += 3) vectors.emplace_back(values[i], values[i + 1], values[i + 2]);
  return vectors;
}

}  // namespace

TEST_CASE("a GLB holds the triangles, their positions and bounds") {
  const PolyMesh mesh = translated(triangulated(cube()), Vec3(1, 2, 3));
  const MeshWriteResult written = write(mesh, MeshFormat::Glb);
  CHECK(written.warnings.empty());
  const tinygltf::Model model = load(written.bytes);
  const tinygltf::Primitive& primitive = model.meshes.at(0).primitives.at(0);
  CHECK(primitive.mode == TINYGLTF_MODE_TRIANGLES);
  const auto& positions = model.accessors.at(static_cast<std::size_t>(primitive.attributes.at("POSITION")));
  CHECK(positions.minValues == std::vector<double>{1, 2, 3});
  CHECK(positions.maxValues == std::vector<double>{2, 3, 4});
  const auto indices = values_of<std::uint32_t>(model, primitive.indices);
  const std::vector<Vec3> places = vectors_of(model, primitive.attributes.at("POSITION"));
  REQUIRE(indices.size() == mesh.corners.size());
  for (std::size_t c = 0; c < indices.size(); ++c) CHECK(places.at(indices[c]) == mesh.positions[mesh.corners[c]]);
}

TEST_CASE("a GLB's normals are the faces' own at sharp edges, smooth elsewhere, and no attribute when read back") {
  const tinygltf::Model box = load(write(cube(), MeshFormat::Glb).bytes);
  const auto& attributes = box.meshes.at(0).primitives.at(0).attributes;
  const auto indices = values_of<std::uint32_t>(box, box.meshes[0].primitives[0].indices);
  const std::vector<Vec3> places = vectors_of(box, attributes.at("POSITION"));
  const std::vector<Vec3> normals = vectors_of(box, attributes.at("NORMAL"));
  CHECK(places.size() == 24);
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    const Vec3& a = places.at(indices[i]);
    const Vec3 normal = (places.at(indices[i + 1]) - a).cross(places.at(indices[i + 2]) - a).normalized();
    for (std::size_t k = 0; k < 3; ++k) CHECK((normals.at(indices[i + k]) - normal).norm() < 1e-6);
  }
  const PolyMesh again = read(write(cube(), MeshFormat::Glb).bytes, MeshFormat::Glb).mesh;
  CHECK(again.positions == cube().positions);
  CHECK(again.channels.empty());

  PolyMesh round = uv_sphere(24, 12);
  const tinygltf::Model smooth = load(write(round, MeshFormat::Glb).bytes);
  const std::vector<Vec3> at = vectors_of(smooth, smooth.meshes[0].primitives[0].attributes.at("POSITION"));
  const std::vector<Vec3> outwards = vectors_of(smooth, smooth.meshes[0].primitives[0].attributes.at("NORMAL"));
  CHECK(at.size() == round.vertex_count());
  for (std::size_t v = 0; v < at.size(); ++v) CHECK(at[v].dot(outwards[v]) > 0.999);
  const PolyMesh back = read(write(round, MeshFormat::Glb).bytes, MeshFormat::Glb).mesh;
  CHECK(back.channels.empty());
  CHECK(back.vertex_count() == round.vertex_count());

  // A ring of sharp tags on the sphere: its vertices, and no others, are there twice.
  const MeshTopology topology(round);
  for (Index edge = 0; edge < topology.edge_count(); ++edge) {
    const auto [a, b] = topology.edge_vertices(edge);
    if (std::abs(round.positions[a].z()) + std::abs(round.positions[b].z()) < 1e-9)
      round.tags.creases.push_back({{a, b}, infinite_sharpness});
  }
  CHECK(round.tags.creases.size() == 24);
  const tinygltf::Model tagged = load(write(round, MeshFormat::Glb).bytes);
  CHECK(vectors_of(tagged, tagged.meshes[0].primitives[0].attributes.at("POSITION")).size() == at.size() + 24);
}

TEST_CASE("a GLB has a named node for each object and a named material for each part, and both come back") {
  PolyMesh mesh = merged(triangulated(cube()), translated(triangulated(cube()), Vec3(3, 0, 0)));
  std::vector<std::int32_t> objects(24, 0), materials(24, -1);
  for (std::size_t f = 12; f < 24; ++f) {
    objects[f] = 1;
    materials[f] = f % 2 == 0 ? 0 : 1;
  }
  mesh.channels.push_back({"object", Domain::Face, 1, objects, {"box", "two-coloured box"}});
  for (const char* kind : {"material", "group"}) {
    INFO(kind);
    PolyMesh named = mesh;
    named.channels.push_back({kind, Domain::Face, 1, materials, {"red", "blue"}});
    const MeshWriteResult written = write(named, MeshFormat::Glb);
    CHECK(written.warnings.empty());
    const tinygltf::Model model = load(written.bytes);
    REQUIRE(model.nodes.size() == 2);
    CHECK(model.nodes[0].name == "box");
    CHECK(model.nodes[1].name == "two-coloured box");
    CHECK(model.meshes.at(0).primitives.size() == 1);
    REQUIRE(model.meshes.at(1).primitives.size() == 2);
    for (const tinygltf::Primitive& primitive : model.meshes[1].primitives) {
      const std::string& name = model.materials.at(static_cast<std::size_t>(primitive.material)).name;
      CHECK(name == (&primitive == model.meshes[1].primitives.data() ? "red" : "blue"));
    }
    const PolyMesh back = read(written.bytes, MeshFormat::Glb).mesh;
    Progress progress;
    CHECK(inspect(back, true, progress).closed);
    CHECK(back.positions == named.positions);
    REQUIRE(back.channel("object", Domain::Face) != nullptr);
    CHECK(back.channel("object", Domain::Face)->labels == mesh.channels[0].labels);
    REQUIRE(back.channel(kind, Domain::Face) != nullptr);
    CHECK(std::ranges::count(back.channel(kind, Domain::Face)->labels, "red") == 1);
  }
  CHECK(load(write(tetrahedron(), MeshFormat::Glb, {.name = "thing"}).bytes).nodes.at(0).name == "thing");
}

TEST_CASE("colours of faces and places of corners in a texture are kept in a GLB") {
  PolyMesh mesh = triangulated(cube());
  std::vector<std::uint8_t> colours;
  std::vector<float> places;
  for (std::size_t f = 0; f < 12; ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      colours.push_back(static_cast<std::uint8_t>(20 * f + k));
      places.push_back(static_cast<float>(f) / 16);
      places.push_back(static_cast<float>(k) / 4);
    }
  }
  mesh.channels.push_back({"color", Domain::Face, 3, colours, {}});
  mesh.channels.push_back({"uv", Domain::Corner, 2, places, {}});
  const MeshWriteResult written = write(mesh, MeshFormat::Glb);
  CHECK(written.warnings.empty());
  const PolyMesh back = read(written.bytes, MeshFormat::Glb).mesh;
  CHECK(same_connectivity(back, mesh));
  REQUIRE(back.channel("uv", Domain::Corner) != nullptr);
  CHECK(std::get<std::vector<float>>(back.channel("uv", Domain::Corner)->data) == places);
  const AttributeChannel* colour = back.channel("color", Domain::Corner);
  REQUIRE(colour != nullptr);
  for (std::size_t c = 0; c < 36; ++c) {
    for (std::size_t i = 0; i < 3; ++i)
      CHECK(std::get<std::vector<double>>(colour->data).at(3 * c + i) == Approx(colours[c / 3 * 3 + i] / 255.0));
  }
}

TEST_CASE("a GLB carries vertex attributes and polylines, and tells what is lost") {
  PolyMesh mesh = with_attributes(cube());
  mesh.add_line(std::array<Index, 3>{0, 1, 2});
  const MeshWriteResult written = write(mesh, MeshFormat::Glb);
  const tinygltf::Model model = load(written.bytes);
  REQUIRE(model.meshes.at(0).primitives.size() == 2);
  const tinygltf::Primitive& lines = model.meshes[0].primitives[1];
  CHECK(lines.mode == TINYGLTF_MODE_LINE);
  CHECK(model.accessors[static_cast<std::size_t>(lines.attributes.at("COLOR_0"))].type == TINYGLTF_TYPE_VEC4);
  const auto colours = values_of<float>(model, lines.attributes.at("COLOR_0"));
  const auto& bytes = std::get<std::vector<std::uint8_t>>(mesh.channel("color", Domain::Vertex)->data);
  const std::vector<Vec3> places = vectors_of(model, lines.attributes.at("POSITION"));
  for (std::size_t v = 0; v < places.size(); ++v) {
    const auto from = static_cast<std::size_t>(std::ranges::find(mesh.positions, places[v]) - mesh.positions.begin());
    for (std::size_t i = 0; i < 4; ++i)
      CHECK(colours.at(4 * v + i) == static_cast<float>(bytes.at(4 * from + i) / 255.0));
  }
  REQUIRE(written.warnings.size() == 1);
  CHECK_THAT(written.warnings[0].message, Catch::Contains("'confidence'") && Catch::Contains("polygons"));
}

TEST_CASE("an empty mesh is a valid GLB") { CHECK(load(write(PolyMesh{}, MeshFormat::Glb).bytes).meshes.empty()); }
