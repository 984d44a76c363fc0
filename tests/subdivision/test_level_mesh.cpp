// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/subdivision/level_mesh.h"
#include "subdivision/random_tags.h"
#include "subdivision/subdivided.h"
#include "support/meshes/cages.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"
#include "support/sample_count.h"

namespace croquis::test {
namespace {

using subdivision::FaceKind;
using subdivision::FaceOrigin;
using subdivision::HalfEdges;
using subdivision::PointKind;
using subdivision::Rules;

std::vector<double> sharpness_of(const subdivision::Level& level) {
  std::vector<double> values;
  for (const auto& tag : level.sharp) values.push_back(tag.sharpness);
  std::sort(values.begin(), values.end());
  return values;
}

TEST_CASE("subdividing a level's mesh goes on where the level stopped") {
  const std::vector<NamedCage> cages = all_cages();
  const int configurations = sample_count(120, 2000);
  for (int i = 0; i < configurations; ++i) {
    const NamedCage& cage = cages[static_cast<std::size_t>(i) % cages.size()];
    INFO(cage.name << ", seed " << i);
    Random random(static_cast<std::uint64_t>(i));
    const Rules rules = random_rules(random);
    PolyMesh mesh = cage.mesh;
    for (Vec3& point : mesh.positions) point += 0.1 * Vec3(random.unit(), random.unit(), random.unit());
    add_random_tags(mesh, random, i % 2 == 0);

    const Subdivided whole = subdivide(mesh, 3, rules);
    for (int k = 1; k <= 2; ++k) {
      const Subdivided rest = subdivide(to_mesh(whole.plan.level(k), whole.points(k)), 3 - k, rules);
      CHECK(counts(rest.topology(3 - k)) == counts(whole.topology(3)));
      CHECK(faces_by_size(rest.topology(3 - k)) == faces_by_size(whole.topology(3)));
      CHECK(same_points(rest.points(3 - k), whole.points(3), 1e-12));
      const auto left = sharpness_of(rest.plan.level(3 - k)), expected = sharpness_of(whole.plan.level(3));
      REQUIRE(left.size() == expected.size());
      CHECK(std::equal(left.begin(), left.end(), expected.begin(),
                       [](double a, double b) { return a == b || std::abs(a - b) < 1e-12; }));
      CHECK(rest.plan.level(3 - k).pins.size() == whole.plan.level(3).pins.size());
    }
  }
}

std::set<Index> origins_of_face(const Subdivided& result, int k, Index face) {
  std::set<Index> origins;
  for (const Index v : result.topology(k).face(face)) origins.insert(result.plan.vertex_origin(k, v).vertex);
  return origins;
}

std::set<Index> element_vertices(const HalfEdges& mesh, const FaceOrigin& origin) {
  if (origin.kind == FaceKind::Vertex) return {origin.element};
  if (origin.kind == FaceKind::Face) {
    const auto face = mesh.face(origin.element);
    return {face.begin(), face.end()};
  }
  const auto ends = edge_ends(mesh, origin.element);
  return {ends.begin(), ends.end()};
}

TEST_CASE("faces and vertices know what they were born from") {
  const std::vector<NamedCage> cages = all_cages();
  for (int i = 0; i < 60; ++i) {
    const NamedCage& cage = cages[static_cast<std::size_t>(i) % cages.size()];
    INFO(cage.name << ", seed " << i);
    Random random(static_cast<std::uint64_t>(500 + i));
    PolyMesh mesh = cage.mesh;
    add_random_tags(mesh, random, i % 2 == 0);
    const Subdivided result = subdivide(mesh, 2, random_rules(random));
    for (int k = 1; k <= 2; ++k) {
      std::array<std::set<Index>, 4> born;
      for (Index face = 0; face < result.topology(k).face_count(); ++face) {
        const FaceOrigin origin = result.plan.face_origin(k, face);
        born[static_cast<std::size_t>(origin.kind)].insert(origin.element);
        // All corners stand for vertices of the element that the face was born from, and for all of these.
        CHECK(origins_of_face(result, k, face) == element_vertices(result.topology(k - 1), origin));
      }
      CHECK(born[0].size() == result.topology(k - 1).face_count());
      const auto weights = result.plan.weights(k);
      for (Index v = 0; v < result.topology(k).vertex_count(); ++v) {
        const auto origin = result.plan.vertex_origin(k, v);
        CHECK(weights.coeff(static_cast<int>(v), static_cast<int>(origin.vertex)) > 0);
        if (origin.kind == PointKind::Corner) {
          CHECK(result.topology(k - 1).corner_vertex[origin.element] == origin.vertex);
        }
      }
    }
  }
}

TEST_CASE("every level's elements lead to the cage's") {
  const Subdivided result = subdivide(bolt_loop(), 3);
  const PolyMesh mesh = to_mesh(result.plan, 3, result.points(3));
  const auto* kinds = mesh.channel("cage_kind", Domain::Face);
  const auto* elements = mesh.channel("cage_element", Domain::Face);
  const auto* vertices = mesh.channel("cage_vertex", Domain::Vertex);
  REQUIRE((kinds != nullptr && elements != nullptr && vertices != nullptr));
  CHECK(validate(mesh).empty());
  // 14 faces, 24 smooth edges, and 12 vertices beside the chain; each has faces that descend from it.
  std::array<std::set<Index>, 4> born;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    born[std::get<std::vector<std::uint32_t>>(kinds->data)[f]].insert(
        std::get<std::vector<std::uint32_t>>(elements->data)[f]);
  }
  CHECK(born[0].size() == 14);
  CHECK(born[1].size() == 24);
  CHECK(born[2].size() == 12);
  CHECK(born[3].empty());
  const auto& cage_vertices = std::get<std::vector<std::uint32_t>>(vertices->data);
  CHECK(std::set<Index>(cage_vertices.begin(), cage_vertices.end()).size() == 16);
  // Corners of the head descend from its own corners.
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    const Vec3& p = mesh.positions[v];
    if (p.x() > 1.2 && p.y() > 1.2 && p.z() > 0.7) CHECK(cage_vertices[v] == 2);
  }
}

TEST_CASE("tags of a level's mesh are what is left of them") {
  PolyMesh mesh = bolt_loop();
  mesh.tags.creases[0].sharpness = 2.5;
  mesh.tags.pins = {9};
  const Subdivided result = subdivide(mesh, 2);
  const PolyMesh once = to_mesh(result.plan.level(1), result.points(1));
  REQUIRE(once.tags.pins.size() == 1);
  CHECK(once.positions[once.tags.pins[0]] == mesh.positions[9]);
  std::vector<double> left;
  for (const Crease& crease : once.tags.creases) left.push_back(crease.sharpness);
  // The child, the chord at vertex 8, and the edge from the child to the pinned vertex.
  CHECK(std::count(left.begin(), left.end(), 1.5) == 3);
  const PolyMesh twice = to_mesh(result.plan.level(2), result.points(2));
  CHECK(std::any_of(twice.tags.creases.begin(), twice.tags.creases.end(),
                    [](const Crease& crease) { return crease.sharpness == 0.5; }));
}

}  // namespace
}  // namespace croquis::test
