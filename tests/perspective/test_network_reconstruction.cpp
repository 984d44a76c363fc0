// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <atomic>
#include <cstdint>
#include <map>
#include <set>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/base/stage_cache.h"
#include "croquis/geometry/mesh_report.h"
#include "croquis/perspective/face_finding.h"
#include "croquis/perspective/network_reconstruction.h"
#include "croquis/perspective/solid.h"
#include "perspective/network_shapes.h"
#include "perspective/network_truth.h"
#include "support/perspective/solid_drawing.h"
#include "support/perspective/solids.h"
#include "support/perspective/views.h"

using namespace croquis;
using namespace croquis::test;

namespace {

SolidDrawing by_hand(const PerspectiveSolid& solid, const View& view, std::uint64_t seed) {
  SolidDrawingOptions options;
  options.noise = 1.5;
  options.end_jitter = 0.4;
  options.vertex_ids = false;
  options.seed = seed;
  return drawn(solid, view, options);
}

/// By the true vertex.
std::map<Index, Vec3> by_truth(const SolidDrawing& truth, const PerspectiveDrawing& drawing,
                               const ReconstructedNetwork& network) {
  const std::vector<Index> to = true_vertices(truth, drawing, network.vertices);
  std::map<Index, Vec3> result;
  for (std::size_t v = 0; v < to.size(); ++v) {
    if (to[v] != no_index) result[to[v]] = network.coordinates.positions[v];
  }
  return result;
}

double greatest_difference(const std::map<Index, Vec3>& one, const std::map<Index, Vec3>& other) {
  REQUIRE(one.size() == other.size());
  double greatest = 0;
  for (const auto& [index, position] : one) greatest = std::max(greatest, (position - other.at(index)).norm());
  return greatest;
}

/// Keeps everything and counts what had to be made.
class CountingCache : public StageCache {
 public:
  std::shared_ptr<const void> get(std::string_view stage, std::string_view content,
                                  const std::function<Stage()>& make) override {
    const std::pair<std::string, std::string> key{stage, content};
    if (const auto found = kept_.find(key); found != kept_.end()) return found->second;
    ++made;
    return kept_[key] = make().result;
  }

  int made = 0;

 private:
  std::map<std::pair<std::string, std::string>, std::shared_ptr<const void>> kept_;
};

/// Looks along the line from one corner to another one, so that both are seen at one place.
Camera along(const PerspectiveSolid& solid, Index near, Index far) {
  Camera camera = camera_for(solid, three_point_views()[1]);
  const Vec3 &a = solid.network.vertices[near], &b = solid.network.vertices[far];
  const Vec3 forward = (b - a).normalized();
  const Vec3 right = forward.cross(Vec3::UnitZ()).normalized();
  camera.rotation.row(0) = right;
  camera.rotation.row(1) = forward.cross(right);
  camera.rotation.row(2) = forward;
  camera.eye = (a + b) / 2 - 2.2 * (b - a).norm() * forward;
  return camera;
}

PerspectiveStroke& stroke_of(PerspectiveDrawing& drawing, const std::string& id) {
  return *std::ranges::find(drawing.strokes, id, &PerspectiveStroke::id);
}

}  // namespace

TEST_CASE("Order, direction and names of strokes don't change the result") {
  for (const PerspectiveSolid& solid : all_solids()) {
    for (const double wrong : {0.0, 1.0}) {
      SolidDrawing truth = by_hand(solid, three_point_views()[1], 6);
      if (wrong > 0) {  // with something to be told
        PerspectiveStroke& stroke = truth.drawing.strokes[truth.drawing.strokes.size() / 2];
        stroke.group =
            static_cast<StrokeGroup>((static_cast<int>(stroke.group) + 1) % 3 + (is_parallel(stroke.group) ? 0 : 3));
      }
      INFO(solid.name << ", wrong " << wrong);
      const ReconstructedNetwork one = reconstructed(truth.drawing);
      const PerspectiveDrawing other_drawing = shuffled_and_renamed(truth.drawing, 12);
      const ReconstructedNetwork other = reconstructed(other_drawing);
      CHECK(greatest_difference(by_truth(truth, truth.drawing, one), by_truth(truth, other_drawing, other)) <
            1e-12 * true_diagonal(truth));
      CHECK(codes_of(one.warnings) == codes_of(other.warnings));
      CHECK(one.curves.network.curves.size() == other.curves.network.curves.size());
    }
  }
}

