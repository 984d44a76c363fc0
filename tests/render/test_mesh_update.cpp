// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstring>
#include <limits>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/render/mesh_item.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"

using namespace croquis;
using namespace croquis::render;

namespace {

/// Only tags part normals: what a subdivided surface is shown with.
MeshItemOptions tags_alone() {
  MeshItemOptions options;
  options.crease_angle = M_PI;
  return options;
}

void tag_face_edges(PolyMesh& mesh, Index face, double sharpness) {
  const auto corners = mesh.face(face);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    mesh.tags.creases.push_back({{corners[i], corners[(i + 1) % corners.size()]}, sharpness});
  }
}

/// A little away from where it was, nowhere the same.
PolyMesh stirred(PolyMesh mesh, std::uint64_t seed) {
  test::Random random(seed);
  for (Vec3& position : mesh.positions) {
    position += 1e-3 * Vec3(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
  }
  return mesh;
}

template <typename Array>
bool same_bytes(const Array& a, const Array& b) {
  return a.size() == b.size() && (a.size() == 0 || std::memcmp(a.data(), b.data(), a.size() * sizeof(*a.data())) == 0);
}

void check_equal(const MeshItem& a, const MeshItem& b) {
  CHECK(a.origin == b.origin);
  CHECK(a.scale == b.scale);
  CHECK(a.bounds.min == b.bounds.min);
  CHECK(a.bounds.max == b.bounds.max);
  CHECK(same_bytes(a.vertices, b.vertices));
  CHECK(same_bytes(a.line_vertices, b.line_vertices));
  CHECK(a.paint == b.paint);
  CHECK(a.triangles == b.triangles);
  CHECK(a.edges == b.edges);
  CHECK(a.segments == b.segments);
  CHECK(a.patch_count == b.patch_count);
  CHECK(a.edge_length == b.edge_length);
}

PolyMesh shape(int number) {
  switch (number) {
    case 0: return test::torus(24, 12);
    case 1: return test::uv_sphere(16, 8);
    case 2: return test::triangulated(test::torus(9, 7));
    case 3: return test::tetrahedra_sharing_edge();
    default: break;
  }
  PolyMesh mesh = test::double_torus();
  tag_face_edges(mesh, 3, infinite_sharpness);
  mesh.add_line(std::vector<Index>{0, 5, 9});
  return mesh;
}

}  // namespace

TEST_CASE("a ring of sharp tags parts normals on a surface that is smooth otherwise") {
  PolyMesh cube = test::cube();
  tag_face_edges(cube, 0, infinite_sharpness);
  const MeshItemPtr item = make_mesh_item(cube, tags_alone());
  CHECK(item->patch_count == 2);
  CHECK(item->vertices.size() == 4 + 4 + 4);
  // The lid is flat as far as light goes, to its very corners.
  const auto lid = cube.face(0);
  const Vec3 normal =
      (cube.positions[lid[1]] - cube.positions[lid[0]]).cross(cube.positions[lid[2]] - cube.positions[lid[1]]);
  int straight = 0;
  for (const SurfaceVertex& vertex : item->vertices) {
    straight += vertex.normal == glm::vec3(normal.x(), normal.y(), normal.z()) ? 1 : 0;
  }
  CHECK(straight == 4);
}

TEST_CASE("tags below the sharpness asked for, and a single tagged edge, part nothing") {
  PolyMesh soft = test::cube();
  tag_face_edges(soft, 0, 0.5);
  CHECK(make_mesh_item(soft, tags_alone())->vertices.size() == 8);
  MeshItemOptions any = tags_alone();
  any.split_sharpness = 0.25;
  CHECK(make_mesh_item(soft, any)->vertices.size() == 12);
  PolyMesh single = test::cube();
  single.tags.creases.push_back({{single.corners[0], single.corners[1]}, infinite_sharpness});
  CHECK(make_mesh_item(single, tags_alone())->vertices.size() == 8);
  PolyMesh foreign = test::cube();
  foreign.tags.creases.push_back({{0, 99}, infinite_sharpness});
  CHECK(make_mesh_item(foreign, tags_alone())->vertices.size() == 8);
}

TEST_CASE("flat shading gives every corner its face's normal and keeps the patches") {
  const PolyMesh sphere = test::uv_sphere(12, 6);
  MeshItemOptions options;
  options.shading = FaceShading::Flat;
  const MeshItemPtr item = make_mesh_item(sphere, options);
  CHECK(item->vertices.size() == sphere.corners.size());
  CHECK(item->patch_count == 1);
  for (std::size_t t = 0; t < item->triangles.size(); t += 3) {
    const glm::vec3 a = item->vertices[item->triangles[t]].position;
    const glm::vec3 b = item->vertices[item->triangles[t + 1]].position;
    const glm::vec3 c = item->vertices[item->triangles[t + 2]].position;
    const glm::vec3 normal = glm::normalize(glm::cross(b - a, c - a));
    for (int i = 0; i < 3; ++i) {
      const glm::vec3 used = item->vertices[item->triangles[t + static_cast<std::size_t>(i)]].normal;
      CHECK(glm::dot(normal, used) > 0.9999F);
    }
  }
}

