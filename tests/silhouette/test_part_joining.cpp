// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include <catch2/catch.hpp>

#include "algorithms/silhouette/joining/joining.h"
#include "silhouette/solids.h"
#include "support/meshes/mesh_shapes.h"

using namespace croquis;
using namespace croquis::silhouette;

namespace {

constexpr double no_sliver = 1e-6;

PolyMesh ball_at(const Vec3& centre, double radius) {
  PolyMesh ball = test::triangulated(test::uv_sphere(24, 12));
  for (Vec3& position : ball.positions) position = centre + radius * position;
  return ball;
}

PartJoining joined(const std::vector<PolyMesh>& meshes, const std::vector<ObjectPair>& pairs) {
  std::vector<Shell> shells;
  for (const PolyMesh& mesh : meshes) shells.push_back({mesh, {static_cast<Index>(shells.size())}});
  std::vector<const Shell*> parts;
  for (const Shell& shell : shells) parts.push_back(&shell);
  Progress progress;
  return join_parts(parts, pairs, no_sliver, progress);
}

void check_sound(const PolyMesh& mesh) {
  test::check_sound(mesh);
  CHECK(test::report_of(mesh).components == 1);
}

}  // namespace

TEST_CASE("parts are joined along their pairs, the largest first") {
  const PartJoining result =
      joined({ball_at({2.7, 0, 0}, 1), ball_at({0, 0, 0}, 2), ball_at({3.9, 0.2, 0.1}, 0.7)}, {{0, 1}, {0, 2}});
  CHECK(result.failed.empty());
  REQUIRE(result.groups.size() == 1);
  CHECK(result.groups.front().objects == std::vector<Index>{1, 0, 2});
  check_sound(result.groups.front().mesh);
}

TEST_CASE("a pair that doesn't meet is named and the others are joined") {
  const PartJoining result =
      joined({ball_at({0, 0, 0}, 2), ball_at({2.6, 0.1, 0}, 1), ball_at({9, 0, 0}, 1)}, {{0, 1}, {0, 2}, {1, 2}});
  REQUIRE(result.failed.size() == 2);
  CHECK(result.failed[0].pair == ObjectPair{0, 2});
  CHECK(result.failed[1].pair == ObjectPair{1, 2});
  for (const FailedJoin& failed : result.failed) CHECK(failed.fault == JoinFault::DontMeet);
  REQUIRE(result.groups.size() == 1);
  CHECK(result.groups.front().objects == std::vector<Index>{0, 1});
  check_sound(result.groups.front().mesh);
}

TEST_CASE("a pair without a sound union is named and the others are joined") {
  // Two boxes that share a piece of one edge only: their union is no manifold.
  PolyMesh box = test::triangulated(test::cube());
  PolyMesh other = box;
  for (Vec3& position : other.positions) position += Vec3(1, 1, 0.5);
  PolyMesh third = box;
  for (Vec3& position : third.positions) position = 0.6 * position + Vec3(-0.5, 0.2, 0.2);
  const PartJoining result = joined({box, other, third}, {{0, 1}, {0, 2}});
  REQUIRE(result.failed.size() == 1);
  CHECK(result.failed.front().pair == ObjectPair{0, 1});
  REQUIRE(result.groups.size() == 1);
  CHECK(result.groups.front().objects == std::vector<Index>{0, 2});
}

TEST_CASE("groups that no pair links stay surfaces of their own") {
  const PartJoining result =
      joined({ball_at({0, 0, 0}, 2), ball_at({2.2, 0.1, 0}, 1), ball_at({9, 0, 0}, 1.5), ball_at({10, 0.3, 0}, 1)},
             {{0, 1}, {2, 3}});
  CHECK(result.failed.empty());
  CHECK(result.groups.size() == 2);
}
