// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <catch2/catch.hpp>

#include "algorithms/hole_filling/patching/patch_methods.h"
#include "croquis/hole_filling/hole_patch.h"
#include "hole_filling/fill_invariants.h"
#include "hole_filling/site_scene.h"
#include "support/meshes/surface_distance.h"
#include "support/scans/scans.h"
#include "support/scans/virtual_scans.h"

using namespace croquis;
using namespace croquis::test;
using namespace croquis::hole_filling;

namespace {

struct Made {
  PolyMesh mesh;
  HoleAnalysis analysis;
  HolePatch patch;
  std::vector<float> confidence;
};

/// The first hole closed by a method.
Made close_first(const PolyMesh& mesh, Maker maker, Index hole = 0) {
  Progress progress;
  Made made{mesh, analyse_holes(mesh, progress), {}, {}};
  const std::vector<Index> holes = {hole};
  made.patch = *make_patch({maker}, make_site(mesh, made.analysis, holes, {}), progress);
  made.confidence = vertex_confidence(made.patch, mesh, made.analysis);
  return made;
}

struct Trusted {
  double confidence = 0;
  double error = 0;  ///< mean distance of the patch from the sphere, in diagonals of the whole sphere
};

/// The cap of a sphere up to a distance from its pole, cut off and filled.
Trusted refilled_cap(double radius, Fairness fairness) {
  const PolyMesh sphere = round_sphere(4), scan = cut(sphere, Vec3(0, 0, 1), radius).mesh;
  FillOptions options;
  options.fairness = fairness;
  options.selection = Selection::All;
  options.flat_caps = false;
  const FillResult result = fill(scan, options);
  REQUIRE(result.outcomes.size() == 1);
  REQUIRE(result.outcomes[0].action == FillAction::Fill);
  std::vector<Index> patch;
  for (auto f = static_cast<Index>(scan.face_count()); f < result.mesh.face_count(); ++f) patch.push_back(f);
  double sum = 0;
  const std::vector<Vec3> places = sample_faces(result.mesh, patch, 2000);
  for (const Vec3& place : places) sum += std::abs(place.norm() - 1);
  return {result.outcomes[0].confidence, sum / static_cast<double>(places.size()) / diagonal_of(sphere)};
}

}  // namespace

TEST_CASE("confidence falls from the rim to the middle of a flat patch, which is far from any evidence there") {
  const PolyMesh mesh = cut(sheet(40, 40), Vec3(20, 20, 0), 9).mesh;
  const Made made = close_first(mesh, Maker::Implicit, inner_hole(mesh));
  REQUIRE(made.confidence.size() == made.patch.points.size());
  float least = 1;
  for (std::size_t v = 0; v < made.confidence.size(); ++v) {
    const double from_middle = (made.patch.points[v] - Vec3(20, 20, 0)).norm();
    least = std::min(least, made.confidence[v]);
    CHECK(made.confidence[v] > 0);
    CHECK(made.confidence[v] <= 1);
    if (from_middle > 6) CHECK(made.confidence[v] > 0.9F);
    if (from_middle < 2) CHECK(made.confidence[v] < 0.93F);
  }
  CHECK(least == Approx(0.84).margin(0.04));
}

TEST_CASE("the least confidence of a smooth patch is that of the whole patch") {
  const Made made = close_first(cut(round_sphere(4), Vec3(0, 0, 1), 0.5).mesh, Maker::Implicit);
  const float least = *std::min_element(made.confidence.begin(), made.confidence.end());
  CHECK(least == Approx(confidence_of(made.patch, made.mesh, made.analysis)).margin(0.02));
}

