// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "algorithms/hole_filling/verification/patch_verification.h"
#include "croquis/base/error.h"
#include "croquis/geometry/self_intersection.h"
#include "support/meshes/mesh_shapes.h"
#include "support/scans/scans.h"

using namespace croquis;
using namespace croquis::test;
using namespace croquis::hole_filling;

namespace {

struct Scene {
  PolyMesh mesh;
  HoleAnalysis analysis;

  explicit Scene(PolyMesh given) : mesh(std::move(given)) {
    Progress progress;
    analysis = analyse_holes(mesh, progress);
  }

  Index first_new() const { return static_cast<Index>(mesh.vertex_count()); }

  std::vector<PatchVerdict> judge(const std::vector<HolePatch>& patches) const {
    Progress progress;
    PatchVerifier verifier(mesh, analysis);
    return verifier.accept_sound(patches, progress);
  }
  PatchVerdict judge(const HolePatch& patch) const { return judge(std::vector{patch}).front(); }

  /// The hole of four edges.
  const Hole* square_hole() const {
    const auto found =
        std::ranges::find(analysis.holes, std::size_t{4}, [](const Hole& h) { return h.vertices.size(); });
    REQUIRE(found != analysis.holes.end());
    return &*found;
  }

  /// A fan from a new vertex at `tip` to a rim.
  HolePatch fan(Index hole, const Vec3& tip) const {
    const auto& rim = analysis.holes[hole].vertices;
    HolePatch patch{{hole}, {tip}, {}};
    for (std::size_t i = 0; i < rim.size(); ++i)
      patch.triangles.push_back({rim[(i + 1) % rim.size()], rim[i], first_new()});
    return patch;
  }
};

/// Two tubes of the same size with a gap between: holes 1 and 2 face each other.
Scene gap() {
  const PolyMesh lower = open_tube(1, 2, 24, 4);
  return Scene(merged(lower, translated(lower, Vec3(0, 0, 2.6))));
}

/// Triangles between the two rims, vertex i of the first beside vertex shift ± i of the second.
HolePatch strip(const Scene& scene, bool reversed, std::size_t shift) {
  const auto& lower = scene.analysis.holes[1].vertices;
  const auto& upper = scene.analysis.holes[2].vertices;
  const std::size_t count = lower.size();
  // Rims run in opposite directions around the gap: the partner of vertex i goes backwards.
  const auto partner = [&](std::size_t i) { return upper[(reversed ? shift + i : shift + 2 * count - i) % count]; };
  HolePatch patch{{1, 2}, {}, {}};
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = (i + 1) % count;
    patch.triangles.push_back({lower[next], lower[i], partner(i)});
    if (reversed)
      patch.triangles.push_back({partner(next), partner(i), lower[next]});
    else
      patch.triangles.push_back({partner(next), lower[next], partner(i)});
  }
  return patch;
}

}  // namespace

TEST_CASE("a sound patch is taken and measured") {
  const Scene scene(cut(round_sphere(4), Vec3(0, 0, 1), 0.3).mesh);
  const PatchVerdict verdict = scene.judge(scene.fan(0, Vec3(0, 0, 1)));
  CHECK(verdict.fault == "");
  CHECK(verdict.max_normal_jump > 0);
  CHECK(verdict.max_normal_jump < 0.3);
  CHECK(verdict.min_angle > 0.05);
  CHECK(verdict.min_angle < 2 * std::numbers::pi / static_cast<double>(scene.analysis.holes[0].vertices.size()) * 1.2);
}

TEST_CASE("patches that hang together wrongly are refused") {
  const Scene scene(cut(round_sphere(4), Vec3(0, 0, 1), 0.3).mesh);
  const HolePatch good = scene.fan(0, Vec3(0, 0, 1));
  const auto fault_of = [&](auto&& spoil) {
    HolePatch bad = good;
    spoil(bad);
    return scene.judge(bad).fault;
  };
  CHECK(fault_of([](HolePatch& p) { p.triangles.clear(); }) == "the patch is empty");
  CHECK(fault_of([](HolePatch& p) { p.triangles.pop_back(); }) == "the patch's border isn't the rim");
  CHECK(fault_of([](HolePatch& p) {
          for (auto& t : p.triangles) std::swap(t[0], t[1]);
        }) == "the patch's border isn't the rim");
  CHECK(fault_of([](HolePatch& p) { std::swap(p.triangles[0][0], p.triangles[0][1]); }) ==
        "faces of the patch disagree in direction");
  CHECK(fault_of([](HolePatch& p) { p.triangles.push_back(p.triangles[3]); }) ==
        "an edge of the patch has more than two faces");
  CHECK(fault_of([](HolePatch& p) {
          p.triangles.push_back({p.triangles[0][0], p.triangles[0][1], p.triangles[0][0]});
        }) == "a triangle of the patch has no area");
  CHECK(fault_of([](HolePatch& p) { p.points[0].x() = std::nan(""); }) == "a coordinate isn't finite");
  CHECK(fault_of([&](HolePatch& p) {
          // A closed piece that floats beside it.
          const Index base = scene.first_new() + 1;
          for (const Vec3& corner : {Vec3(5, 0, 0), Vec3(6, 0, 0), Vec3(5, 1, 0), Vec3(5, 0, 1)})
            p.points.push_back(corner);
          p.triangles.push_back({base, base + 2, base + 1});
          p.triangles.push_back({base, base + 1, base + 3});
          p.triangles.push_back({base + 1, base + 2, base + 3});
          p.triangles.push_back({base + 2, base, base + 3});
        }) == "the patch isn't one simple piece");
}

