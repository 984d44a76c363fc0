// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "croquis/hole_filling/fill_holes.h"
#include "hole_filling/fill_invariants.h"
#include "support/meshes/mesh_shapes.h"
#include "support/meshes/surface_distance.h"
#include "support/random.h"
#include "support/sample_count.h"
#include "support/scans/known_scans.h"
#include "support/scans/scans.h"
#include "support/scans/virtual_scans.h"

using namespace croquis;
using namespace croquis::test;
using namespace croquis::hole_filling;

namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr Fairness all_fairness[] = {Fairness::Flat, Fairness::Tangent, Fairness::Implicit};

std::uint64_t samples(int usual, int full) { return static_cast<std::uint64_t>(sample_count(usual, full)); }

Vec3 any_direction(Random& random) {
  const double z = random.between(-1, 1), angle = random.between(0, 2 * std::numbers::pi);
  return {std::sqrt(1 - z * z) * std::cos(angle), std::sqrt(1 - z * z) * std::sin(angle), z};
}

Vec3 normal_of(const PolyMesh& mesh, std::size_t face) {
  const auto t = mesh.face(face);
  const Vec3& a = mesh.positions[t[0]];
  return (mesh.positions[t[1]] - a).cross(mesh.positions[t[2]] - a).normalized();
}

/// Angles between neighbours: across rims that were closed, and across edges of given faces that touch those rims.
struct Bends {
  std::vector<double> across_rims, beside_rims;  // ascending, radians
};

Bends bends_of(const FillResult& result) {
  const PolyMesh& mesh = result.mesh;
  std::vector<bool> on_rim(mesh.vertex_count());
  for (const Hole& hole : result.analysis.holes) {
    if (result.outcomes[hole.id].action != FillAction::Fill) continue;
    for (const Index v : hole.vertices) on_rim[v] = true;
  }
  const std::size_t first_new = mesh.face_count() - result.new_faces;
  std::map<std::array<Index, 2>, std::size_t> face_at;  // of each directed edge
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto t = mesh.face(f);
    for (std::size_t i = 0; i < 3; ++i) face_at[{t[i], t[(i + 1) % 3]}] = f;
  }
  Bends bends;
  for (const auto& [edge, face] : face_at) {
    const auto other = face_at.find({edge[1], edge[0]});
    if (other == face_at.end() || face > other->second) continue;
    const double cosine = std::clamp(normal_of(mesh, face).dot(normal_of(mesh, other->second)), -1.0, 1.0);
    const bool is_given = other->second < first_new;
    if (face < first_new && !is_given) bends.across_rims.push_back(std::acos(cosine));
    if (is_given && (on_rim[edge[0]] || on_rim[edge[1]])) bends.beside_rims.push_back(std::acos(cosine));
  }
  std::sort(bends.across_rims.begin(), bends.across_rims.end());
  std::sort(bends.beside_rims.begin(), bends.beside_rims.end());
  return bends;
}

double quantile(const std::vector<double>& ascending, double share) {
  REQUIRE_FALSE(ascending.empty());
  return ascending[static_cast<std::size_t>(share * static_cast<double>(ascending.size() - 1))];
}

/// Distances of the vertices that `b` adds to `mesh` from what `a` adds, greatest, in model units.
double greatest_distance_of_new(const FillResult& a, const FillResult& b) {
  const SurfaceDistance surface(a.mesh, a.mesh.face_count() - a.new_faces);
  double greatest = 0;
  for (std::size_t v = b.mesh.vertex_count() - b.new_vertices; v < b.mesh.vertex_count(); ++v)
    greatest = std::max(greatest, surface(b.mesh.positions[v]));
  return greatest;
}

/// Root of the mean square of how far new vertices lie from a surface whose distance is known.
template <typename Distance>
double rms_of_new(const FillResult& result, Distance&& distance) {
  REQUIRE(result.new_vertices > 0);
  double sum = 0;
  for (std::size_t v = result.mesh.vertex_count() - result.new_vertices; v < result.mesh.vertex_count(); ++v) {
    const double error = distance(result.mesh.positions[v]);
    sum += error * error;
  }
  return std::sqrt(sum / static_cast<double>(result.new_vertices));
}

}  // namespace

TEST_CASE("sculptures with ragged cuts, islands and noise are closed soundly, by every fairness") {
  for (std::uint64_t seed = 0; seed < samples(2, 12); ++seed) {
    const PolyMesh whole = sculpt(all_sculptures[(3 * seed + 2) % all_sculptures.size()], 6000);
    for (const double noise : {0.0, 0.1, 0.4}) {
      RaggedCuts cuts;
      cuts.seed = seed;
      cuts.count = 6;
      cuts.low = 0.03;
      cuts.high = 0.1;
      cuts.island = noise == 0.1 ? 0.4 : 0;
      const PolyMesh mesh = with_noise(ragged_cuts(whole, cuts).mesh, seed, noise);
      for (const Fairness fairness : all_fairness) {
        FillOptions options;
        options.fairness = fairness;
        options.selection = Selection::All;
        check_invariants(mesh, fill(mesh, options));
      }
    }
  }
}

