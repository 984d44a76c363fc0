// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "algorithms/remeshing/memory.h"
#include "croquis/geometry/mesh_topology.h"
#include "hole_filling/fill_invariants.h"
#include "remeshing/remeshed.h"
#include "support/meshes/mesh_shapes.h"
#include "support/meshes/surface_distance.h"
#include "support/random.h"
#include "support/sample_count.h"
#include "support/scans/scans.h"
#include "support/scans/virtual_scans.h"

using namespace croquis;
using namespace croquis::test;
using namespace croquis::hole_filling;
using namespace croquis::remeshing;

namespace {

std::vector<Vec3> used_vertices(const PolyMesh& mesh) {
  std::vector<bool> used(mesh.vertex_count(), false);
  for (const Index v : mesh.corners) used[v] = true;
  std::vector<Vec3> places;
  for (std::size_t v = 0; v < used.size(); ++v)
    if (used[v]) places.push_back(mesh.positions[v]);
  return places;
}

/// Mean distance of the vertices given to what came out, × diagonal.
double mean_distance(const PolyMesh& given, const PolyMesh& made) {
  return summary_of_distances(used_vertices(given), SurfaceDistance(made)).mean / diagonal_of(given);
}

void check_sound(const RemeshResult& result, std::size_t components, std::size_t loops, std::int64_t euler) {
  const MeshReport report = report_of(result.mesh);
  CHECK(report.components == components);
  CHECK(report.boundary_loops == loops);
  CHECK(report.euler_characteristic == euler);
  CHECK(report.nonmanifold_edges == 0);
  CHECK(report.nonmanifold_vertices == 0);
  CHECK(report.oriented);
  CHECK(report.self_intersections == std::size_t{0});
  CHECK(result.checks.manifold);
  CHECK(result.checks.components == components);
  CHECK(result.checks.open_loops == loops);
  CHECK(result.checks.failed_loops == 0);
  CHECK(result.checks.lost_points == 0);
  CHECK(result.checks.self_intersections == 0);
  CHECK(validate(result.mesh).empty());
}

RemeshOptions with_kernel(implicit::Kernel kernel) {
  RemeshOptions options;
  options.fill.implicit.kernel = kernel;
  return options;
}

double greatest_dihedral(const PolyMesh& mesh) {
  const MeshTopology topology(mesh);
  const auto normal = [&](Index corner) {
    const auto face = mesh.face(topology.face(corner));
    const Vec3& a = mesh.positions[face[0]];
    return Vec3((mesh.positions[face[1]] - a).cross(mesh.positions[face[2]] - a).normalized());
  };
  double greatest = 0;
  for (Index c = 0; c < topology.corner_count(); ++c) {
    const Index other = topology.opposite(c);
    if (other != no_index)
      greatest = std::max(greatest, std::acos(std::clamp(normal(c).dot(normal(other)), -1.0, 1.0)));
  }
  return greatest * 180 / std::numbers::pi;
}

}  // namespace

TEST_CASE("remeshed spheres with holes are closed and as round as they were, with every kernel") {
  using implicit::Kernel;
  const PolyMesh mesh = random_cuts(round_sphere(5), 1, 4, 0.1, 0.35).mesh;
  for (const Kernel kernel : {Kernel::Hermite, Kernel::Triharmonic, Kernel::Biharmonic, Kernel::ThinPlate}) {
    const RemeshResult result = remesh(mesh, with_kernel(kernel));
    CAPTURE(static_cast<int>(kernel));
    check_sound(result, 1, 0, 2);
    CHECK(mean_distance(mesh, result.mesh) < 0.0005);
    double worst = 0;
    for (const Vec3& p : result.mesh.positions) worst = std::max(worst, std::abs(p.norm() - 1));
    CHECK(worst < (kernel == Kernel::Biharmonic || kernel == Kernel::ThinPlate ? 0.03 : 0.01));
    for (const HoleOutcome& outcome : result.outcomes) {
      CHECK(outcome.action == FillAction::Fill);
      CHECK(outcome.method == "remesh");
    }
  }
}

