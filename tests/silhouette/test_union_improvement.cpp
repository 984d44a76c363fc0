// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "algorithms/silhouette/joining/joining.h"
#include "algorithms/silhouette/surface/certificate.h"
#include "silhouette/solids.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"

using namespace croquis;
using namespace croquis::silhouette;
using test::slender_share;

namespace {

/// A ball with a smaller one sunk into it, with slivers all along the seam.
Shell joined_balls(std::uint64_t seed) {
  test::Random random(seed);
  const PolyMesh big = test::triangulated(test::uv_sphere(40, 20));
  PolyMesh small = big;
  const double radius = random.between(0.4, 0.8);
  const Vec3 aside(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
  for (Vec3& position : small.positions) position = radius * position + aside.normalized();
  const Shell first{big, {0}}, second{small, {1}};
  const std::vector<const Shell*> parts{&first, &second};
  const std::vector<ObjectPair> pairs{{0, 1}};
  Progress progress;
  PartJoining joining = join_parts(parts, pairs, 1e-6, progress);
  REQUIRE(joining.groups.size() == 1);
  return std::move(joining.groups.front());
}

ImprovedUnion improved(const Shell& joined, const std::vector<std::uint8_t>& kept) {
  Progress progress;
  return improve_union(joined, kept, progress);
}

ImprovedUnion improved(const Shell& joined) {
  return improved(joined, std::vector<std::uint8_t>(joined.mesh.vertex_count(), 0));
}

/// The farthest that vertices of one mesh lie off the other's surface.
double farthest(const PolyMesh& from, const PolyMesh& to) {
  const TriangleTree tree = test::tree_of(to);
  double most = 0;
  for (const Vec3& position : from.positions) most = std::max(most, tree.nearest(position, 10).distance);
  return most;
}

/// Lines of edges where fronts and backs, or two objects, meet: their length.
double feature_length(const Shell& surface) {
  std::map<std::pair<Index, Index>, std::vector<Index>> sides;
  const PolyMesh& mesh = surface.mesh;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto c = mesh.face(f);
    const bool front = seen_area(mesh, f) > 0;
    for (std::size_t k = 0; k < 3; ++k) {
      sides[std::minmax(c[k], c[(k + 1) % 3])].push_back(2 * surface.face_objects[f] + (front ? 1 : 0));
    }
  }
  double length = 0;
  for (const auto& [edge, both] : sides) {
    if (both[0] != both[1]) length += (mesh.positions[edge.first] - mesh.positions[edge.second]).norm();
  }
  return length;
}

}  // namespace

TEST_CASE("the triangles of a joined surface become wide, and it stays what it was") {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    INFO(seed);
    const Shell before = joined_balls(seed);
    const ImprovedUnion result = improved(before);
    const Shell& after = result.surface;
    CHECK(slender_share(before.mesh) > 0.04);
    CHECK(slender_share(after.mesh) < 0.4 * slender_share(before.mesh));
    const MeshReport was = test::report_of(before.mesh), is = test::report_of(after.mesh);
    test::check_sound(after.mesh);
    CHECK(is.euler_characteristic == was.euler_characteristic);
    CHECK(*is.volume == Approx(*was.volume).epsilon(2e-3));
    constexpr double longest_edge = 0.16;
    CHECK(farthest(after.mesh, before.mesh) < 0.06 * longest_edge);
    CHECK(farthest(before.mesh, after.mesh) < 0.06 * longest_edge);
    CHECK(feature_length(after) == Approx(feature_length(before)).epsilon(5e-3));
    CHECK(after.face_objects.size() == after.mesh.face_count());
  }
}

TEST_CASE("triangles at kept vertices stay, and changed ones are reported") {
  const Shell before = joined_balls(3);
  std::vector<std::uint8_t> kept(before.mesh.vertex_count(), 0);
  for (Index v = 0; v < kept.size(); ++v) kept[v] = before.mesh.positions[v].x() > 0 ? 1 : 0;
  const ImprovedUnion result = improved(before, kept);
  const PolyMesh& after = result.surface.mesh;
  REQUIRE(result.vertices.size() == after.vertex_count());
  CHECK(!result.changed.empty());
  std::size_t same = 0;
  for (Index f = 0; f < after.face_count(); ++f) {
    if (std::binary_search(result.changed.begin(), result.changed.end(), f)) {
      for (const Index v : after.face(f)) CHECK(!kept[result.vertices[v]]);
      continue;
    }
    ++same;
    for (const Index v : after.face(f)) CHECK(after.positions[v] == before.mesh.positions[result.vertices[v]]);
  }
  CHECK(same > before.mesh.face_count() / 2);
  CHECK(improved(before, std::vector<std::uint8_t>(kept.size(), 1)).changed.empty());
}

TEST_CASE("meeting faces are found among those that are asked for") {
  PolyMesh one;
  one.positions = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {9, 9, 0}, {9, 8, 0}, {8, 9, 0}};
  one.add_triangle(0, 1, 2);
  one.add_triangle(3, 4, 5);
  PolyMesh other;
  other.positions = {{0.5, 0.5, -1}, {0.6, 0.5, 1}, {0.5, 0.7, 1}};
  other.add_triangle(0, 1, 2);
  const std::vector<const PolyMesh*> meshes{&one, &other};
  Progress progress;
  const auto count = [&](std::size_t mesh, Index face) {
    return meeting_faces(meshes, Rounding::None, 1, progress, MeshFaces{mesh, {&face, 1}}).size();
  };
  CHECK(count(0, 0) == 1);
  CHECK(count(0, 1) == 0);
  CHECK(count(1, 0) == 1);
}
