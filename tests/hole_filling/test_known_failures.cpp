// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/hole_filling/fill_holes.h"
#include "croquis/hole_filling/hole_patch.h"
#include "hole_filling/fill_invariants.h"
#include "hole_filling/site_scene.h"
#include "support/meshes/mesh_shapes.h"
#include "support/sample_count.h"
#include "support/scans/scans.h"
#include "support/scans/virtual_scans.h"

/// What fillers are known to fail at: surfaces that run away, skins that get joined, rims that share vertices, rough
/// rims, sharp edges.
using namespace croquis;
using namespace croquis::test;
using namespace croquis::hole_filling;

namespace {

/// How far new vertices lie from the box of the vertices given, × its diagonal.
double farthest_out(const PolyMesh& mesh, const FillResult& result) {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : mesh.positions) box.extend(p);
  double farthest = 0;
  for (std::size_t v = mesh.vertex_count(); v < result.mesh.vertex_count(); ++v)
    farthest = std::max(farthest, box.exteriorDistance(result.mesh.positions[v]) / box.diagonal().norm());
  return farthest;
}

/// Quads in z = height(x, y) over a square of `size`.
template <typename Height>
PolyMesh height_field(Index size, Height&& height) {
  PolyMesh mesh = sheet(size, size);
  for (Vec3& p : mesh.positions) p.z() = height(p.x(), p.y());
  return mesh;
}

/// A sphere of quads of which every third one is missing in each ring, one further in each: each missing one shares
/// corners with two others.
PolyMesh chains_around_sphere(Index segments, Index rings) {
  const PolyMesh whole = uv_sphere(segments, rings);
  std::vector<Index> missing;
  for (Index f = 0; f < whole.face_count(); ++f) {
    const Index ring = f / segments;
    if (whole.face(f).size() == 4 && (ring + f) % 3 == 0) missing.push_back(f);
  }
  return without_faces(whole, missing);
}

/// A turned part with steps: sharp edges, outer and inner.
PolyMesh shaft() {
  std::vector<Vec2> profile;
  const std::vector<Vec2> corners = {{0, 0}, {1, 0}, {1, 0.8}, {0.6, 0.8}, {0.6, 2}, {0.8, 2}, {0.8, 2.4}, {0, 2.4}};
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    const int steps = static_cast<int>(std::ceil((corners[i + 1] - corners[i]).norm() / 0.1));
    for (int k = 0; k < steps; ++k)
      profile.push_back(corners[i] + static_cast<double>(k) / steps * (corners[i + 1] - corners[i]));
  }
  profile.push_back(corners.back());
  return revolved(profile, 60);
}

}  // namespace

TEST_CASE("borders of open surfaces that are to be closed smoothly don't run away") {
  const std::vector<PolyMesh> surfaces = {
      sheet(10, 10),
      height_field(10, [](double x, double y) { return 0.05 * (x - 5) * (y - 5); }),
      height_field(10, [](double x, double y) { return 2 * std::sin(x / 3) * std::cos(y / 4); }),
      height_field(10, [](double x, double) { return -0.04 * (x - 5) * (x - 5); }),
      open_tube(1, 4, 32, 12),
      bowl(40, 12),
      moebius(12)};
  for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(sample_count(1, 10)); ++seed) {
    for (const PolyMesh& surface : surfaces) {
      for (const Fairness fairness : {Fairness::Tangent, Fairness::Implicit}) {
        const PolyMesh mesh = with_noise(triangulated(surface), seed, fairness == Fairness::Tangent ? 0 : 0.2);
        const FillResult result = fill(mesh, everything(fairness));
        check_invariants(mesh, result);
        CHECK(farthest_out(mesh, result) < 0.7);
      }
    }
  }
}

TEST_CASE("skins of thin plates and shells are never joined") {
  for (const double wall : {0.015, 0.03, 0.06}) {
    const PolyMesh skins = shell(4, wall);
    for (const Fairness fairness : {Fairness::Flat, Fairness::Tangent, Fairness::Implicit}) {
      PolyMesh mesh = cut(cut(skins, Vec3(0, 0, 1), 0.35).mesh, Vec3(0, 0, 1 - wall), 0.35).mesh;
      mesh = cut(cut(mesh, Vec3(1, 0, 0), 0.2).mesh, Vec3(0, -1 + wall, 0), 0.5).mesh;
      const FillResult result = fill(mesh, everything(fairness));
      check_invariants(mesh, result);
      CHECK(report_of(result.mesh).components == 2);
      for (const HoleOutcome& outcome : result.outcomes) {
        for (const HoleOutcome& other : result.outcomes)
          CHECK((&outcome == &other || outcome.patch != other.patch || outcome.patch == no_index));
      }
    }
  }
}