TEST_CASE("whatever is cut out of closed shapes, the remeshed model is closed and sound and keeps its handles") {
  const int seeds = sample_count(3, 30);
  for (int seed = 1; seed <= seeds; ++seed) {
    CAPTURE(seed);
    const PolyMesh torus = random_cuts(ring_torus(120, 60), static_cast<std::uint64_t>(seed), 8, 0.04, 0.2).mesh;
    const RemeshResult result = remesh(torus);
    check_sound(result, 1, 0, 0);
    CHECK(mean_distance(torus, result.mesh) < 0.0005);
    CHECK(*report_of(result.mesh).volume == Approx(2 * std::numbers::pi * std::numbers::pi * 0.16).epsilon(0.01));
    const PolyMesh box = random_cuts(divided_box(30), static_cast<std::uint64_t>(seed), 5, 0.06, 0.15).mesh;
    check_sound(remesh(box), 1, 0, 2);
  }
}

TEST_CASE("a hole with an island is closed by one sheet") {
  const PolyMesh mesh = cut_ring(round_sphere(5), Vec3(0, 0, 1), 0.12, 0.4).mesh;
  const RemeshResult result = remesh(mesh);
  check_sound(result, 1, 0, 2);
  for (const Vec3& p : result.mesh.positions) CHECK(std::abs(p.norm() - 1) < 0.005);
}

TEST_CASE("skins of a shell stay apart and keep their sides, even nearer to each other than a cube") {
  for (const double wall : {0.2, 0.05, 0.01}) {
    CAPTURE(wall);
    const RemeshResult result = remesh(shell(4, wall));  // edges of 0.08
    check_sound(result, 2, 0, 4);
    const double inner = 1 - wall;
    CHECK(*report_of(result.mesh).volume ==
          Approx(4.0 / 3 * std::numbers::pi * (1 - inner * inner * inner)).margin(0.01));
  }
}

TEST_CASE("rims left open stay open, near to where they were, on clean borders") {
  const PolyMesh tube = open_tube(1, 4, 60, 40);
  const RemeshResult result = remesh(tube);
  check_sound(result, 1, 2, 0);
  const MeshTopology topology(result.mesh);
  for (Index loop = 0; loop < topology.boundary_loops().size(); ++loop) {
    for (const Index v : topology.boundary_loops()[loop]) {
      const double z = result.mesh.positions[v].z();
      CHECK(std::min(std::abs(z), std::abs(z - 4)) < 0.2);
    }
  }
  for (const HoleOutcome& outcome : result.outcomes) CHECK(outcome.action == FillAction::Leave);
}

TEST_CASE("open sections are closed too when they are chosen") {
  RemeshOptions options;
  options.fill.selection = Selection::All;
  for (const PolyMesh& mesh : {bowl(48, 20), open_tube(1, 4, 60, 40), bust(60, 40)})
    check_sound(remesh(mesh, options), 1, 0, 2);
}

TEST_CASE("of two holes the one that isn't chosen stays open") {
  PolyMesh mesh = cut(round_sphere(5), Vec3(0, 0, 1), 0.3).mesh;
  mesh = cut(mesh, Vec3(0, 0, -1), 0.3).mesh;
  RemeshOptions options;
  options.fill.only = {0};
  const RemeshResult result = remesh(mesh, options);
  check_sound(result, 1, 1, 1);
  CHECK(result.outcomes[0].action == FillAction::Fill);
  CHECK(result.outcomes[1].action == FillAction::Leave);
  const double side = result.analysis.holes[1].centre.z();
  const MeshTopology topology(result.mesh);
  for (const Index v : topology.boundary_loops()[0]) CHECK(result.mesh.positions[v].z() * side > 0);
}

TEST_CASE("holes of a sheet are closed, its border stays") {
  const PolyMesh mesh = random_cuts(sheet(40, 40), 3, 3, 2, 5).mesh;
  const RemeshResult result = remesh(mesh);
  check_sound(result, 1, 1, 1);
  for (const Vec3& p : result.mesh.positions) CHECK(std::abs(p.z()) < 1e-6);
}