TEST_CASE("what scanners don't see is closed soundly or left open with a reason") {
  for (std::uint64_t seed = 0; seed < samples(2, 5); ++seed) {
    Random random(seed);
    const PolyMesh whole = sculpt(all_sculptures[seed % all_sculptures.size()], 5000);
    std::vector<Vec3> scanners;
    for (int i = 0; i < 4; ++i) scanners.push_back(any_direction(random));
    const PolyMesh shadowed = with_noise(seen_from(whole, scanners).mesh, seed, 0.1);
    const PolyMesh raw = with_noise(range_images(whole, scanners, 0.06), seed, 0.1);
    for (const PolyMesh& mesh : {shadowed, raw}) {
      FillOptions options;
      check_invariants(mesh, fill(mesh, options));
      options.selection = Selection::All;  // borders of raw scans, too
      check_invariants(mesh, fill(mesh, options));
    }
  }
}

TEST_CASE("a surface that looks inwards keeps looking inwards") {
  const PolyMesh mesh = random_cuts(ring_torus(60, 30), 5, 4, 0.15, 0.3).mesh;
  for (const Fairness fairness : all_fairness) {
    FillOptions options;
    options.fairness = fairness;
    CHECK(report_of(fill(mesh, options).mesh).volume.value() > 3.1);
    CHECK(report_of(fill(flipped(mesh), options).mesh).volume.value() < -3.1);
  }
}

TEST_CASE("patches bend across their rims little more than the surface beside them") {
  const std::vector<PolyMesh> shapes = {round_sphere(5), ring_torus(120, 60), uv_sphere(80, 60), bust(80, 100)};
  for (const PolyMesh& shape : shapes) {
    Bends bends;
    for (std::uint64_t seed = 0; seed < samples(2, 20); ++seed) {
      const Bends some = bends_of(fill(random_cuts(triangulated(shape), seed, 3, 0.12, 0.3).mesh));
      bends.across_rims.insert(bends.across_rims.end(), some.across_rims.begin(), some.across_rims.end());
      bends.beside_rims.insert(bends.beside_rims.end(), some.beside_rims.begin(), some.beside_rims.end());
    }
    std::sort(bends.across_rims.begin(), bends.across_rims.end());
    std::sort(bends.beside_rims.begin(), bends.beside_rims.end());
    const double own = quantile(bends.beside_rims, 0.5);
    CHECK(quantile(bends.across_rims, 0.5) <= own + 3 * degree);
    CHECK(quantile(bends.across_rims, 0.95) <= own + 15 * degree);
  }
}

TEST_CASE("half the edge brings less than a quarter of the error in a patch's first ring") {
  const auto error = [](int levels) {
    FillOptions options;
    options.implicit.most_centres = 1000;  // so that edges alone limit what is known
    double sum = 0;
    for (const double radius : {0.44, 0.46, 0.48, 0.5, 0.52, 0.54, 0.56})
      sum += mean_error_of_first_ring(fill(cut(round_sphere(levels), Vec3(0, 0, 1), radius).mesh, options));
    return sum / 7;
  };
  const double coarse = error(3), fine = error(6);
  CAPTURE(coarse, fine);
  const double per_halving = std::cbrt(coarse / fine);  // single steps vary with where the rim lies
  CHECK(per_halving > 4);
  CHECK(per_halving < 6);
}

TEST_CASE("twenty holes of a sphere and of a torus are closed to a fifth of a percent of the diameter") {
  for (std::uint64_t seed = 0; seed < samples(2, 20); ++seed) {
    const FillResult ball = fill(random_cuts(round_sphere(5), seed, 20, 0.1, 0.3).mesh);
    CHECK(filled(ball) == 20);
    CHECK(rms_of_new(ball, [](const Vec3& p) { return p.norm() - 1; }) < 0.002 * 2);
    const FillResult ring = fill(random_cuts(ring_torus(150, 60), seed, 20, 0.1, 0.25).mesh);
    CHECK(filled(ring) == 20);
    CHECK(rms_of_new(ring, [](const Vec3& p) { return std::hypot(std::hypot(p.x(), p.y()) - 1, p.z()) - 0.4; }) <
          0.002 * 2.8);
  }
}

