// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "algorithms/remeshing/memory.h"
#include "croquis/base/error.h"
#include "hole_filling/fill_invariants.h"
#include "remeshing/remeshed.h"
#include "support/allocation_count.h"
#include "support/meshes/mesh_shapes.h"
#include "support/sample_count.h"
#include "support/scans/scans.h"

using namespace croquis;
using namespace croquis::test;
using namespace croquis::hole_filling;
using namespace croquis::remeshing;

namespace {

struct Trial {
  std::string name;
  PolyMesh mesh;
  RemeshOptions options = {};
};

PolyMesh plate(Index n, double wall, double height) {
  return transformed(divided_box(n), Eigen::Translation3d(0, 0, height) * Eigen::Scaling(1.0, 1.0, wall));
}

PolyMesh holed_torus(Index sides) { return random_cuts(ring_torus(2 * sides, sides), 1, 8, 0.04, 0.2).mesh; }

PolyMesh with_values(PolyMesh mesh) {
  for (const char* name : {"normal", "color"})
    mesh.channels.push_back({name, Domain::Vertex, 3, std::vector<float>(3 * mesh.vertex_count(), 0), {}});
  return mesh;
}

RemeshOptions refined(int rounds, double cell) {
  RemeshOptions options;
  options.refine = rounds;
  options.cell = cell;
  return options;
}

RemeshOptions selecting(Selection selection) {
  RemeshOptions options;
  options.fill.selection = selection;
  return options;
}

RemeshOptions merging(double adaptive) {
  RemeshOptions options;
  options.adaptive = adaptive;
  return options;
}

std::vector<Trial> all_trials() {
  return {{"torus with holes", holed_torus(130)},
          {"values of vertices", with_values(holed_torus(90))},
          {"refined", holed_torus(64), refined(1, 1)},
          {"small cells", holed_torus(64), refined(0, 0.5)},
          {"open tube", open_tube(1, 6, 130, 260)},
          {"tube with caps", open_tube(1, 6, 90, 180), selecting(Selection::All)},
          {"half a ball", cut(round_sphere(5), Vec3(0, 0, 1), 1.3).mesh},
          {"sheet with holes", random_cuts(sheet(140, 140), 3, 5, 2, 10).mesh},
          {"shell", shell(5, 0.05)},
          {"plate that tears", plate(36, 0.35 / 36, 0)},
          {"plate that gets lost", plate(36, 0.15 / 36, 0)},
          {"plates that nearly touch", merged(plate(30, 0.012, 0), plate(30, 0.012, 0.013))},
          {"balls that cross", merged(round_sphere(5), translated(round_sphere(5), Vec3(1.5, 0, 0)))},
          {"ball through a tube", merged(open_tube(1, 4, 150, 120), translated(round_sphere(5), Vec3(1, 0, 2)))},
          {"few large faces", cube()},
          {"soup", as_soup(holed_torus(90))},
          {"sharp", holed_torus(64), remesh_preset(Preset::Sharp)},
          {"paper", holed_torus(64), remesh_preset(Preset::Paper)},
          {"faces merged", holed_torus(130), merging(0.1)},
          {"faces merged of a plate that tears", plate(36, 0.35 / 36, 0), merging(0.1)}};
}

/// Every other one from `first` on; with full counts all.
std::vector<Trial> trials(std::size_t first) {
  std::vector<Trial> all = all_trials(), some;
  if (sample_count(0, 1) > 0) return all;
  for (std::size_t i = first; i < all.size(); i += 2) some.push_back(std::move(all[i]));
  return some;
}

/// Bytes at a time, where they can be counted; also of a model of which nothing is left in the end.
std::optional<std::size_t> used(const PolyMesh& mesh, RemeshOptions options) {
  options.fill.threads = 2;
  const AllocationPeak peak;
  try {
    remesh(mesh, options);
  } catch (const Error& error) {
    if (error.findings().front().code != "E_NOT_REMESHED") throw;
  }
  return peak.bytes();
}

// Room for large fits and buffers that is in every prediction, less than what these models need beside it.
std::size_t without_fixed(std::size_t bytes) { return bytes - std::min<std::size_t>(bytes, 64'000'000); }

}  // namespace

TEST_CASE("no model takes more memory than predicted, even if it is tried again and made one solid") {
  if (!AllocationPeak().bytes()) return;  // the models are made elsewhere, too
  for (const Trial& trial : trials(0)) {
    CAPTURE(trial.name);
    RemeshOptions options = trial.options;
    options.fill.threads = 2;
    const std::size_t predicted = predicted_remesh_bytes(trial.mesh, options);
    CHECK(*used(trial.mesh, options) < without_fixed(predicted));
  }
}

TEST_CASE("within the least limit that isn't refused models are made, in thinner slabs and without trying again") {
  for (const Trial& trial : trials(1)) {
    CAPTURE(trial.name);
    RemeshOptions options = trial.options;
    options.fill.threads = 2;
    options.memory_limit = least_remesh_bytes(trial.mesh, options);
    CHECK(predicted_remesh_bytes(trial.mesh, options) == options.memory_limit);
    if (AllocationPeak().bytes()) CHECK(*used(trial.mesh, options) < options.memory_limit);
    options.memory_limit -= 1;
    CHECK_THROWS_AS(used(trial.mesh, options), Error);
  }
}

TEST_CASE("what the whole model at once would exceed, slabs make within the limit, and as it would be") {
  const PolyMesh mesh = holed_torus(200);
  RemeshOptions options;
  options.fill.threads = 2;
  options.slab_points = 2 * mesh.vertex_count();
  const std::size_t at_once = least_remesh_bytes(mesh, options);
  const RemeshResult whole = remesh(mesh, options);
  CHECK(whole.slabs == 1);
  const auto used_at_once = used(mesh, options);
  options.slab_points = 0;
  options.memory_limit = least_remesh_bytes(mesh, options) + 5'000'000;
  CHECK(options.memory_limit < at_once);
  const RemeshResult thin = remesh(mesh, options);
  CHECK(thin.slabs > 5);
  CHECK(thin.mesh.positions == whole.mesh.positions);
  CHECK(thin.mesh.corners == whole.mesh.corners);
  if (used_at_once) CHECK(static_cast<double>(*used(mesh, options)) < 0.8 * static_cast<double>(*used_at_once));
}