TEST_CASE("patches that cut through something are refused") {
  const Scene scene(cut(round_sphere(4), Vec3(0, 0, 1), 0.3).mesh);
  CHECK(scene.judge(scene.fan(0, Vec3(0, 0, 0.8))).is_sound());
  CHECK_FALSE(scene.judge(scene.fan(0, Vec3(0, 0, -1.5))).is_sound());  // through the other side
  CHECK_FALSE(scene.judge(scene.fan(0, Vec3(1.5, 0, 0))).is_sound());
  CHECK_FALSE(scene.judge(scene.fan(0, scene.mesh.positions[scene.analysis.view.triangles[900][0]])).is_sound());
}

TEST_CASE("an edge that the mesh has already is refused") {
  // A saddle-shaped opening; a fin below has its lower diagonal, which a patch would have to share.
  PolyMesh mesh = without_faces(grid(3, 3), std::vector<Index>{4});
  mesh.positions[6].z() = mesh.positions[9].z() = 0.4;
  mesh.positions.emplace_back(1.5, 1.5, -1);
  const Index tip = static_cast<Index>(mesh.vertex_count()) - 1;
  mesh.add_triangle(5, 10, tip);
  const Scene scene(mesh);
  const Hole* const open = scene.square_hole();
  const auto& rim = open->vertices;
  const HolePatch over{{open->id}, {}, {{rim[2], rim[1], rim[0]}, {rim[0], rim[3], rim[2]}}};
  const HolePatch across{{open->id}, {}, {{rim[1], rim[0], rim[3]}, {rim[3], rim[2], rim[1]}}};
  const PatchVerdict lower = scene.judge(rim[0] == 5 ? over : across);
  const PatchVerdict upper = scene.judge(rim[0] == 5 ? across : over);
  CHECK(lower.fault == "an edge of the patch joins vertices that are joined already");
  CHECK(upper.fault == "");
}

TEST_CASE("of two patches that meet the first is taken, unless it is refused for other reasons") {
  const PolyMesh once = cut(round_sphere(4), Vec3(0, 0, 1), 0.3).mesh;
  const Scene scene(cut(once, Vec3(1, 0, 0), 0.3).mesh);
  REQUIRE(scene.analysis.holes.size() == 2);
  const Index top = scene.analysis.holes[0].centre.z() > 0.5 ? 0 : 1;
  const HolePatch down = scene.fan(top, Vec3(0.6, 0, 0));
  const HolePatch inwards = scene.fan(1 - top, Vec3(0, 0, 0.5));
  REQUIRE(scene.judge(down).is_sound());
  REQUIRE(scene.judge(inwards).is_sound());
  auto both = scene.judge({down, inwards});
  CHECK(both[0].is_sound());
  CHECK_FALSE(both[1].is_sound());
  const HolePatch through = scene.fan(top, Vec3(0.6, 0, -3));
  both = scene.judge({through, inwards});
  CHECK_FALSE(both[0].is_sound());
  CHECK(both[1].is_sound());

  Progress progress;
  PatchVerifier verifier(scene.mesh, scene.analysis);
  CHECK(verifier.accept_sound(std::vector{down}, progress)[0].is_sound());
  CHECK_FALSE(verifier.accept_sound(std::vector{inwards}, progress)[0].is_sound());
}

TEST_CASE("a twisted strip between two rims is refused though it is closed, manifold and turned one way") {
  const Scene scene = gap();
  REQUIRE(scene.analysis.holes[1].kind == HoleClass::Tunnel);
  std::size_t shift = 0;  // the vertex of the upper rim above the lower rim's first
  const auto& lower = scene.analysis.holes[1].vertices;
  const auto& upper = scene.analysis.holes[2].vertices;
  for (std::size_t i = 0; i < upper.size(); ++i) {
    if ((scene.mesh.positions[upper[i]] - scene.mesh.positions[lower[0]]).head<2>().norm() < 1e-9) shift = i;
  }
  CHECK(scene.judge(strip(scene, false, shift)).fault == "");
  CHECK(scene.judge(strip(scene, false, shift + 12)).fault == "the patch cuts through the surface or itself");
  // The upper rim taken in the wrong direction, which its own direction must hide: turn the upper tube over.
  const PolyMesh tube = open_tube(1, 2, 24, 4);
  const Scene turned(merged(tube, flipped(translated(tube, Vec3(0, 0, 2.6)))));
  const HolePatch twisted = strip(turned, false, 0);
  PolyMesh closed = turned.mesh;
  for (const auto& t : twisted.triangles) closed.add_face(t);
  Progress progress;
  CHECK(find_self_intersections(closed, progress).count > 20);
  CHECK(turned.judge(twisted).fault == "the patch cuts through the surface or itself");
}

