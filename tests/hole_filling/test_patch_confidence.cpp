// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <vector>

#include <catch2/catch.hpp>

#include "algorithms/hole_filling/patching/patch_confidence.h"
#include "algorithms/hole_filling/patching/patcher.h"
#include "support/scans.h"

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
Made close_first(const PolyMesh& mesh, const Patcher& patcher, Index hole = 0) {
  Progress progress;
  Made made{mesh, analyse_holes(mesh, progress), {}, {}};
  const std::vector<Index> holes = {hole};
  made.patch = *patcher.attempt(make_site(mesh, made.analysis, holes, {}), progress);
  made.confidence = vertex_confidence(made.patch, mesh, made.analysis);
  return made;
}

Index inner_hole(const PolyMesh& mesh) {
  Progress progress;
  for (const Hole& hole : analyse_holes(mesh, progress).holes) {
    if (hole.kind != HoleClass::Outer) return hole.id;
  }
  return no_index;
}

}  // namespace

TEST_CASE("confidence falls from the rim to the middle of a flat patch, where it is about a half") {
  const PolyMesh mesh = cut(sheet(40, 40), Vec3(20, 20, 0), 9).mesh;
  const Made made = close_first(mesh, *implicit_patcher({}, 40000), inner_hole(mesh));
  REQUIRE(made.confidence.size() == made.patch.points.size());
  float least = 1;
  for (std::size_t v = 0; v < made.confidence.size(); ++v) {
    const double from_middle = (made.patch.points[v] - Vec3(20, 20, 0)).norm();
    least = std::min(least, made.confidence[v]);
    CHECK(made.confidence[v] > 0);
    CHECK(made.confidence[v] <= 1);
    if (from_middle > 6) CHECK(made.confidence[v] > 0.9F);
    if (from_middle < 2) CHECK(made.confidence[v] < 0.85F);
  }
  CHECK(least == Approx(0.6).margin(0.1));
}

TEST_CASE("the least confidence of a smooth patch is that of the whole patch") {
  const Made made = close_first(cut(round_sphere(4), Vec3(0, 0, 1), 0.5).mesh, *implicit_patcher({}, 40000));
  const float least = *std::min_element(made.confidence.begin(), made.confidence.end());
  CHECK(least == Approx(confidence_of(made.patch, made.mesh, made.analysis)).margin(0.02));
}

TEST_CASE("a lid across a tube, at right angles to it, isn't trusted") {
  const PolyMesh tube = open_tube(1, 2, 48, 16);
  Progress progress;
  const HoleAnalysis analysis = analyse_holes(tube, progress);
  const std::vector<Index> holes = {0};
  HolePatch lid = *minimal_patcher()->attempt(make_site(tube, analysis, holes, {}), progress);
  const auto given = static_cast<Index>(tube.vertex_count());
  const auto split = lid.triangles.front();  // one new vertex in the lid is enough to ask
  lid.points.push_back((tube.positions[split[0]] + tube.positions[split[1]] + tube.positions[split[2]]) / 3);
  lid.triangles.front() = {split[0], split[1], given};
  lid.triangles.push_back({split[1], split[2], given});
  lid.triangles.push_back({split[2], split[0], given});
  CHECK(vertex_confidence(lid, tube, analysis).front() < 0.12F);  // 90 degrees: a seventeenth of what distance leaves
}

TEST_CASE("patches without new vertices have no confidence per vertex") {
  CHECK(close_first(cut(round_sphere(3), Vec3(0, 0, 1), 0.5).mesh, *minimal_patcher()).confidence.empty());
}
