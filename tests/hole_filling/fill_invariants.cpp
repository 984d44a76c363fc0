// SPDX-License-Identifier: GPL-3.0-or-later
#include "hole_filling/fill_invariants.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

namespace croquis::test {

using namespace hole_filling;

FillResult fill(const PolyMesh& mesh, const FillOptions& options) {
  Progress progress;
  return fill_holes(mesh, options, progress);
}

FillOptions by(Fairness fairness) {
  FillOptions options;
  options.fairness = fairness;
  return options;
}

MeshReport report_of(const PolyMesh& mesh) {
  Progress progress;
  return inspect(mesh, true, progress);
}

std::size_t filled(const FillResult& result) {
  return static_cast<std::size_t>(
      std::count_if(result.outcomes.begin(), result.outcomes.end(),
                    [](const HoleOutcome& outcome) { return outcome.action == FillAction::Fill; }));
}

std::size_t filled_by(const FillResult& result, const std::string& method) {
  return static_cast<std::size_t>(std::count_if(result.outcomes.begin(), result.outcomes.end(),
                                                [&](const HoleOutcome& outcome) { return outcome.method == method; }));
}

std::string sentence_of(const FillResult& result, const std::string& code) {
  std::string found;
  for (const Finding& finding : result.warnings) {
    if (finding.code != code) continue;
    CHECK(found.empty());
    found = finding.message;
  }
  return found;
}

double mean_error_of_first_ring(const FillResult& result) {
  const std::size_t given = result.mesh.vertex_count() - result.new_vertices;
  double sum = 0, count = 0;
  for (std::size_t f = result.mesh.face_count() - result.new_faces; f < result.mesh.face_count(); ++f) {
    const auto face = result.mesh.face(f);
    if (std::none_of(face.begin(), face.end(), [&](Index v) { return v < given; })) continue;
    for (const Index v : face) {
      if (v < given) continue;
      sum += std::abs(result.mesh.positions[v].norm() - 1);
      count += 1;
    }
  }
  return sum / count;
}

bool begins_with(const PolyMesh& grown, const PolyMesh& given) {
  return grown.vertex_count() >= given.vertex_count() && grown.face_count() >= given.face_count() &&
         std::equal(given.positions.begin(), given.positions.end(), grown.positions.begin()) &&
         std::equal(given.face_offsets.begin(), given.face_offsets.end(), grown.face_offsets.begin()) &&
         std::equal(given.corners.begin(), given.corners.end(), grown.corners.begin());
}

namespace {

/// Rims as sorted lists of vertices, those that are open with `open` alone.
std::multiset<std::vector<Index>> rims(const HoleAnalysis& analysis, const std::vector<HoleOutcome>* outcomes) {
  std::multiset<std::vector<Index>> found;
  for (const Hole& hole : analysis.holes) {
    if (outcomes != nullptr && (*outcomes)[hole.id].action == FillAction::Fill) continue;
    std::vector<Index> vertices = hole.vertices;
    std::sort(vertices.begin(), vertices.end());
    found.insert(std::move(vertices));
  }
  return found;
}

}  // namespace

void check_invariants(const PolyMesh& mesh, const FillResult& result, std::int64_t pinches) {
  CHECK(begins_with(result.mesh, mesh));
  const MeshReport before = report_of(mesh);
  const MeshReport after = report_of(result.mesh);
  std::size_t rim_count = 0, closed_edges = 0;
  std::set<Index> patches;
  for (std::size_t i = 0; i < result.outcomes.size(); ++i) {
    const HoleOutcome& outcome = result.outcomes[i];
    if (outcome.action != FillAction::Fill) CHECK_FALSE(outcome.reason.empty());
    CHECK((outcome.action == FillAction::Fill) == !outcome.method.empty());
    if (outcome.action != FillAction::Fill) continue;
    ++rim_count;
    closed_edges += result.analysis.holes[i].vertices.size();
    patches.insert(outcome.patch);
  }
  Progress progress;
  CHECK(rims(analyse_holes(result.mesh, progress), nullptr) == rims(result.analysis, &result.outcomes));
  CHECK(after.boundary_edges == before.boundary_edges - closed_edges);
  CHECK(after.nonmanifold_edges == before.nonmanifold_edges);
  CHECK(after.nonmanifold_vertices <= before.nonmanifold_vertices);
  CHECK(after.degenerate_faces == before.degenerate_faces);
  CHECK(after.oriented == before.oriented);
  CHECK(*after.self_intersections == *before.self_intersections);
  // Each patch is a sphere with as many holes as it closes.
  CHECK(after.euler_characteristic ==
        before.euler_characteristic + pinches + static_cast<std::int64_t>(2 * patches.size() - rim_count));
  CHECK(result.new_vertices == result.mesh.vertex_count() - mesh.vertex_count());
  CHECK(result.new_faces == result.mesh.face_count() - mesh.face_count());
}

}  // namespace croquis::test