TEST_CASE("coordinates are judged as they will be written") {
  // A tip so near to a triangle below that single precision puts it on it.
  PolyMesh mesh = without_faces(grid(3, 3), std::vector<Index>{4});
  const Index base = static_cast<Index>(mesh.vertex_count());
  for (const Vec3& p : {Vec3(1.2, 1.2, -1e-9), Vec3(1.8, 1.2, -1e-9), Vec3(1.5, 1.8, -1e-9)})
    mesh.positions.push_back(p);
  mesh.add_triangle(base, base + 1, base + 2);
  for (Vec3& p : mesh.positions) p.z() += 1000;
  const Scene scene(mesh);
  const Hole* const hole = scene.square_hole();
  const HolePatch patch = scene.fan(hole->id, Vec3(1.5, 1.5, 1000));
  Progress progress;
  PatchVerifier as_double(scene.mesh, scene.analysis, Precision::Double);
  CHECK(as_double.accept_sound(std::vector{patch}, progress)[0].is_sound());
  PatchVerifier as_single(scene.mesh, scene.analysis, Precision::Single);
  CHECK_FALSE(as_single.accept_sound(std::vector{patch}, progress)[0].is_sound());
}

TEST_CASE("a triangle that loses its area to single precision is refused where the file will have that") {
  // A new vertex so near to one of the rim that 32 bits hold both at one place.
  PolyMesh mesh = without_faces(grid(3, 3), std::vector<Index>{4});
  for (Vec3& p : mesh.positions) p.x() += 1e6;
  Index corner = no_index;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.positions[v] == Vec3(1e6 + 1, 1, 0)) corner = v;
  }
  mesh.positions[corner] -= Vec3(0.01, 0.01 * 0x1p-24, 0);
  const Scene scene(mesh);
  const Hole* const hole = scene.square_hole();
  const HolePatch patch = scene.fan(hole->id, Vec3(1e6 + 1, 1, 0));
  Progress progress;
  PatchVerifier as_double(scene.mesh, scene.analysis, Precision::Double);
  CHECK(as_double.accept_sound(std::vector{patch}, progress)[0].is_sound());
  PatchVerifier as_single(scene.mesh, scene.analysis, Precision::Single);
  CHECK(as_single.accept_sound(std::vector{patch}, progress)[0].fault == "a triangle of the patch has no area");
}

TEST_CASE("a mesh of double numbers that will be stored as single ones is judged as both") {
  // A triangle above a hole, whose tip cuts it unless single precision lifts it by a sixteen thousandth.
  PolyMesh mesh = without_faces(grid(3, 3), std::vector<Index>{4});
  const Index base = static_cast<Index>(mesh.vertex_count());
  for (const Vec3& p : {Vec3(1.2, 1.2, 1.55e-4), Vec3(1.8, 1.2, 1.55e-4), Vec3(1.5, 1.8, 1.55e-4)})
    mesh.positions.push_back(p);
  mesh.add_triangle(base, base + 1, base + 2);
  for (Vec3& p : mesh.positions) p.z() += 1000;
  const auto is_sound = [](const PolyMesh& given, Precision precision) {
    const Scene scene(given);
    const Hole* const hole = scene.square_hole();
    Progress progress;
    PatchVerifier verifier(scene.mesh, scene.analysis, precision);
    const HolePatch patch = scene.fan(hole->id, Vec3(1.5, 1.5, 1000 + 1.587e-4));
    return verifier.accept_sound(std::vector{patch}, progress)[0].is_sound();
  };
  CHECK_FALSE(is_sound(mesh, Precision::Double));
  CHECK_FALSE(is_sound(mesh, Precision::Single));
  for (Index v = base; v < base + 3; ++v) {
    for (double& coordinate : mesh.positions[v]) {
      const volatile float rounded = static_cast<float>(coordinate);
      coordinate = static_cast<double>(rounded);
    }
  }
  CHECK(is_sound(mesh, Precision::Single));
}

TEST_CASE("cancelling accepts nothing") {
  const Scene scene(cut(round_sphere(4), Vec3(0, 0, 1), 0.3).mesh);
  const HolePatch patch = scene.fan(0, Vec3(0, 0, 1));
  PatchVerifier verifier(scene.mesh, scene.analysis);
  const std::atomic<bool> cancel = true;
  Progress stopped({}, &cancel);
  CHECK_THROWS_AS(verifier.accept_sound(std::vector{patch}, stopped), Cancelled);
  Progress progress;
  CHECK(verifier.accept_sound(std::vector{patch}, progress)[0].is_sound());
}