TEST_CASE("sculpted scans with ragged holes are closed") {
  const PolyMesh complete = triangulated(uv_sphere(80, 60));
  for (const std::uint64_t seed : {1U, 2U}) {
    RaggedCuts cuts;
    cuts.seed = seed;
    const CutScan scan = ragged_cuts(complete, cuts);
    const RemeshResult result = remesh(scan.mesh);
    check_sound(result, 1, 0, 2);
    CHECK(mean_distance(scan.mesh, result.mesh) < 0.0005);
  }
}

TEST_CASE("soups are remeshed as the mesh that they were") {
  const PolyMesh mesh = random_cuts(round_sphere(4), 2, 2, 0.2, 0.3).mesh;
  check_sound(remesh(as_soup(mesh)), 1, 0, 2);
}

TEST_CASE("a model of few large faces is sampled in their middle") {
  const RemeshResult result = remesh(cube());
  check_sound(result, 1, 0, 2);
  CHECK(*report_of(result.mesh).volume == Approx(1).epsilon(0.03));
  CHECK(mean_distance(cube(), result.mesh) < 0.015);  // corners become round
}

TEST_CASE("parts thinner than a cube come out whole where memory allows smaller cubes, else they are reported") {
  // A ball with a needle of 0.08 across.
  std::vector<Vec2> profile = {{0, -1}};
  for (int i = 1; i < 20; ++i) {
    const double angle = std::numbers::pi * (i / 20.0 - 0.5);
    profile.emplace_back(std::cos(angle), std::sin(angle));
  }
  for (int i = 0; i <= 10; ++i) profile.emplace_back(0.04, 1 + 0.1 * i);
  profile.emplace_back(0, 2.05);
  const PolyMesh mesh = revolved(profile, 24);
  check_sound(remesh(mesh), 1, 0, 2);
  RemeshOptions options;
  options.memory_limit = least_remesh_bytes(mesh, options);
  const RemeshResult result = remesh(mesh, options);
  CHECK(report_of(result.mesh).closed);
  CHECK(result.checks.lost_points > 0);
  const auto warning = std::ranges::find(result.warnings, "W_DETAIL_LOST", &Finding::code);
  REQUIRE(warning != result.warnings.end());
  REQUIRE(warning->subjects.size() == 1);
  CHECK(warning->subjects[0].at[2] > 1);  // on the needle
}

TEST_CASE("colours and other values of vertices go over to where they belong") {
  PolyMesh mesh = cut(round_sphere(4), Vec3(0, 0, 1), 0.3).mesh;
  std::vector<std::uint8_t> colors;
  std::vector<double> heights;
  std::vector<float> normals(3 * mesh.vertex_count(), 0);
  for (const Vec3& p : mesh.positions) {
    for (int axis = 0; axis < 3; ++axis) colors.push_back(static_cast<std::uint8_t>(std::lround(100 + 100 * p[axis])));
    heights.push_back(p.z());
  }
  mesh.channels = {{"color", Domain::Vertex, 3, colors, {}},
                   {"height", Domain::Vertex, 1, heights, {}},
                   {"normal", Domain::Vertex, 3, normals, {}}};
  const RemeshResult result = remesh(mesh);
  CHECK(validate(result.mesh).empty());
  const auto& color = std::get<std::vector<std::uint8_t>>(result.mesh.channel("color", Domain::Vertex)->data);
  const auto& height = std::get<std::vector<double>>(result.mesh.channel("height", Domain::Vertex)->data);
  const auto& normal = std::get<std::vector<float>>(result.mesh.channel("normal", Domain::Vertex)->data);
  const auto& confidence = std::get<std::vector<float>>(result.mesh.channel("confidence", Domain::Vertex)->data);
  std::size_t in_hole = 0;
  for (std::size_t v = 0; v < result.mesh.vertex_count(); ++v) {
    const Vec3& p = result.mesh.positions[v];
    in_hole += confidence[v] < 1 ? 1U : 0U;
    const double tolerance = confidence[v] < 1 ? 0.2 : 0.01;  // in the hole the rim's
    CHECK(height[v] == Approx(p.z()).margin(tolerance));
    CHECK(color[3 * v] == Approx(100 + 100 * p.x()).margin(200 * tolerance));
    const Vec3 direction(normal[3 * v], normal[3 * v + 1], normal[3 * v + 2]);
    CHECK(direction.dot(p.normalized()) > 0.99);
  }
  CHECK(in_hole == result.outcomes[0].new_vertices);
  CHECK(in_hole > 20);
}