TEST_CASE("The size and place of the sheet don't change the result") {
  for (const View& view : all_views()) {
    for (const PerspectiveSolid& solid : {l_block(), bottle(), camera_body(), soap()}) {
      const SolidDrawing truth = by_hand(solid, view, 2);
      const ReconstructedNetwork one = reconstructed(truth.drawing);
      const PerspectiveDrawing enlarged = scaled_and_moved(truth.drawing, 0.37, Vec2(1234, -77));
      const ReconstructedNetwork other = reconstructed(enlarged);
      INFO(view.name << ", " << solid.name);
      CHECK(greatest_difference(by_truth(truth, truth.drawing, one), by_truth(truth, enlarged, other)) <
            1e-9 * true_diagonal(truth));
      CHECK(codes_of(one.warnings) == codes_of(other.warnings));
    }
  }
}

TEST_CASE("Every stroke that a warning names is flagged, and no other") {
  SolidDrawing truth = by_hand(camera_body(), three_point_views()[1], 3);
  stroke_of(truth.drawing, "e03").group = StrokeGroup::Unknown;
  stroke_of(truth.drawing, "e05").pieces[0][3].x() = std::nan("");
  const ReconstructedNetwork network = reconstructed(truth.drawing);
  std::set<std::string> named;
  for (const Finding& finding : network.warnings) {
    for (const Subject& subject : finding.subjects) named.insert(subject.id);
  }
  CHECK(named.contains("e03"));
  CHECK(named.contains("e05"));
  for (std::size_t s = 0; s < truth.drawing.strokes.size(); ++s) {
    CHECK(network.flagged[s] == named.contains(truth.drawing.strokes[s].id));
  }
}

TEST_CASE("Cameras are kept while strokes that don't make them are dragged") {
  SolidDrawing truth = by_hand(bottle(), three_point_views()[1], 3);
  CountingCache cache;
  NetworkReconstructionOptions options;
  options.cache = &cache;
  reconstructed(truth.drawing, options);
  const int made = cache.made;
  CHECK(made > 0);
  const auto curve =
      std::ranges::find_if(truth.drawing.strokes, [](const PerspectiveStroke& s) { return !s.straight; });
  curve->pieces[0][1] += Vec2(3, 2);
  const ReconstructedNetwork again = reconstructed(truth.drawing, options);
  CHECK(cache.made == made);
  const ReconstructedNetwork fresh = reconstructed(truth.drawing);
  CHECK(again.camera.camera.focal_length == fresh.camera.camera.focal_length);
  CHECK(again.coordinates.positions == fresh.coordinates.positions);
  stroke_of(truth.drawing, "c1").pieces[0][0] += Vec2(1, 0);
  reconstructed(truth.drawing, options);
  CHECK(cache.made == made + 1);
}

TEST_CASE("A held camera stays while lines move") {
  SolidDrawing truth = by_hand(box(), three_point_views()[1], 3);
  NetworkReconstructionOptions options;
  options.held_camera = reconstructed(truth.drawing).camera;
  const double focal_length = options.held_camera->camera.focal_length;
  for (Vec2& point : stroke_of(truth.drawing, "c1").pieces[0]) point += Vec2(20, -10);
  CHECK(reconstructed(truth.drawing, options).camera.camera.focal_length == focal_length);
  CHECK(reconstructed(truth.drawing).camera.camera.focal_length != focal_length);
}

TEST_CASE("In one-point perspective a known depth gives the focal length") {
  View view = frontal_view();
  view.field_of_view = 0.55;
  for (const PerspectiveSolid& solid : {box(), l_block(), camera_body()}) {
    SolidDrawing truth = drawn(solid, view);
    INFO(solid.name);
    CHECK(codes_of(reconstructed(truth.drawing).warnings) == std::vector<std::string>{"FOCAL_ASSUMED"});
    for (const NetworkCurve& curve : solid.network.curves) {
      if (!curve.straight) continue;
      const double length = (solid.network.vertices[curve.end] - solid.network.vertices[curve.start]).norm();
      truth.drawing.known_lengths.push_back({curve.id, length});
    }
    const ReconstructedNetwork network = reconstructed(truth.drawing);
    CHECK(network.warnings.empty());
    CHECK(network.camera.camera.focal_length == Approx(truth.camera.focal_length).epsilon(1e-9));
    CHECK(greatest_error(truth, truth.drawing, network.vertices, network.coordinates.positions) < 1e-9);
  }
}

