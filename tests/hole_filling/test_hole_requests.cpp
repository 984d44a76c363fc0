// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>
#include <numeric>
#include <set>
#include <utility>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/geometry/mesh_report.h"
#include "croquis/hole_filling/fill_holes.h"
#include "croquis/hole_filling/fill_options.h"
#include "hole_filling/fill_invariants.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"
#include "support/sample_count.h"
#include "support/scans/scans.h"

namespace croquis::hole_filling {
namespace {

using namespace test;

/// A sphere with six holes.
PolyMesh scan() { return random_cuts(round_sphere(4), 7, 6, 0.12, 0.3).mesh; }

/// Actions of the holes in their order: f, l, x for filled, left, failed.
std::string actions_of(const FillResult& result) {
  std::string actions;
  for (const HoleOutcome& outcome : result.outcomes)
    actions += outcome.action == FillAction::Fill ? 'f' : outcome.action == FillAction::Leave ? 'l' : 'x';
  return actions;
}

HoleRequest request_for(std::vector<Index> holes) {
  HoleRequest request;
  request.holes = std::move(holes);
  return request;
}

HoleRequest request_to_fill(std::vector<Index> holes, bool fill) {
  HoleRequest request = request_for(std::move(holes));
  request.fill = fill;
  return request;
}

/// The new vertices of one patch, in their order.
std::vector<Vec3> points_of(const FillResult& result, Index hole) {
  const auto& ids = std::get<std::vector<std::int32_t>>(result.mesh.channel("patch_id", Domain::Face)->data);
  std::set<Index> vertices;
  for (std::size_t f = 0; f < ids.size(); ++f) {
    if (ids[f] != static_cast<std::int32_t>(result.outcomes[hole].patch)) continue;
    for (const Index v : result.mesh.face(f)) vertices.insert(v);
  }
  std::vector<Vec3> points;
  for (const Index v : vertices) points.push_back(result.mesh.positions[v]);
  return points;
}

/// Keeps everything, and counts what had to be made.
class CountingCache final : public StageCache {
 public:
  std::shared_ptr<const void> get(std::string_view stage, std::string_view content,
                                  const std::function<Stage()>& make) override {
    const std::pair<std::string, std::string> key{stage, content};
    {
      const std::lock_guard lock(mutex_);
      if (const auto found = kept_.find(key); found != kept_.end()) return found->second;
    }
    std::shared_ptr<const void> result = make().result;
    const std::lock_guard lock(mutex_);
    ++made_[key.first];
    return kept_.emplace(key, std::move(result)).first->second;
  }

  /// Since the last call.
  std::map<std::string, int> take_counts() { return std::exchange(made_, {}); }