TEST_CASE("faces show whether they lie in a hole that was closed") {
  const PolyMesh mesh = cut(round_sphere(5), Vec3(0, 0, 1), 0.4).mesh;
  const RemeshResult result = remesh(mesh);
  const auto& patch = std::get<std::vector<std::int32_t>>(result.mesh.channel("patch_id", Domain::Face)->data);
  const double rim = std::cos(2 * std::asin(0.2));  // height of the rim: its chord is 0.4
  for (std::size_t f = 0; f < patch.size(); ++f) {
    const auto face = result.mesh.face(f);
    const double z =
        (result.mesh.positions[face[0]] + result.mesh.positions[face[1]] + result.mesh.positions[face[2]]).z() / 3;
    if (z > rim + 0.04) CHECK(patch[f] == 0);
    if (z < rim - 0.04) CHECK(patch[f] == -1);
  }
}

TEST_CASE("snapped vertices lie exactly on those given, and nothing cuts through itself") {
  const PolyMesh mesh = random_cuts(round_sphere(5), 1, 3, 0.1, 0.3).mesh;
  RemeshOptions options;
  options.snap = 0.3;
  const RemeshResult result = remesh(mesh, options);
  check_sound(result, 1, 0, 2);
  std::vector<std::array<double, 3>> given;
  for (const Vec3& p : mesh.positions) given.push_back({p.x(), p.y(), p.z()});
  std::sort(given.begin(), given.end());
  const auto taken = std::count_if(result.mesh.positions.begin(), result.mesh.positions.end(), [&](const Vec3& p) {
    return std::binary_search(given.begin(), given.end(), std::array{p.x(), p.y(), p.z()});
  });
  CHECK(static_cast<double>(taken) > 0.1 * static_cast<double>(result.mesh.vertex_count()));
}

TEST_CASE("refined triangles come nearer to the surface, until the chord is short enough") {
  const PolyMesh mesh = cut(round_sphere(4), Vec3(0, 0, 1), 0.2).mesh;
  const RemeshResult coarse = remesh(mesh);
  RemeshOptions options;
  options.refine = 1;
  const RemeshResult once = remesh(mesh, options);
  CHECK(once.mesh.face_count() == 4 * coarse.mesh.face_count());
  check_sound(once, 1, 0, 2);
  options.refine = 3;
  const SurfaceDistance limit(remesh(mesh, options).mesh);
  const auto flatness = [&](const PolyMesh& made) {
    double sum = 0;
    for (std::size_t f = 0; f < made.face_count(); ++f) {
      const auto face = made.face(f);
      sum += limit((made.positions[face[0]] + made.positions[face[1]] + made.positions[face[2]]) / 3);
    }
    return sum / static_cast<double>(made.face_count());
  };
  CHECK(flatness(once.mesh) < 0.35 * flatness(coarse.mesh));
  options.refine = 4;
  options.chord = 0.01;  // the first middles move by less
  CHECK(remesh(mesh, options).mesh.face_count() == once.mesh.face_count());
}