TEST_CASE("a lid across a tube, at right angles to it, isn't trusted") {
  const PolyMesh tube = open_tube(1, 2, 48, 16);
  Progress progress;
  const HoleAnalysis analysis = analyse_holes(tube, progress);
  const std::vector<Index> holes = {0};
  HolePatch lid = *flat_patch(make_site(tube, analysis, holes, {}), false, progress);
  const auto given = static_cast<Index>(tube.vertex_count());
  const auto middle_of = [&](const std::array<Index, 3>& t) {
    return Vec3((tube.positions[t[0]] + tube.positions[t[1]] + tube.positions[t[2]]) / 3);
  };
  // One new vertex in the lid is enough to ask, far from the rim.
  auto& middle = *std::ranges::min_element(lid.triangles, {}, [&](const auto& t) {
    const Vec3 place = middle_of(t);
    return std::hypot(place.x(), place.y());
  });
  const auto split = middle;
  lid.points.push_back(middle_of(split));
  middle = {split[0], split[1], given};
  lid.triangles.push_back({split[1], split[2], given});
  lid.triangles.push_back({split[2], split[0], given});
  CHECK(vertex_confidence(lid, tube, analysis).front() < 0.12F);  // 90 degrees
}

TEST_CASE("patches without new vertices have no confidence per vertex") {
  CHECK(close_first(cut(round_sphere(3), Vec3(0, 0, 1), 0.5).mesh, Maker::Flat).confidence.empty());
}

TEST_CASE("the more is cut off a sphere, the less its patch is trusted, and what is trusted is right") {
  for (const Fairness fairness : {Fairness::Flat, Fairness::Tangent, Fairness::Implicit}) {
    double before = 1;
    for (const double radius : {0.3, 0.5, 0.7, 0.9, 1.1, 1.3}) {
      const Trusted patch = refilled_cap(radius, fairness);
      CAPTURE(static_cast<int>(fairness), radius, patch.confidence, patch.error);
      CHECK(patch.confidence <= before);
      if (patch.confidence > 0.7) CHECK(patch.error < 0.005);
      if (patch.confidence > 0.5) CHECK(patch.error < 0.015);
      if (patch.confidence > 0.3) CHECK(patch.error < 0.03);
      if (radius > 1.2) CHECK(patch.confidence < low_confidence);
      before = patch.confidence;
    }
  }
}

TEST_CASE("a flat cap over a wide section isn't trusted, one over a pinhole is") {
  CAPTURE(refilled_cap(1.1, Fairness::Flat).confidence);
  CHECK(refilled_cap(1.1, Fairness::Flat).confidence < 0.2);
  CHECK(refilled_cap(0.09, Fairness::Flat).confidence > 0.6);
}

TEST_CASE("rough rims don't make a patch doubtful, a fold all round does") {
  const PolyMesh rough = with_noisy_rims(cut(round_sphere(4), Vec3(0, 0, 1), 0.3).mesh, 2, 0.3);
  const Made made = close_first(rough, Maker::Implicit);
  CHECK(confidence_of(made.patch, made.mesh, made.analysis) > 0.35);
  const PolyMesh tube = open_tube(1, 2, 48, 16);
  const Made lid = close_first(tube, Maker::Flat);
  CHECK(confidence_of(lid.patch, lid.mesh, lid.analysis) < 0.05);
}

TEST_CASE("a fold of more than 90 degrees in a patch or at its rim lowers the confidence, at 120 by a half") {
  CHECK(trust_in_fold(std::numbers::pi / 2) == 1);
  CHECK(trust_in_fold(doubtful_fold) == Approx(0.5));
  CHECK(trust_in_fold(150 * std::numbers::pi / 180) == Approx(0.2));
  // Four squares of a sheet are missing; the middle of their fan is pulled up, or over the sheet beside them.
  const PolyMesh mesh = cut(sheet(20, 20), Vec3(10, 10, 0), 1.1).mesh;
  Progress progress;
  const HoleAnalysis analysis = analyse_holes(mesh, progress);
  const Index id = inner_hole(mesh);
  const auto confidence = [&](const Vec3& offset) {
    HolePatch fan{{id}, {analysis.holes[id].centre + offset}, {}};
    const std::vector<Index>& rim = analysis.holes[id].vertices;
    for (std::size_t i = 0; i < rim.size(); ++i)
      fan.triangles.push_back({rim[(i + 1) % rim.size()], rim[i], static_cast<Index>(mesh.vertex_count())});
    return confidence_of(fan, mesh, analysis);
  };
  CHECK(confidence({0, 0, 0}) > 0.9);
  CHECK(confidence({0, 0, 0.5}) < confidence({0, 0, 0}));
  CHECK(confidence({3, 0, 0.3}) < 0.4 * confidence({0, 0, 2}));
}