TEST_CASE("corners' own normals are used when asked for, where they are there") {
  PolyMesh mesh = test::grid(1, 1);
  const double none = std::numeric_limits<double>::quiet_NaN();
  mesh.channels.push_back(
      {"normal", Domain::Corner, 3, std::vector<double>{2, 0, 0, 0, -1, 0, 0, 0, -5, none, none, none}, {}});
  CHECK(make_mesh_item(mesh)->vertices[0].normal == glm::vec3(0, 0, 1));
  MeshItemOptions options;
  options.use_normal_channel = true;
  const MeshItemPtr item = make_mesh_item(mesh, options);
  REQUIRE(item->vertices.size() == 4);
  CHECK(item->vertices[0].normal == glm::vec3(1, 0, 0));
  CHECK(item->vertices[1].normal == glm::vec3(0, -1, 0));
  CHECK(item->vertices[2].normal == glm::vec3(0, 0, -1));
  CHECK(item->vertices[3].normal == glm::vec3(0, 0, 1));
  std::get<std::vector<double>>(mesh.channels[0].data)[0] = -2;
  const MeshItemPtr updated = update_mesh_item(item, mesh);
  CHECK(updated->vertices[0].normal == glm::vec3(-1, 0, 0));
  CHECK(updated->triangles.data() == item->triangles.data());
}

TEST_CASE("an update equals a fresh item bit for bit and shares what has not changed") {
  const PolyMesh mesh = shape(GENERATE(range(0, 5)));
  MeshItemOptions options = tags_alone();
  options.shading = GENERATE(FaceShading::Smooth, FaceShading::Flat);
  MeshItemPtr item = make_mesh_item(mesh, options);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const PolyMesh moved = stirred(mesh, seed);
    const MeshItemPtr updated = update_mesh_item(item, moved);
    check_equal(*updated, *make_mesh_item(moved, options));
    // How a polygon with more corners is cut depends on where they are.
    if (mesh.corners.size() == 3 * mesh.face_count()) CHECK(updated->triangles.data() == item->triangles.data());
    CHECK(updated->edges.data() == item->edges.data());
    CHECK(updated->paint.data() == item->paint.data());
    CHECK_FALSE(same_bytes(updated->vertices, item->vertices));
    check_equal(*update_mesh_item(item, moved.positions), *updated);
    item = updated;
  }
}

TEST_CASE("a mesh with other faces, lines, tags or colours is made anew with the item's own options") {
  const PolyMesh mesh = test::torus(12, 8);
  const MeshItemOptions options = tags_alone();
  const MeshItemPtr item = make_mesh_item(mesh, options);
  PolyMesh other = mesh;
  SECTION("faces") { other = test::without_faces(mesh, std::vector<Index>{4}); }
  SECTION("lines") { other.add_line(std::vector<Index>{0, 1}); }
  SECTION("tags") { tag_face_edges(other, 7, 2); }
  SECTION("colours") {
    std::vector<std::uint8_t> colors(3 * mesh.face_count(), 90);
    other.channels.push_back({"color", Domain::Face, 3, colors, {}});
  }
  const MeshItemPtr updated = update_mesh_item(item, other);
  check_equal(*updated, *make_mesh_item(other, options));
  CHECK(updated->plan != item->plan);
  check_equal(*update_mesh_item(nullptr, other, options), *updated);
}

TEST_CASE("vertices that left their common place are told apart by an update") {
  PolyMesh mesh = test::merged(test::grid(1, 1), test::translated(test::grid(1, 1), {1, 0, 0}));
  const MeshItemPtr item = make_mesh_item(mesh);
  CHECK(item->vertices.size() == 6);
  for (std::size_t v = 4; v < 8; ++v) mesh.positions[v].x() += 0.5;
  const MeshItemPtr updated = update_mesh_item(item, mesh);
  CHECK(updated->vertices.size() == 8);
  check_equal(*updated, *make_mesh_item(mesh));
}

TEST_CASE("an update refuses coordinates that are no numbers") {
  PolyMesh mesh = test::torus(6, 5);
  const MeshItemPtr item = make_mesh_item(mesh);
  mesh.positions[3].y() = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(update_mesh_item(item, mesh), Error);
  CHECK_THROWS_AS(update_mesh_item(item, mesh.positions), Error);
  mesh.positions.pop_back();
  CHECK_THROWS_AS(update_mesh_item(item, mesh.positions), Error);
}
