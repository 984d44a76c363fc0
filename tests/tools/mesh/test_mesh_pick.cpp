// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "croquis/mesh_editing/mesh_selection.h"
#include "croquis/tools/mesh/mesh_pick.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"
#include "tools/pointer/face_tree.h"
#include "tools/pointer/mesh_views.h"

namespace croquis {
namespace {

using test::TestCamera;

struct Scene {
  std::shared_ptr<const PolyMesh> mesh;
  std::shared_ptr<const MeshTopology> topology;
  MeshPicker picker;

  explicit Scene(PolyMesh given)
      : mesh(std::make_shared<const PolyMesh>(std::move(given))),
        topology(std::make_shared<const MeshTopology>(*mesh)),
        picker(mesh, topology) {}
};

TestCamera camera_from(const Vec3& eye, bool perspective = true) {
  TestCamera camera;
  camera.eye = eye;
  camera.perspective = perspective;
  camera.half_height = perspective ? 0.4 : 2;
  camera.up = std::abs(eye.normalized().y()) > 0.9 ? Vec3(Vec3::UnitZ()) : Vec3(Vec3::UnitY());
  return camera;
}

Vec3 random_direction(test::Random& random) {
  Vec3 direction;
  do {
    direction = {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
  } while (direction.norm() > 1 || direction.norm() < 0.1);
  return direction.normalized();
}

/// Distances of the triangles that a ray meets, each tried alone with another method (Möller and Trumbore 1997).
double first_triangle_hit(const PolyMesh& triangles, const Ray& ray) {
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t f = 0; f < triangles.face_count(); ++f) {
    const auto corners = triangles.face(f);
    const Vec3& a = triangles.positions[corners[0]];
    const Vec3 u = triangles.positions[corners[1]] - a;
    const Vec3 v = triangles.positions[corners[2]] - a;
    const Vec3 p = ray.direction.cross(v);
    const double det = u.dot(p);
    if (std::abs(det) < 1e-14) continue;
    const Vec3 s = ray.origin - a;
    const double x = s.dot(p) / det;
    const double y = ray.direction.dot(s.cross(u)) / det;
    const double t = v.dot(s.cross(u)) / det;
    if (x >= 0 && y >= 0 && x + y <= 1 && t > 0) best = std::min(best, t);
  }
  return best;
}

TEST_CASE("the tree and the look at every face without it find the face that trying every triangle finds") {
  test::Random random(7);
  for (const PolyMesh& mesh : {test::triangulated(test::torus(24, 16)), test::random_soup(3, 700),
                               test::random_soup(4, 20'000), test::uv_sphere(3, 2)}) {
    Scene scene{test::triangulated(mesh)};
    for (int i = 0; i < 400; ++i) {
      const Vec3 eye = 4 * random_direction(random);
      const Vec3 target = 1.2 * random_direction(random) * random.unit();
      const Ray ray{eye, (target - eye).normalized()};
      const double expected = first_triangle_hit(*scene.mesh, ray);
      const auto hit = scene.picker.face_under(ray);
      const auto without = face_under(*scene.mesh, ray);
      REQUIRE(hit.has_value() == (expected < 1e300));
      REQUIRE(without.has_value() == hit.has_value());
      if (!hit) continue;
      CHECK(without->element == hit->element);
      CHECK(without->distance == hit->distance);
      CHECK(hit->distance == Approx(expected).epsilon(1e-9));
      CHECK((hit->place - ray.at(hit->distance)).norm() == 0);
    }
  }
}

TEST_CASE("rays through edges and vertices of a closed surface never slip through") {
  Scene scene{test::uv_sphere(16, 9)};
  test::Random random(8);
  for (int i = 0; i < 400; ++i) {
    const Vec3 eye = 5 * random_direction(random);
    const Index edge = random.below(static_cast<Index>(scene.topology->edge_count()));
    const auto [a, b] = scene.topology->edge_vertices(edge);
    const double t = i % 3 == 0 ? 0 : random.unit();
    const Vec3 place = scene.mesh->positions[a] + t * (scene.mesh->positions[b] - scene.mesh->positions[a]);
    // A little inwards, so that the silhouette itself isn't asked.
    const Ray ray{eye, (0.98 * place - eye).normalized()};
    CHECK(scene.picker.face_under(ray));
    CHECK(scene.picker.face_under({Vec3::Zero(), place.normalized()}));
  }
}

TEST_CASE("a moved mesh is picked where it is now, and the tree's memory of the old place is gone") {
  Scene scene{test::torus(20, 12)};
  const Ray ray{{1, 0, 5}, -Vec3::UnitZ()};
  CHECK(scene.picker.face_under(ray));
  scene.picker.move_to(std::make_shared<const PolyMesh>(test::translated(*scene.mesh, {10, 0, 0})));
  CHECK_FALSE(scene.picker.face_under(ray));
  CHECK(scene.picker.face_under({{11, 0, 5}, -Vec3::UnitZ()}));
}

TEST_CASE("concave polygons are hit inside and missed in their bay") {
  PolyMesh mesh;
  // A letter U of 8 corners, and a quad with a reflex corner (an arrow head).
  mesh.positions = {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {2, 3, 0}, {2, 1, 0}, {1, 1, 0},
                    {1, 3, 0}, {0, 3, 0}, {5, 0, 0}, {6, 1, 0}, {5, 3, 0}, {5.5, 1, 0}};
  mesh.add_face(std::vector<Index>{0, 1, 2, 3, 4, 5, 6, 7});
  mesh.add_face(std::vector<Index>{8, 9, 10, 11});
  for (int turn = 0; turn < 4; ++turn) {
    PolyMesh turned = mesh;
    std::rotate(turned.corners.begin() + 8, turned.corners.begin() + 8 + turn, turned.corners.end());
    Scene scene{turned};
    const auto face_at = [&](double x, double y) {
      const auto hit = scene.picker.face_under({{x, y, 2}, -Vec3::UnitZ()});
      return hit ? hit->element : no_index;
    };
    CHECK(face_at(0.5, 2.5) == 0);
    CHECK(face_at(2.5, 2.5) == 0);
    CHECK(face_at(1.5, 0.5) == 0);
    CHECK(face_at(1.5, 2.0) == no_index);
    CHECK(face_at(5.7, 1) == 1);
    CHECK(face_at(5.2, 1) == no_index);
  }
}

TEST_CASE("a polygon with many corners gives the depth of its plane") {
  PolyMesh mesh;
  std::vector<Index> disc;
  for (Index i = 0; i < 40; ++i) {
    const double angle = 2 * 3.14159265358979 * i / 40;
    disc.push_back(i);
    mesh.positions.push_back({std::cos(angle), std::sin(angle), 0.5 * std::cos(angle)});
  }
  mesh.add_face(disc);
  Scene scene{mesh};
  const auto hit = scene.picker.face_under({{0.4, 0.3, 5}, -Vec3::UnitZ()});
  REQUIRE(hit);
  CHECK(hit->place.z() == Approx(0.2));
}

/// The convex body's own visibility: a vertex is seen if one of its faces looks at the eye.
std::vector<char> facing_vertices(const Scene& scene, const TestCamera& camera) {
  std::vector<char> facing(scene.mesh->vertex_count(), 0);
  for (std::size_t f = 0; f < scene.mesh->face_count(); ++f) {
    const auto corners = scene.mesh->face(f);
    const Vec3& a = scene.mesh->positions[corners[0]];
    const Vec3 normal = (scene.mesh->positions[corners[1]] - a).cross(scene.mesh->positions[corners[2]] - a);
    const Vec3 view = camera.perspective ? Vec3(camera.eye - a) : Vec3(-camera.forward());
    if (normal.dot(view) <= 0) continue;
    for (const Index v : corners) facing[v] = 1;
  }
  return facing;
}

TEST_CASE("of a convex body exactly the vertices of faces that look at the eye are picked") {
  test::Random random(9);
  for (int round = 0; round < 12; ++round) {
    Scene scene{round % 3 == 0 ? test::cube() : test::uv_sphere(9, 6)};
    const TestCamera camera = camera_from(6 * random_direction(random), round % 2 == 0);
    const ViewFrame frame = camera.frame();
    const std::vector<char> facing = facing_vertices(scene, camera);
    for (Index v = 0; v < scene.mesh->vertex_count(); ++v) {
      const Vec2 pixel = camera.pixel_of(scene.mesh->positions[v]);
      const auto picked = scene.picker.at(frame, pixel, ComponentKind::Vertex, {0.01, false});
      CHECK(picked.has_value() == (facing[v] != 0));
      if (picked) CHECK(picked->element == v);
      CHECK(scene.picker.at(frame, pixel, ComponentKind::Vertex, {0.01, true}).has_value());
    }
  }
}

TEST_CASE("boxes find what the picking of single elements finds") {
  test::Random random(10);
  for (int round = 0; round < 8; ++round) {
    Scene scene{round % 2 == 0 ? test::torus(14, 9) : test::double_torus()};
    const TestCamera camera = camera_from(5 * random_direction(random) + Vec3(0.5, 0.5, 0.2), round % 3 != 0);
    const ViewFrame frame = camera.frame();
    const PickBox box = PickBox::spanned({random.between(0, 800), random.between(0, 600)},
                                         {random.between(0, 800), random.between(0, 600)});
    const Elements seen = scene.picker.in_box(frame, box, ComponentKind::Vertex);
    const Elements through = scene.picker.in_box(frame, box, ComponentKind::Vertex, true);
    Elements expected_seen, expected_through;
    for (Index v = 0; v < scene.mesh->vertex_count(); ++v) {
      const Vec2 pixel = camera.pixel_of(scene.mesh->positions[v]);
      if ((pixel.array() < box.low.array()).any() || (pixel.array() > box.high.array()).any()) continue;
      if ((pixel.array() < 0).any() || pixel.x() > 800 || pixel.y() > 600) continue;
      expected_through.push_back(v);
      Elements faces;
      for (const Index c : scene.topology->vertex_corners(v)) faces.push_back(scene.topology->face(c));
      if (scene.picker.visible(frame, scene.mesh->positions[v], sorted_unique(faces))) expected_seen.push_back(v);
    }
    CHECK(through == expected_through);
    // The grid may take a place within a cell of an edge for seen; never more than that.
    const Elements differing = toggled(seen, expected_seen);
    CHECK(differing.size() <= 1 + expected_seen.size() / 20);
  }
}

TEST_CASE("a box over one face of a cube picks that face and the rim around it") {
  Scene scene{test::cube()};
  TestCamera camera = camera_from({0.5, 0.5, 6});
  camera.target = {0.5, 0.5, 0};
  const ViewFrame frame = camera.frame();
  const PickBox box = PickBox::spanned(camera.pixel_of({-0.1, -0.1, 1}), camera.pixel_of({1.1, 1.1, 1}));
  const auto at_top = [&](Index v) { return scene.mesh->positions[v].z() == 1; };
  const Elements vertices = scene.picker.in_box(frame, box, ComponentKind::Vertex);
  CHECK(vertices.size() == 4);
  CHECK(std::all_of(vertices.begin(), vertices.end(), at_top));
  const Elements faces = scene.picker.in_box(frame, box, ComponentKind::Face);
  REQUIRE(faces.size() == 1);
  CHECK(scene.picker.in_box(frame, box, ComponentKind::Edge) ==
        converted(*scene.topology, ComponentKind::Face, ComponentKind::Edge, faces));
  CHECK(scene.picker.in_box(frame, box, ComponentKind::Vertex, true).size() == 8);
  CHECK(scene.picker.in_box(frame, box, ComponentKind::Edge, true).size() == 12);
  CHECK(scene.picker.in_box(frame, box, ComponentKind::Face, true).size() == 6);
  // A box inside a face has no vertex and no edge, but the face.
  const PickBox inside = PickBox::spanned(camera.pixel_of({0.4, 0.4, 1}), camera.pixel_of({0.6, 0.6, 1}));
  CHECK(scene.picker.in_box(frame, inside, ComponentKind::Vertex, true).empty());
  CHECK(scene.picker.in_box(frame, inside, ComponentKind::Edge, true).empty());
  CHECK(scene.picker.in_box(frame, inside, ComponentKind::Face).size() == 1);
  CHECK(scene.picker.in_box(frame, inside, ComponentKind::Face, true).size() == 2);
}

TEST_CASE("the nearest visible edge is picked with its place, also when it passes behind the eye") {
  Scene scene{test::cube()};
  TestCamera camera = camera_from({0.5, 0.5, 6});
  camera.target = {0.5, 0.5, 0};
  const Vec2 pixel = camera.pixel_of({0.25, 1, 1}) + Vec2(0, -3);
  const auto picked = scene.picker.at(camera.frame(), pixel, ComponentKind::Edge);
  REQUIRE(picked);
  CHECK(picked->distance == Approx(3));
  CHECK((picked->place - Vec3(0.25, 1, 1)).norm() < 1e-9);
  const auto [a, b] = scene.topology->edge_vertices(picked->element);
  const Vec3 along =
      scene.mesh->positions[a] + picked->parameter * (scene.mesh->positions[b] - scene.mesh->positions[a]);
  CHECK((along - picked->place).norm() < 1e-9);

  PolyMesh road;  // reaches from far in front of the eye to far behind it
  road.positions = {{-1, -1, -50}, {1, -1, -50}, {1, -1, 50}, {-1, -1, 50}};
  road.add_face(std::vector<Index>{0, 1, 2, 3});
  Scene behind{road};
  const TestCamera low = camera_from({0, 0, 5});
  const auto edge = behind.picker.at(low.frame(), low.pixel_of({1, -1, 0}), ComponentKind::Edge);
  REQUIRE(edge);
  CHECK((edge->place - Vec3(1, -1, 0)).norm() < 1e-6);
  const PickBox all{{0, 0}, low.size};
  CHECK(behind.picker.in_box(low.frame(), all, ComponentKind::Edge).size() == 3);
  CHECK(behind.picker.in_box(low.frame(), all, ComponentKind::Face).size() == 1);
  CHECK(behind.picker.in_box(low.frame(), all, ComponentKind::Vertex).size() == 2);
}

TEST_CASE("twins of soup at one place and vertices without faces can be picked") {
  Scene soup{test::triangulated(test::random_soup(1, 1))};
  const TestCamera camera = camera_from({0.5, 0.5, 6});
  for (Index v = 0; v < 3; ++v)
    CHECK(
        soup.picker.at(camera.frame(), camera.pixel_of(soup.mesh->positions[v]), ComponentKind::Vertex, {0.01, false}));
  PolyMesh points;
  points.positions = {{0, 0, 0}, {1, 1, 0}};
  Scene cloud{points};
  const auto picked = cloud.picker.at(camera.frame(), camera.pixel_of({1, 1, 0}), ComponentKind::Vertex);
  REQUIRE(picked);
  CHECK(picked->element == 1);
  CHECK(cloud.picker.in_box(camera.frame(), {{0, 0}, {800, 600}}, ComponentKind::Vertex) == Elements{0, 1});
  CHECK_FALSE(cloud.picker.face_under({{0, 0, 5}, -Vec3::UnitZ()}));
  // Two cubes that touch without sharing vertices: the silhouette of one doesn't hide the other's twin.
  PolyMesh cubes = test::merged(test::cube(), test::translated(test::cube(), {1, 0, 0}));
  Scene twins{cubes};
  TestCamera front = camera_from({1, 0.5, 6});
  front.target = {1, 0.5, 0};
  const Elements seen = twins.picker.in_box(front.frame(), {{0, 0}, {800, 600}}, ComponentKind::Vertex);
  CHECK(seen.size() == 8);
}

}  // namespace
}  // namespace croquis