TEST_CASE("the paper's boxes leave seams without overlap and none with a quarter") {
  const PolyMesh mesh = ring_torus(80, 40);
  RemeshOptions options = remesh_preset(Preset::Paper);
  options.refine = 2;
  options.overlap = 0;
  const RemeshResult seams = remesh(mesh, options);
  options.overlap = 0.25;
  const RemeshResult smooth = remesh(mesh, options);
  CHECK(report_of(seams.mesh).closed);
  check_sound(smooth, 1, 0, 0);
  CHECK(greatest_dihedral(smooth.mesh) < 10);
  CHECK(greatest_dihedral(seams.mesh) > 2 * greatest_dihedral(smooth.mesh));
}

TEST_CASE("smoothing more follows noise less") {
  const PolyMesh noisy = with_noise(round_sphere(5), 1, 0.2);
  const auto roughness = [](const PolyMesh& made) {
    double sum = 0;
    for (const Vec3& p : made.positions) sum += (p.norm() - 1) * (p.norm() - 1);
    return std::sqrt(sum / static_cast<double>(made.vertex_count()));
  };
  const RemeshResult close = remesh(noisy);
  const RemeshResult calm = remesh(noisy, remesh_preset(Preset::Noisy));
  CHECK(report_of(calm.mesh).closed);
  CHECK(roughness(calm.mesh) < 0.8 * roughness(close.mesh));
}

TEST_CASE("a wall thinner than a cube comes out whole, made of smaller cubes") {
  for (const double wall : {0.6, 0.35}) {  // of an edge
    CAPTURE(wall);
    const PolyMesh plate = transformed(divided_box(20), Eigen::Affine3d(Eigen::Scaling(1.0, 1.0, wall / 20)));
    check_sound(remesh(plate), 1, 0, 2);
  }
}

TEST_CASE("a fin's free edges are closed too, or reported as open") {
  PolyMesh mesh = round_sphere(4);
  const auto face = mesh.face(0);
  const std::array edge = {face[0], face[1]};
  mesh.positions.emplace_back(0.6 * (mesh.positions[edge[0]] + mesh.positions[edge[1]]));
  mesh.add_triangle(edge[0], edge[1], static_cast<Index>(mesh.vertex_count() - 1));
  RemeshOptions options;
  options.fill.selection = Selection::All;
  const RemeshResult result = remesh(mesh, options);
  CHECK(warns(result, "W_NOT_CLOSED") == !report_of(result.mesh).closed);
}

TEST_CASE("bands of one side and thin plates stay where they are when all holes are chosen") {
  const PolyMesh plate = merged(sheet(12, 12), flipped(translated(sheet(12, 12), Vec3(0, 0, -0.2))));
  RemeshOptions options;
  options.fill.selection = Selection::All;
  for (const PolyMesh& mesh : {triangulated(moebius(36)), plate, sheet(20, 20)}) {
    const RemeshResult result = remesh(mesh, options);
    CHECK(summary_of_distances(result.mesh.positions, SurfaceDistance(mesh)).greatest < 0.4 * diagonal_of(mesh));
  }
}

TEST_CASE("open sections that are chosen get flat caps") {
  RemeshOptions options;
  options.fill.selection = Selection::All;
  const RemeshResult result = remesh(open_tube(1, 4, 60, 40), options);
  check_sound(result, 1, 0, 2);
  for (const Vec3& p : result.mesh.positions) {
    CHECK(p.z() > -0.2);
    CHECK(p.z() < 4.2);
  }
  const auto& patch = std::get<std::vector<std::int32_t>>(result.mesh.channel("patch_id", Domain::Face)->data);
  for (const std::int32_t id : {0, 1}) CHECK(std::count(patch.begin(), patch.end(), id) > 20);
}

TEST_CASE("how sharply a closed hole bends, and how slender its triangles are, is measured") {
  const RemeshResult round = remesh(cut(round_sphere(5), Vec3(0, 0, 1), 0.4).mesh);
  CHECK(round.outcomes[0].max_normal_jump > 0.001);
  CHECK(round.outcomes[0].max_normal_jump < 0.2);
  CHECK(round.outcomes[0].min_angle > 0.1);
  CHECK(round.outcomes[0].min_angle < std::numbers::pi / 3);
}