TEST_CASE("the order of vertices and faces says nothing about the surface") {
  for (std::uint64_t seed = 0; seed < samples(2, 20); ++seed) {
    const PolyMesh mesh = random_cuts(ring_torus(60, 30), seed, 3, 0.15, 0.3).mesh;
    const FillResult plain = fill(mesh), other = fill(shuffled(mesh, seed));
    CHECK(other.new_vertices == plain.new_vertices);
    CHECK(greatest_distance_of_new(plain, other) < 1e-6 * diagonal_of(mesh));
    CHECK(greatest_distance_of_new(other, plain) < 1e-6 * diagonal_of(mesh));
  }
}

TEST_CASE("a scaled, turned or moved surface gets the same patches in its own place") {
  for (std::uint64_t seed = 0; seed < samples(2, 20); ++seed) {
    Random random(seed);
    // Uneven, so that no two triangulations are equally good.
    const PolyMesh mesh = with_noise(random_cuts(ring_torus(60, 30), seed, 3, 0.15, 0.3).mesh, seed, 0.05);
    const FillResult plain = fill(mesh);
    const double diagonal = diagonal_of(mesh);
    for (const double factor : {1e-6, 0.37, 1e7}) {
      FillResult larger = fill(scaled(mesh, factor));
      for (Vec3& p : larger.mesh.positions) p /= factor;
      CHECK(greatest_distance_of_new(plain, larger) < 1e-6 * diagonal);
    }
    const Eigen::Affine3d motion =
        Eigen::Translation3d(any_direction(random)) * Eigen::AngleAxisd(random.between(0, 6), any_direction(random));
    FillResult moved = fill(transformed(mesh, motion));
    for (Vec3& p : moved.mesh.positions) p = motion.inverse() * p;
    CHECK(greatest_distance_of_new(plain, moved) < 1e-6 * diagonal);
  }
}

TEST_CASE("how a noisy scan lies in space changes none of its patches, whatever method made them") {
  Random random(43);
  std::set<std::string> methods;
  for (const ScanKind kind : {ScanKind::Face, ScanKind::Thorns}) {
    for (std::uint64_t seed = 1; seed < 1 + 2 * samples(1, 8); seed += 2) {
      const PolyMesh mesh = with_noise(known_scan(kind, seed, 5000).mesh, seed, 0.15);
      const Eigen::Affine3d turn(Eigen::AngleAxisd(random.between(0, 6), any_direction(random)));
      const FillResult plain = fill(mesh);
      FillResult turned = fill(transformed(mesh, turn));
      for (Vec3& p : turned.mesh.positions) p = turn.inverse() * p;
      CAPTURE(name_of(kind), seed);
      CHECK(turned.new_vertices == plain.new_vertices);
      CHECK(greatest_distance_of_new(plain, turned) < 1e-4 * diagonal_of(mesh));
      for (std::size_t h = 0; h < plain.outcomes.size(); ++h) {
        CHECK(plain.outcomes[h].method == turned.outcomes[h].method);
        methods.insert(plain.outcomes[h].method);
      }
    }
  }
  CHECK(methods.contains("implicit"));
  CHECK(methods.contains("implicit-cubes"));
}

TEST_CASE("millimetres a kilometre from the origin are filled as well as anywhere") {
  // A torus of 2.8 mm, coordinates in metres and in millimetres.
  const PolyMesh mesh = random_cuts(ring_torus(60, 30), 7, 4, 0.15, 0.3).mesh;
  const FillResult near = fill(mesh);
  const Vec3 far(1e6, -2e6, 3e6);
  const PolyMesh there = translated(mesh, far);
  FillResult result = fill(there);
  check_invariants(there, result);
  CHECK(filled(result) == 4);
  for (Vec3& p : result.mesh.positions) p -= far;
  CHECK(greatest_distance_of_new(near, result) < 1e-3 * diagonal_of(mesh));
  const FillResult metres = fill(translated(scaled(mesh, 1e-3), Vec3(1000, -1000, 500)));
  CHECK(filled(metres) == 4);
  CHECK(*report_of(metres.mesh).self_intersections == 0);
}

TEST_CASE("a filled mesh is filled already, whatever filled it") {
  for (std::uint64_t seed = 0; seed < samples(3, 30); ++seed) {
    for (const Fairness fairness : all_fairness) {
      const FillResult once = fill(random_cuts(bust(60, 70), seed, 3, 0.1, 0.25).mesh, by(fairness));
      const FillResult again = fill(once.mesh, by(fairness));
      CHECK(again.new_faces == 0);
      CHECK(begins_with(again.mesh, once.mesh));
      CHECK(begins_with(once.mesh, again.mesh));
    }
  }
}
