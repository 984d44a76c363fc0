// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/geometry/mesh_report.h"
#include "croquis/render/mesh_item.h"
#include "support/meshes/mesh_shapes.h"

using namespace croquis;
using namespace croquis::render;

namespace {

std::set<std::tuple<int, int, int>> colors_of(const MeshItem& item) {
  std::set<std::tuple<int, int, int>> colors;
  for (const SurfacePaint& paint : item.paint) colors.insert({paint.color.r, paint.color.g, paint.color.b});
  return colors;
}

}  // namespace

TEST_CASE("a cube keeps its sharp edges: one patch and four vertices per face") {
  const MeshItemPtr item = make_mesh_item(test::cube());
  CHECK(item->patch_count == 6);
  CHECK(item->vertices.size() == 24);
  CHECK(item->triangles.size() == 36);
  CHECK(item->edges.size() == 24);
  for (const SurfaceVertex& vertex : item->vertices) {
    CHECK(std::max({std::abs(vertex.normal.x), std::abs(vertex.normal.y), std::abs(vertex.normal.z)}) == 1.0f);
  }
}

TEST_CASE("bent polygons are drawn as the triangles that the report measures, while they are moved too") {
  const auto volume_of = [](const MeshItem& item) {
    double six_volumes = 0;
    for (std::size_t i = 0; i < item.triangles.size(); i += 3) {
      const auto place = [&](std::size_t k) { return glm::dvec3(item.vertices[item.triangles[i + k]].position); };
      six_volumes += glm::dot(place(0), glm::cross(place(1), place(2)));
    }
    return six_volumes / 6 * std::pow(item.scale, 3);
  };
  Progress progress;
  const MeshItemPtr bent = make_mesh_item(test::bent_box());
  CHECK(volume_of(*bent) == Approx(7.0 / 6).epsilon(1e-6));
  PolyMesh lowered = test::bent_box();  // now the other diagonal is the shorter one
  for (Vec3& position : lowered.positions) {
    if (position == Vec3(1, 0, 1)) position.z() = 3;
  }
  const double volume = *inspect(lowered, false, progress).volume;
  CHECK(volume_of(*make_mesh_item(lowered)) == Approx(volume).epsilon(1e-6));
  CHECK(volume_of(*update_mesh_item(bent, lowered, {})) == Approx(volume).epsilon(1e-6));
  CHECK(volume_of(*update_mesh_item(bent, lowered.positions)) == Approx(volume).epsilon(1e-6));
}

TEST_CASE("a crease angle above its dihedral makes the cube one smooth patch") {
  const MeshItemPtr item = make_mesh_item(test::cube(), {.crease_angle = 1.6});
  CHECK(item->patch_count == 1);
  CHECK(item->vertices.size() == 8);
  for (const SurfaceVertex& vertex : item->vertices) {
    CHECK(glm::length(vertex.normal - glm::normalize(vertex.position)) < 1e-6f);
  }
}

TEST_CASE("a round shape is one patch, shares all vertices and has normals that point from its centre") {
  const MeshItemPtr item = make_mesh_item(test::uv_sphere(48, 24));
  CHECK(item->patch_count == 1);
  CHECK(item->vertices.size() == 2 + 48 * 23);
  for (const SurfaceVertex& vertex : item->vertices) {
    CHECK(glm::dot(vertex.normal, glm::normalize(vertex.position)) > 0.9999f);
  }
}

TEST_CASE("vertices at one place count as one: a sphere of loose triangles stays smooth") {
  const PolyMesh sphere = test::triangulated(test::uv_sphere(48, 24));
  PolyMesh loose;
  for (std::size_t f = 0; f < sphere.face_count(); ++f) {
    const auto first = static_cast<Index>(loose.positions.size());
    for (const Index vertex : sphere.face(f)) loose.positions.push_back(sphere.positions[vertex]);
    loose.add_triangle(first, first + 1, first + 2);
  }
  const MeshItemPtr item = make_mesh_item(loose);
  CHECK(item->patch_count == 1);
  CHECK(item->vertices.size() == sphere.vertex_count());
  CHECK(item->edges.size() == make_mesh_item(sphere)->edges.size());
}

TEST_CASE("coordinates of any size and place come out the same relative to the box") {
  const double size = GENERATE(1e-150, 1e-6, 1e6, 1e29);
  const MeshItemPtr reference = make_mesh_item(test::torus(16, 8));
  const MeshItemPtr item = make_mesh_item(test::scaled(test::torus(16, 8), size));
  REQUIRE(item->vertices.size() == reference->vertices.size());
  for (std::size_t i = 0; i < item->vertices.size(); ++i) {
    CHECK(glm::length(item->vertices[i].position - reference->vertices[i].position) < 1e-5f);
    CHECK(glm::length(item->vertices[i].normal - reference->vertices[i].normal) < 1e-4f);
  }
  CHECK(item->scale == Approx(reference->scale * size));
}

TEST_CASE("parts get palette colours: components, or groups and objects where these say more") {
  PolyMesh mesh = test::merged(test::cube(), test::translated(test::cube(), {3, 0, 0}));
  CHECK(colors_of(*make_mesh_item(mesh)).size() == 2);
  std::vector<std::int32_t> groups;
  for (int f = 0; f < 12; ++f) groups.push_back(f % 3);
  mesh.channels.push_back({"group", Domain::Face, 1, groups, {"a", "b", "c"}});
  CHECK(colors_of(*make_mesh_item(mesh)).size() == 3);
  mesh.channels.push_back({"object", Domain::Face, 1, std::vector<std::int32_t>(12, 0), {"only"}});
  CHECK(colors_of(*make_mesh_item(mesh)).size() == 3);
}

TEST_CASE("colours of any type and width arrive; a missing one falls back to the palette") {
  PolyMesh mesh = test::cube();
  const float none = std::numeric_limits<float>::quiet_NaN();
  std::vector<float> values;
  for (int v = 0; v < 8; ++v) values.insert(values.end(), {v == 0 ? none : 1.0f, 0.0f, 0.5f, 1.0f});
  mesh.channels.push_back({"color", Domain::Vertex, 4, values, {}});
  const Color clay = palette_color(0);
  const std::set<std::tuple<int, int, int>> expected = {{255, 0, 128}, {clay.r, clay.g, clay.b}};
  CHECK(colors_of(*make_mesh_item(mesh)) == expected);
}

TEST_CASE("polylines become segments, and wire edges are the polygons' own, each once") {
  PolyMesh mesh = test::grid(3, 2);
  mesh.add_line(std::vector<Index>{0, 1, 2, 3});
  mesh.add_line(std::vector<Index>{5});
  const MeshItemPtr item = make_mesh_item(mesh);
  CHECK(item->edges.size() == 2 * 17);
  CHECK(item->segments == std::vector<std::uint32_t>{0, 1, 1, 2, 2, 3});
}

TEST_CASE("what can not be drawn is refused but what has no area is drawn as nothing") {
  PolyMesh broken = test::cube();
  broken.corners[0] = 99;
  CHECK_THROWS_AS(make_mesh_item(broken), Error);
  PolyMesh infinite = test::cube();
  infinite.positions[0].x() = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(make_mesh_item(infinite), Error);
  PolyMesh flat = test::cube();
  for (Vec3& position : flat.positions) position.setConstant(2);
  CHECK(make_mesh_item(flat)->triangles.size() == 36);
  CHECK(make_mesh_item(PolyMesh())->bounds.empty());
}