 private:
  std::mutex mutex_;
  std::map<std::pair<std::string, std::string>, std::shared_ptr<const void>> kept_;
  std::map<std::string, int> made_;
};

TEST_CASE("a request fills or leaves a hole whatever the selection says; the last one counts") {
  FillOptions options;
  options.selection = Selection::None;
  CHECK(actions_of(fill(scan(), options)) == "llllll");
  options.requests = {request_to_fill({1, 4}, true)};
  CHECK(actions_of(fill(scan(), options)) == "lfllfl");
  options.requests.push_back(request_to_fill({4}, false));
  CHECK(actions_of(fill(scan(), options)) == "lfllll");
  options.selection = Selection::All;
  options.max_diameter = 0.001;
  CHECK(actions_of(fill(scan(), options)) == "lfllll");
  options.max_diameter = std::numeric_limits<double>::infinity();
  options.requests = {request_to_fill({0, 2}, false)};
  const FillResult result = fill(scan(), options);
  CHECK(actions_of(result) == "lflfff");
  CHECK(result.outcomes[0].reason == "asked to stay open");
}

TEST_CASE("a request for a patch's shape fills the hole, one about trimming doesn't") {
  FillOptions options;
  options.selection = Selection::None;
  options.requests.assign(5, request_for({}));
  options.requests[0].holes = {0};
  options.requests[0].fairness = Fairness::Flat;
  options.requests[1].holes = {1};
  options.requests[1].bulge = 0.3;
  options.requests[2].holes = {2};
  options.requests[2].kernel = implicit::Kernel::Triharmonic;
  options.requests[3].holes = {3};
  options.requests[3].trim_rim = 1;
  options.requests[4].holes = {4};
  options.requests[4].through = {Vec3(0, 0, 1)};
  const std::string actions = actions_of(fill(scan(), options));
  CHECK(actions.substr(0, 4) == "fffl");
  CHECK(actions[4] != 'l');
  CHECK(actions[5] == 'l');
}

TEST_CASE("holes that aren't there are refused by their numbers, all at once") {
  FillOptions options;
  options.only = {1, 9};
  options.requests = {request_to_fill({2, 11, 12, 13, 20}, true)};
  try {
    fill(scan(), options);
    FAIL("unknown holes must be refused");
  } catch (const Error& error) {
    REQUIRE(error.findings().size() == 3);
    for (const Finding& finding : error.findings()) CHECK(finding.code == "E_PARAMETER");
    CHECK(error.findings()[1].message.find("11-13") != std::string::npos);
  }
}

TEST_CASE("a request for one hole changes its patch and no other") {
  const FillResult plain = fill(scan(), {});
  FillOptions options;
  options.requests = {request_for({2})};
  options.requests[0].fairness = Fairness::Flat;
  const FillResult asked = fill(scan(), options);
  CHECK(asked.outcomes[2].method == "minimal");
  CHECK(asked.outcomes[2].new_vertices == 0);
  for (const Index hole : {0u, 1u, 3u, 4u, 5u}) {
    CHECK(asked.outcomes[hole].method == plain.outcomes[hole].method);
    CHECK(points_of(asked, hole) == points_of(plain, hole));
  }
}

TEST_CASE("an open section is capped flat unless a request wants another shape") {
  const PolyMesh tube = open_tube(1, 4, 32, 10);
  FillOptions options;
  options.selection = Selection::All;
  options.requests = {request_to_fill({0}, true)};
  CHECK(fill(tube, options).outcomes[0].new_vertices == 0);
  options.requests[0].fairness = Fairness::Tangent;
  const FillResult result = fill(tube, options);
  CHECK(result.outcomes[0].new_vertices > 0);
  CHECK(result.outcomes[1].method == "minimal");
}

TEST_CASE("two rims that are bridged become one patch, a handle between them") {
  const PolyMesh sphere = round_sphere(4);
  const PolyMesh mesh = cut(cut(sphere, Vec3(0, 0, 1), 0.3).mesh, Vec3(0, 0, -1), 0.3).mesh;
  FillOptions options;
  options.requests = {request_for({0, 1})};
  options.requests[0].bridge = true;
  const FillResult result = fill(mesh, options);
  for (const Finding& finding : result.warnings) UNSCOPED_INFO(finding.message);
  REQUIRE(actions_of(result) == "ff");
  CHECK(result.outcomes[0].patch == result.outcomes[1].patch);
  const MeshReport report = report_of(result.mesh);
  CHECK(report.closed);
  CHECK(report.genus == 1);
  CHECK(report.self_intersections == 0);
  // A bridge with an end that stays open is none.
  options.requests.push_back(request_to_fill({1}, false));
  CHECK(actions_of(fill(mesh, options)) == "fl");
}

TEST_CASE("trimming removes rings of faces along the chosen rims and nothing else") {
  const PolyMesh mesh = scan();
  FillOptions options;
  options.trim_rim = 0;
  std::size_t removed = 0;
  for (const int rings : {1, 2, 3}) {
    options.trim_rim = rings;
    const FillResult result = fill(mesh, options);
    CHECK(actions_of(result) == "ffffff");
    CHECK(result.removed_faces > removed);
    removed = result.removed_faces;
    const MeshReport report = report_of(result.mesh);
    CHECK(report.closed);
    CHECK(report.genus == 0);
    CHECK(report.self_intersections == 0);
    CHECK(result.mesh.vertex_count() == mesh.vertex_count() - result.removed_vertices + result.new_vertices);
    CHECK(result.mesh.face_count() == mesh.face_count() - result.removed_faces + result.new_faces);
    CHECK(result.outside_unchanged);
    // What is left is the mesh's, in its order.
    std::size_t at = 0;
    const std::size_t kept = mesh.vertex_count() - result.removed_vertices;
    for (std::size_t v = 0; v < kept; ++v) {
      while (at < mesh.vertex_count() && mesh.positions[at] != result.mesh.positions[v]) ++at;
      REQUIRE(at < mesh.vertex_count());
    }
  }
}

TEST_CASE("a trimmed rim of a regular sheet is one ring wider") {
  PolyMesh mesh = cut(sheet(20, 20), Vec3(10, 10, 0), 3).mesh;
  Progress progress;
  const HoleAnalysis analysis = analyse_holes(mesh, progress);
  REQUIRE(analysis.holes.size() == 2);
  const auto& rim = analysis.holes[1].vertices;
  std::size_t touching = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    touching += std::any_of(face.begin(), face.end(),
                            [&](Index v) { return std::find(rim.begin(), rim.end(), v) != rim.end(); });
  }
  FillOptions options;
  options.trim_rim = 1;
  const FillResult result = fill(mesh, options);
  CHECK(actions_of(result) == "lf");
  CHECK(result.removed_faces >= touching);
  CHECK(result.removed_faces <= touching + 8);  // ears in the corners
  for (const Index v : rim) {
    const auto end =
        result.mesh.positions.begin() + static_cast<std::ptrdiff_t>(mesh.vertex_count() - result.removed_vertices);
    CHECK(std::find(result.mesh.positions.begin(), end, mesh.positions[v]) == end);
  }
}

TEST_CASE("trimming spares rims that stay open, even where they are near") {
  // Two holes a few edges apart: three rings of one would eat the other's rim.
  PolyMesh mesh = cut(cut(sheet(30, 20), Vec3(10, 10, 0), 3).mesh, Vec3(18, 10, 0), 3).mesh;
  FillOptions options;
  options.requests = {request_to_fill({2}, false)};
  options.trim_rim = 3;
  const FillResult result = fill(mesh, options);
  CHECK(actions_of(result) == "lfl");
  Progress progress;
  const HoleAnalysis after = analyse_holes(result.mesh, progress);
  REQUIRE(after.holes.size() == 2);
  CHECK(after.holes[1].perimeter == result.analysis.holes[2].perimeter);
  // Both to be filled, they become one hole.
  options.requests.clear();
  const FillResult both = fill(mesh, options);
  CHECK(actions_of(both) == "lff");
  CHECK(both.outcomes[1].patch == both.outcomes[2].patch);
}

TEST_CASE("an island that trimming leaves nothing of is gone, and attributes stay with what remains") {
  const PolyMesh ring = cut_ring(sheet(40, 40), Vec3(20, 20, 0), 1.6, 9).mesh;
  PolyMesh mesh = ring;
  std::vector<std::int32_t> numbers(mesh.vertex_count());
  std::iota(numbers.begin(), numbers.end(), 0);
  mesh.channels.push_back({"number", Domain::Vertex, 1, numbers, {"category"}});
  FillOptions options;
  options.trim_rim = 2;
  const FillResult result = fill(mesh, options);
  REQUIRE(result.outcomes.size() == 3);
  CHECK(actions_of(result) == "lff");
  const auto gone = std::count_if(result.outcomes.begin(), result.outcomes.end(),
                                  [](const HoleOutcome& outcome) { return outcome.method == "trimmed"; });
  CHECK(gone == 1);
  CHECK(report_of(result.mesh).boundary_loops == 1);
  const auto& kept = std::get<std::vector<std::int32_t>>(result.mesh.channel("number", Domain::Vertex)->data);
  for (std::size_t v = 0; v < mesh.vertex_count() - result.removed_vertices; ++v)
    CHECK(result.mesh.positions[v] == mesh.positions[static_cast<std::size_t>(kept[v])]);
}

TEST_CASE("trimming away the whole mesh is refused") {
  const PolyMesh mesh = cut(sheet(4, 4), Vec3(2, 2, 0), 1.1).mesh;
  FillOptions options;
  options.selection = Selection::All;
  options.trim_rim = 3;
  CHECK_THROWS_AS(fill(mesh, options), Error);
}

TEST_CASE("filling gives the same bytes on any number of threads") {
  FillOptions options;
  options.requests = {request_for({1})};
  options.requests[0].bulge = 0.4;
  const FillResult one = fill(scan(), options);
  for (const int threads : {2, 8}) {
    options.threads = threads;
    const FillResult many = fill(scan(), options);
    CHECK(many.mesh.positions == one.mesh.positions);
    CHECK(many.mesh.corners == one.mesh.corners);
    CHECK(many.mesh.channels.size() == one.mesh.channels.size());
    for (std::size_t i = 0; i < one.outcomes.size(); ++i) CHECK(many.outcomes[i].method == one.outcomes[i].method);
  }
}

TEST_CASE("rims with many triangulations of equal cost are filled the same again and again") {
  // Wherever in memory things come to lie.
  const PolyMesh mesh = random_cuts(round_sphere(4), 0, 7, 0.1, 0.3).mesh;
  FillOptions options;
  options.fairness = Fairness::Tangent;
  const FillResult first = fill(mesh, options);
  for (std::size_t step = 1; step < 8; ++step) {
    std::vector<std::vector<char>> elsewhere;
    for (std::size_t i = 0; i < 40 * step; ++i) elsewhere.emplace_back(17 * i + 1000 * step);
    const FillResult again = fill(mesh, options);
    CHECK((again.mesh.positions == first.mesh.positions));
    CHECK((again.mesh.corners == first.mesh.corners));
  }
}

TEST_CASE("with a cache the result is the same, and a changed setting makes one patch anew") {
  CountingCache cache;
  FillOptions options;
  const FillResult plain = fill(scan(), options);
  options.cache = &cache;
  const FillResult first = fill(scan(), options);
  CHECK(first.mesh.positions == plain.mesh.positions);
  CHECK(first.mesh.corners == plain.mesh.corners);
  CHECK(cache.take_counts()["fill/analysis/1"] == 1);
  const FillResult again = fill(scan(), options);
  CHECK(again.mesh.positions == plain.mesh.positions);
  CHECK(cache.take_counts().empty());
  options.requests = {request_for({3})};
  options.requests[0].fairness = Fairness::Flat;
  const FillResult changed = fill(scan(), options);
  CHECK(changed.outcomes[3].method == "minimal");
  CHECK(cache.take_counts() == std::map<std::string, int>{{"fill/patch/2", 1}, {"fill/verdict/2", 1}});
  // Another mesh, or another view of it, has nothing in common with this one.
  PolyMesh moved = scan();
  moved.positions.back().x() += 1e-9;
  fill(moved, options);
  CHECK(cache.take_counts()["fill/analysis/1"] == 1);
}

TEST_CASE("trimming one rim makes the patches within its reach anew, and no others") {
  // Small holes all over a ball: each has the next one out of reach, but for two that lie side by side.
  PolyMesh ball = round_sphere(5);
  const std::vector<Vec3> places = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0.22, 0, 0.97}};
  for (const Vec3& place : places) ball = cut(ball, place.normalized(), 0.07).mesh;
  CountingCache cache;
  FillOptions options;
  options.cache = &cache;
  const auto counts_of_filling = [&] {
    cache.take_counts();
    const FillResult filled = fill(ball, options);
    const auto counts = cache.take_counts();
    options.cache = nullptr;
    const FillResult plain = fill(ball, options);
    options.cache = &cache;
    CHECK((filled.mesh.positions == plain.mesh.positions));
    CHECK((filled.mesh.corners == plain.mesh.corners));
    for (std::size_t i = 0; i < plain.outcomes.size(); ++i)
      CHECK(filled.outcomes[i].method == plain.outcomes[i].method);
    return counts;
  };
  const std::map<std::string, int> one = {{"fill/patch/2", 1}, {"fill/trimmed/1", 1}, {"fill/verdict/2", 1}};
  const auto first = counts_of_filling();
  CHECK(first.at("fill/patch/2") == static_cast<int>(places.size()));
  const auto hole_at = [&](const Vec3& place) {
    const auto holes = fill(ball, {}).analysis.holes;
    const auto nearest = std::ranges::min_element(
        holes, {}, [&](const Hole& hole) { return (hole.centre - place.normalized()).norm(); });
    return nearest->id;
  };
  for (const int rings : {1, 2, 0}) {
    options.requests = {request_for({hole_at(places[0])})};
    options.requests[0].trim_rim = rings;
    if (rings > 0)
      CHECK(counts_of_filling() == one);
    else
      CHECK(counts_of_filling().empty());
  }
  options.requests[0].trim_rim = 1;
  options.requests.push_back(request_for({hole_at(places[3])}));
  options.requests[1].trim_rim = 1;
  CHECK(counts_of_filling() == one);
  options.requests = {request_for({hole_at(places[4])})};
  options.requests[0].trim_rim = 1;
  CHECK(counts_of_filling().at("fill/patch/2") == 2);
}

