// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <atomic>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "algorithms/remeshing/memory.h"
#include "croquis/base/error.h"
#include "hole_filling/fill_invariants.h"
#include "remeshing/remeshed.h"
#include "support/meshes/mesh_shapes.h"
#include "support/meshes/surface_distance.h"
#include "support/scans/scans.h"
#include "support/scans/virtual_scans.h"

using namespace croquis;
using namespace croquis::test;
using namespace croquis::hole_filling;
using namespace croquis::remeshing;

namespace {

PolyMesh holed_torus() { return random_cuts(ring_torus(80, 40), 1, 5, 0.06, 0.2).mesh; }

PolyMesh remeshed(const PolyMesh& mesh, const RemeshOptions& options = {}) { return remesh(mesh, options).mesh; }

Findings refusal_of(const PolyMesh& mesh, const RemeshOptions& options) {
  try {
    remeshed(mesh, options);
  } catch (const Error& error) {
    return error.findings();
  }
  return {};
}

/// Greatest distance of the vertices of each to the other.
double difference(const PolyMesh& a, const PolyMesh& b) {
  return std::max(summary_of_distances(a.positions, SurfaceDistance(b)).greatest,
                  summary_of_distances(b.positions, SurfaceDistance(a)).greatest);
}

}  // namespace

TEST_CASE("one, two and eight threads make the same model, bit by bit") {
  PolyMesh mesh = holed_torus();
  mesh.channels.push_back({"weight", Domain::Vertex, 1, std::vector<float>(mesh.vertex_count(), 0.5F), {}});
  RemeshOptions options;
  options.refine = 1;
  options.fill.threads = 1;
  const PolyMesh one = remeshed(mesh, options);
  for (const int threads : {2, 8}) {
    options.fill.threads = threads;
    const PolyMesh other = remeshed(mesh, options);
    CHECK(other.positions == one.positions);
    CHECK(other.corners == one.corners);
    REQUIRE(other.channels.size() == one.channels.size());
    for (std::size_t c = 0; c < one.channels.size(); ++c) CHECK(other.channels[c].data == one.channels[c].data);
  }
}

TEST_CASE("a model that is larger or elsewhere is remeshed as the same model") {
  const PolyMesh mesh = holed_torus();
  const PolyMesh made = remeshed(mesh);
  const double diagonal = diagonal_of(mesh);
  const PolyMesh tiny = remeshed(scaled(mesh, 1.0 / 1024));
  CHECK(difference(scaled(tiny, 1024), made) < 1e-6 * diagonal);
  const Vec3 far(1048576, -524288, 2097152);
  CHECK(difference(translated(remeshed(translated(mesh, far)), -far), made) < 1e-5 * diagonal);
  const Vec3 axis = Vec3(1, 2, 3).normalized();
  CHECK(difference(rotated(remeshed(rotated(mesh, 0.7, axis)), -0.7, axis), made) < 4e-3 * diagonal);
}

TEST_CASE("the order of vertices and faces changes nothing that can be seen") {
  const PolyMesh mesh = holed_torus();
  CHECK(difference(remeshed(shuffled(mesh, 3)), remeshed(mesh)) < 1e-3 * diagonal_of(mesh));
}

TEST_CASE("a model that would need too much memory is refused with the cell that would fit") {
  const PolyMesh mesh = holed_torus();
  RemeshOptions options;
  const std::size_t whole = least_remesh_bytes(mesh, options);
  options.memory_limit = whole;
  CHECK(refusal_of(mesh, options).empty());
  options.memory_limit = whole - 100000;
  const Findings findings = refusal_of(mesh, options);
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].code == "E_MEMORY");
  CHECK(findings[0].category == Category::Limit);
  const std::string before = "choose cells of ";
  const std::size_t at = findings[0].message.find(before);
  REQUIRE(at != std::string::npos);
  options.cell = std::stod(findings[0].message.substr(at + before.size()));
  CHECK(options.cell > 1);
  CHECK(options.cell < 2);
  CHECK(refusal_of(mesh, options).empty());
  options.memory_limit = 1000000;
  CHECK(refusal_of(mesh, options)[0].message.find("patches") != std::string::npos);
}

TEST_CASE("what is needed grows with vertices, finer cells and refinement, and never exceeds what is predicted") {
  RemeshOptions options;
  const PolyMesh mesh = round_sphere(5);
  const std::size_t base = least_remesh_bytes(mesh, options);
  const auto beyond = [&](const PolyMesh& other) { return least_remesh_bytes(other, options) - base; };
  CHECK(beyond(round_sphere(7)) > 4 * beyond(round_sphere(6)));
  options.cell = 0.5;
  const std::size_t fine = least_remesh_bytes(mesh, options);
  CHECK(fine > base);
  options.cell = 1;
  options.refine = 1;
  CHECK(least_remesh_bytes(mesh, options) == fine);  // four times the triangles, both
  CHECK(predicted_remesh_bytes(mesh, options) > fine);
  options.memory_limit = fine;
  CHECK(predicted_remesh_bytes(mesh, options) == fine);
  options.memory_limit = 2 * fine;
  CHECK(predicted_remesh_bytes(mesh, options) <= 2 * fine);
}

TEST_CASE("options out of range are all reported") {
  RemeshOptions options;
  options.cell = 0;
  options.overlap = 2;
  options.refine = 9;
  options.snap = -1;
  options.adaptive = 1.1;
  const Findings findings = refusal_of(holed_torus(), options);
  REQUIRE(findings.size() == 5);
  for (const Finding& finding : findings) CHECK(finding.code == "E_PARAMETER");
}

TEST_CASE("remeshing can be cancelled at every step, and progress only grows to 1") {
  const PolyMesh mesh = holed_torus();
  std::vector<double> fractions;
  std::vector<std::string> steps;
  const auto run = [&](double stop_at) {
    std::atomic<bool> cancel = false;
    fractions.clear();
    Progress progress(
        [&](double fraction, const std::string& step) {
          fractions.push_back(fraction);
          steps.push_back(step);
          if (fraction >= stop_at) cancel = true;
        },
        &cancel);
    RemeshOptions options;
    options.adaptive = 0.1;
    remesh_surface(mesh, options, progress);
  };
  run(2);
  CHECK(std::is_sorted(fractions.begin(), fractions.end()));
  CHECK(fractions.back() == 1);
  CHECK(std::count_if(steps.begin(), steps.end(), [](const std::string& step) {
          return step.find("fit ") == 0 && step.find(" domains") != std::string::npos;
        }) > 0);
  for (const double stop_at : {0.0, 0.05, 0.1, 0.3, 0.6, 0.7, 0.8, 0.9}) {
    CAPTURE(stop_at);
    CHECK_THROWS_AS(run(stop_at), Cancelled);
  }
}

TEST_CASE("where triangles are of many sizes cells don't make the model many times as large, and that is reported") {
  const PolyMesh dense = scaled(sheet(80, 80), 1.0 / 80), wide = translated(sheet(20, 20), Vec3(2, 0, 0));
  const PolyMesh mesh = merged(dense, wide);
  const RemeshResult result = remesh(mesh);
  CHECK(result.coarsening > 1.2);
  CHECK(warns(result, "W_CELLS_ENLARGED"));
  CHECK(warns(result, "W_MANY_FACES") == (result.mesh.face_count() > 4 * mesh.face_count()));
  CHECK(result.mesh.face_count() < 8 * mesh.face_count());
  CHECK(result.mesh.face_count() < result.predicted_faces);
  const RemeshResult even = remesh(dense);
  CHECK(even.coarsening == 1);
  CHECK(even.mesh.face_count() < even.predicted_faces);
}