TEST_CASE("Corners that lie behind each other are told apart") {
  struct Case {
    PerspectiveSolid solid;
    Index near, far;
  };
  for (const auto& [solid, near, far] :
       {Case{box(), 5, 3}, Case{l_block(), 4, 7}, Case{stack(2), 9, 3}, Case{stack(3), 9, 3}, Case{stack(3), 5, 3}}) {
    for (const double noise : {0.0, 2.0, 5.0}) {
      for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        SolidDrawingOptions options;
        options.noise = noise;
        options.vertex_ids = false;
        options.seed = seed;
        const SolidDrawing truth = drawn(solid, along(solid, near, far), options);
        const ReconstructedNetwork network = reconstructed(truth.drawing);
        INFO(solid.name << " from " << near << " to " << far << ", noise " << noise << ", seed " << seed);
        CHECK(network.warnings.empty());
        CHECK(network.vertices.vertices.size() == solid.network.vertices.size());
        Progress progress;
        CHECK(find_faces(network.curves.network, progress).best.faces.size() == solid.faces.size());
        if (noise == 0)
          CHECK(greatest_error(truth, truth.drawing, network.vertices, network.coordinates.positions) < 1e-9);
      }
    }
  }
}

TEST_CASE("A reconstruction tells its progress and can be stopped") {
  const SolidDrawing truth = by_hand(camera_body(), three_point_views()[1], 3);
  std::vector<double> fractions;
  Progress heard([&](double fraction, const std::string&) { fractions.push_back(fraction); });
  reconstruct_network(truth.drawing, {}, heard);
  CHECK(std::ranges::is_sorted(fractions));
  CHECK(fractions.back() == 1);
  std::atomic<bool> stop = true;
  Progress stopped({}, &stop);
  CHECK_THROWS_AS(reconstruct_network(truth.drawing, {}, stopped), Cancelled);
}

TEST_CASE("Drawings that hold nothing to solve for are told as such") {
  SolidDrawing truth = by_hand(box(), three_point_views()[1], 3);
  std::erase_if(truth.drawing.strokes, [](const PerspectiveStroke& s) { return s.role == StrokeRole::Edge; });
  truth.drawing.known_lengths.clear();
  const ReconstructedNetwork network = reconstructed(truth.drawing);
  CHECK(network.coordinates.positions.empty());
  CHECK(network.curves.network.curves.empty());
}

/// From a drawing to a solid, without any of the true solid's numbers.
using namespace croquis;
using namespace croquis::test;

namespace {

ReconstructedNetwork network_of(const SolidDrawing& truth) {
  Progress progress;
  return reconstruct_network(truth.drawing, {}, progress);
}

}  // namespace

TEST_CASE("drawings without noise become solids") {
  for (const PerspectiveSolid& test : all_solids()) {
    for (const View& view : all_views()) {
      SolidDrawingOptions options;
      options.vertex_ids = false;
      INFO(test.name << ", " << view.name);
      const ReconstructedNetwork network = network_of(drawn(test, view, options));
      const FaceFindingResult faces = faces_of(network.curves.network);
      CHECK(ids_of_faces(network.curves.network, faces.best) == ids_of_faces(test));
      Progress progress;
      const Solid solid = make_solid(network.curves.network, network.fitted, faces.best, progress);
      Progress report_progress;
      const MeshReport mesh = inspect(solid.tessellation.mesh, true, report_progress);
      CHECK(validate(solid.brep).empty());
      CHECK(mesh.closed);
      CHECK(mesh.euler_characteristic == 2 * (test.shells - test.genus));
      CHECK(mesh.self_intersections == 0);
    }
  }
}

TEST_CASE("drawings by hand have the faces of the solid") {
  for (const double noise : {2.0, 5.0, 10.0}) {
    for (const PerspectiveSolid& test : all_solids()) {
      // Its round stroke of two pieces gets a corner by noise, and with it another vertex.
      if (test.name == "D-block") continue;
      for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        INFO(test.name << ", noise " << noise << ", seed " << seed);
        SolidDrawingOptions options;
        options.noise = noise;
        options.seed = seed;
        const ReconstructedNetwork network = network_of(drawn(test, three_point_views()[1], options));
        const FaceFindingResult faces = faces_of(network.curves.network);
        CHECK(ids_of_faces(network.curves.network, faces.best) == ids_of_faces(test));
        Progress progress;
        CHECK(validate(make_solid(network.curves.network, network.fitted, faces.best, progress).brep).empty());
      }
    }
  }
}