TEST_CASE("whatever is trimmed after what, a cache never changes the result") {
  for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(sample_count(2, 20)); ++seed) {
    const PolyMesh mesh = random_cuts(seed % 2 == 0 ? round_sphere(4) : bust(50, 60), seed, 7, 0.1, 0.3).mesh;
    Random random(seed);
    CountingCache cache;
    for (int step = 0; step < 6; ++step) {
      FillOptions options;
      const auto holes = static_cast<Index>(fill(mesh, options).analysis.holes.size());
      for (int k = 0; k < 2; ++k) {
        options.requests.push_back(request_for({random.below(holes)}));
        options.requests.back().trim_rim = 1 + k;
      }
      if (step % 3 == 2) options.preset = Preset::Sharp;
      const FillResult plain = fill(mesh, options);
      options.cache = &cache;
      const FillResult kept = fill(mesh, options);
      CAPTURE(seed, step, options.requests[0].holes, options.requests[1].holes, plain.analysis.holes.size());
      CHECK((kept.mesh.positions == plain.mesh.positions));
      CHECK((kept.mesh.corners == plain.mesh.corners));
    }
  }
}

TEST_CASE("a cancelled filling leaves nothing wrong in the cache") {
  const PolyMesh mesh = scan();
  const FillResult plain = fill(mesh, {});
  for (const int threads : {1, 4}) {
    CountingCache cache;
    FillOptions options;
    options.cache = &cache;
    options.threads = threads;
    for (int stop = 1; stop < 60; stop += 7) {
      std::atomic<bool> cancel = false;
      int reports = 0;
      bool finished = false;
      Progress stopped(
          [&](double fraction, const std::string&) {
            cancel = ++reports >= stop;
            finished = fraction == 1;
          },
          &cancel);
      try {
        fill_holes(mesh, options, stopped);
        CHECK(reports < stop);
      } catch (const Cancelled&) {
        CHECK(cancel);
      }
    }
    const FillResult after = fill(mesh, options);
    CHECK(after.mesh.positions == plain.mesh.positions);
    CHECK(after.mesh.corners == plain.mesh.corners);
  }
}

TEST_CASE("patches that are made are counted") {
  std::set<std::string> steps;
  double last = 0;
  Progress watched([&](double fraction, const std::string& step) {
    CHECK(fraction >= last);
    last = fraction;
    steps.insert(step);
  });
  fill_holes(scan(), {}, watched);
  CHECK(last == 1);
  CHECK(steps.contains("make patches 0 of 6"));
  CHECK(steps.contains("make patches 6 of 6"));
}

TEST_CASE("a mesh that would take more memory than allowed is refused before anything is made") {
  const PolyMesh mesh = scan();
  FillOptions options;
  const std::size_t bytes = predicted_fill_bytes(mesh, options);
  CHECK(bytes > 75 * mesh.face_count());
  options.memory_limit = bytes;
  CHECK(actions_of(fill(mesh, options)) == "ffffff");
  options.memory_limit = bytes - 1;
  try {
    fill(mesh, options);
    FAIL("must be refused");
  } catch (const Error& error) {
    REQUIRE(error.findings().size() == 1);
    CHECK(error.findings()[0].code == "E_MEMORY");
    CHECK(error.findings()[0].category == Category::Limit);
  }
}

}  // namespace
}  // namespace croquis::hole_filling