TEST_CASE("a hundred holes that share vertices are closed without an edge of many faces") {
  for (const bool in_triangles : {false, true}) {
    PolyMesh mesh = chains_around_sphere(36, 16);
    if (in_triangles) mesh = triangulated(mesh);
    for (const Fairness fairness : {Fairness::Flat, Fairness::Tangent, Fairness::Implicit}) {
      const FillResult result = fill(mesh, by(fairness));
      check_invariants(mesh, result);
      CHECK(result.outcomes.size() > 100);
      CHECK(filled(result) == result.outcomes.size());
      CHECK(report_of(result.mesh).closed);
      CHECK(report_of(result.mesh).genus == 0);
    }
  }
}

TEST_CASE("pieces inside of wide holes are islands, not pieces to be capped by themselves") {
  RaggedCuts rings;
  rings.count = 3;
  rings.low = 0.06;
  rings.high = 0.1;
  rings.island = 0.4;
  FillOptions options;
  options.selection = Selection::All;
  for (const Sculpture sculpture : all_sculptures) {
    const PolyMesh whole = sculpt(sculpture, 30000);
    for (rings.seed = 1; rings.seed <= 2; ++rings.seed) {
      CAPTURE(name_of(sculpture), rings.seed);
      const PolyMesh mesh = without_loose_vertices(ragged_cuts(whole, rings).mesh);
      const FillResult result = fill(mesh, options);
      const MeshReport report = report_of(result.mesh);
      CHECK(report.components == 1);
      CHECK(report.closed);
      CHECK(report.self_intersections == 0);
    }
  }
}

TEST_CASE("smooth patches across the edges of machined parts don't fold back at their rims") {
  RaggedCuts cuts;
  cuts.count = 20;
  for (const Sculpture sculpture : {Sculpture::Bracket, Sculpture::Housing}) {
    const PolyMesh whole = sculpt(sculpture, 30000);
    for (cuts.seed = 1; cuts.seed <= 2; ++cuts.seed) {
      const PolyMesh mesh = without_loose_vertices(ragged_cuts(whole, cuts).mesh);
      FillOptions options;
      options.fairness = Fairness::Tangent;
      for (const HoleOutcome& outcome : fill(mesh, options).outcomes) CHECK(outcome.max_normal_jump < doubtful_fold);
    }
  }
}

TEST_CASE("a sound patch that folds back at its rim gives way to one that doesn't") {
  for (const auto& [sculpture, seed] :
       {std::pair{Sculpture::Mug, 2u}, {Sculpture::Bracket, 2u}, {Sculpture::Housing, 3u}}) {
    RaggedCuts cuts;
    cuts.seed = seed;
    cuts.count = 5;
    cuts.low = 0.06;
    cuts.high = 0.12;
    CAPTURE(name_of(sculpture));
    const PolyMesh mesh = without_loose_vertices(ragged_cuts(sculpt(sculpture, 30000), cuts).mesh);
    for (const HoleOutcome& outcome : fill(mesh, {}).outcomes) {
      CHECK((outcome.method.starts_with("implicit") || outcome.method == "creased"));
      CHECK(outcome.max_normal_jump < doubtful_fold);
    }
  }
}

TEST_CASE("rims as rough as their edges are long are closed soundly or left open") {
  std::size_t closed = 0, asked = 0;
  for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(sample_count(3, 40)); ++seed) {
    for (const double roughness : {0.5, 1.0}) {
      const PolyMesh mesh = with_noisy_rims(random_cuts(ring_torus(60, 30), seed, 4, 0.15, 0.3).mesh, seed, roughness);
      for (const Fairness fairness : {Fairness::Flat, Fairness::Tangent, Fairness::Implicit}) {
        const FillResult result = fill(mesh, by(fairness));
        check_invariants(mesh, result);
        closed += filled(result);
        asked += result.outcomes.size();
      }
    }
  }
  CHECK(4 * closed > 3 * asked);
}

TEST_CASE("holes across sharp edges and corners of machined parts are closed without intersections") {
  for (const Sculpture part : {Sculpture::Bracket, Sculpture::Housing}) {
    for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(sample_count(2, 20)); ++seed) {
      RaggedCuts cuts;
      cuts.seed = seed;
      cuts.count = 8;
      cuts.low = 0.03;
      cuts.high = 0.12;
      const PolyMesh mesh = ragged_cuts(sculpt(part, 8000), cuts).mesh;
      const FillResult result = fill(mesh);
      check_invariants(mesh, result);
      CHECK(4 * filled(result) >= 3 * result.outcomes.size());  // some lie where the part cuts itself
      const PolyMesh turned = ragged_cuts(shaft(), cuts).mesh;
      const FillResult smooth = fill(turned);
      check_invariants(turned, smooth);
      CHECK(filled(smooth) == smooth.outcomes.size());
    }
  }
  const PolyMesh box = cut(divided_box(12), Vec3(1, 1, 1), 0.4).mesh;  // a corner is gone
  for (const Fairness fairness : {Fairness::Flat, Fairness::Tangent, Fairness::Implicit}) {
    const FillResult result = fill(box, by(fairness));
    check_invariants(box, result);
    CHECK(filled(result) == 1);
  }
}
