// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>

#include <Eigen/LU>
#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/perspective/camera_estimation.h"
#include "perspective/network_truth.h"
#include "support/perspective/solids.h"
#include "support/perspective/views.h"
#include "support/random.h"

using namespace croquis;
using namespace croquis::test;

namespace {

constexpr double degree = std::numbers::pi / 180;

CameraEstimate estimated(const PerspectiveDrawing& drawing, const CameraOptions& options = {}) {
  Progress progress;
  return estimate_camera(drawing, options, progress);
}

/// The code of the error, or of the absence of one.
std::string error_of(const PerspectiveDrawing& drawing) {
  try {
    estimated(drawing);
    return "none";
  } catch (const Error& error) {
    return error.findings().front().code;
  }
}

Findings errors_of(const PerspectiveDrawing& drawing) {
  try {
    estimated(drawing);
    return {};
  } catch (const Error& error) {
    return error.findings();
  }
}

std::vector<PerspectiveSolid> some_solids() { return {box(), l_block(), bottle(), camera_body(), wedge(), soap()}; }

SolidDrawing noisy(const PerspectiveSolid& solid, const View& view, double noise, std::uint64_t seed) {
  SolidDrawingOptions options;
  options.noise = noise;
  options.seed = seed;
  return drawn(solid, view, options);
}

/// Lines that point exactly at the vanishing points, then with each end moved a bit.
PerspectiveDrawing lines_towards(const PerAxis<Vec2>& points, int count, double noise) {
  Random random(5);
  PerspectiveDrawing drawing;
  drawing.image_size = Vec2(1000, 750);
  for (int axis = 0; axis < 3; ++axis) {
    for (int i = 0; i < count; ++i) {
      const Vec2 a(random.between(100, 900), random.between(100, 650));
      const Vec2 b = a + 180 * (points[axis] - a).normalized();
      const auto moved = [&](const Vec2& p) {
        return Vec2(p + noise * Vec2(random.between(-1, 1), random.between(-1, 1)));
      };
      const std::string id = std::string(axis == 0 ? "x" : axis == 1 ? "y" : "z") + std::to_string(i);
      drawing.strokes.push_back(construction(id, static_cast<StrokeGroup>(axis), moved(a), moved(b)));
    }
  }
  return drawing;
}

PerspectiveDrawing without_lines_of(PerspectiveDrawing drawing, StrokeGroup group) {
  std::erase_if(drawing.strokes, [&](const PerspectiveStroke& stroke) { return stroke.group == group; });
  return drawing;
}

}  // namespace

TEST_CASE("Drawings without noise give the exact camera") {
  std::vector<View> views = three_point_views();
  views.push_back(off_centre_view());
  views.push_back(cropped_view());
  for (const View& view : views) {
    for (const PerspectiveSolid& solid : all_solids()) {
      const SolidDrawing truth = drawn(solid, view);
      const CameraEstimate estimate = estimated(truth.drawing);
      INFO(view.name << ", " << solid.name);
      CHECK(estimate.mode == PerspectiveMode::ThreePoint);
      CHECK(estimate.camera.focal_length == Approx(truth.camera.focal_length).epsilon(1e-9));
      CHECK((estimate.camera.principal_point - truth.camera.principal_point).norm() < 1e-9 * truth.camera.focal_length);
      CHECK((estimate.camera.rotation - truth.camera.rotation).norm() < 1e-9);
      CHECK(estimate.warnings.empty());
    }
  }
}

TEST_CASE("The number of vanishing points is found, exact or drawn by hand") {
  for (const View& view : all_views()) {
    const PerspectiveMode mode = view.name == level_view().name     ? PerspectiveMode::TwoPoint
                                 : view.name == frontal_view().name ? PerspectiveMode::OnePoint
                                                                    : PerspectiveMode::ThreePoint;
    for (const PerspectiveSolid& solid : some_solids()) {
      for (const double noise : {0.0, 0.5, 2.0}) {
        INFO(view.name << ", " << solid.name << ", noise " << noise);
        CHECK(estimated(noisy(solid, view, noise, 3).drawing).mode == mode);
      }
    }
  }
}

TEST_CASE("Two-point perspective takes the principal point from the sheet, or from who knows it") {
  View view = level_view();
  const SolidDrawing centred = drawn(l_block(), view);
  CHECK(estimated(centred.drawing).camera.focal_length == Approx(centred.camera.focal_length).epsilon(1e-8));

  view.principal_offset = Vec2(0.12, -0.2);
  SolidDrawing shifted = drawn(l_block(), view);
  const CameraEstimate guess = estimated(shifted.drawing);
  CHECK(guess.mode == PerspectiveMode::TwoPoint);
  // Across the horizon the lines say where the point is, along it they don't.
  CHECK(guess.camera.principal_point.y() == Approx(shifted.camera.principal_point.y()).margin(1e-6));
  CHECK(std::abs(guess.camera.principal_point.x() - shifted.camera.principal_point.x()) > 50);
  shifted.drawing.principal_point = shifted.camera.principal_point;
  const CameraEstimate stated = estimated(shifted.drawing);
  CHECK(stated.camera.focal_length == Approx(shifted.camera.focal_length).epsilon(1e-8));
  CHECK((stated.camera.rotation - shifted.camera.rotation).norm() < 1e-8);
}

TEST_CASE("In two-point perspective a stated field of view tells where the principal point is") {
  View view = level_view();
  view.principal_offset = Vec2(0.12, -0.2);
  SolidDrawing truth = drawn(l_block(), view);
  truth.drawing.field_of_view = view.field_of_view;
  const CameraEstimate stated = estimated(truth.drawing);
  CHECK(stated.mode == PerspectiveMode::TwoPoint);
  CHECK(stated.camera.focal_length == Approx(truth.camera.focal_length).epsilon(1e-3));
  CHECK((stated.camera.principal_point - truth.camera.principal_point).norm() < 1);
}

TEST_CASE("One-point perspective needs the field of view, and says so") {
  SolidDrawing truth = drawn(bottle(), frontal_view());
  const CameraEstimate assumed = estimated(truth.drawing);
  CHECK(assumed.focal_assumed);
  CHECK(codes_of(assumed.warnings) == std::vector<std::string>{"FOCAL_ASSUMED"});
  CHECK(assumed.camera.focal_length == Approx(500 / std::tan(25 * degree)));
  CHECK((assumed.camera.principal_point - truth.camera.principal_point).norm() < 1e-6);
  truth.drawing.field_of_view = frontal_view().field_of_view;
  const CameraEstimate stated = estimated(truth.drawing);
  CHECK(stated.warnings.empty());
  CHECK(stated.camera.focal_length == Approx(truth.camera.focal_length).epsilon(1e-12));
}

TEST_CASE("A stated field of view holds against noise") {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SolidDrawing truth = noisy(box(), three_point_views()[0], 5, seed);
    truth.drawing.field_of_view = three_point_views()[0].field_of_view;
    CHECK(estimated(truth.drawing).camera.focal_length == Approx(truth.camera.focal_length).epsilon(5e-3));
  }
}

TEST_CASE("Standard deviations of the camera are those of the errors") {
  std::vector<double> ratios;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const SolidDrawing truth = noisy(l_block(), three_point_views()[2], 1, seed);
    const CameraEstimate estimate = estimated(truth.drawing);
    ratios.push_back(std::abs(estimate.camera.focal_length - truth.camera.focal_length) / estimate.focal_deviation);
    CHECK(estimate.sigma > 0.35);
    CHECK(estimate.sigma < 1.8);
  }
  CHECK(median(ratios) > 0.4);  // 0.67 for a normal distribution
  CHECK(median(ratios) < 1.1);
  CHECK(std::ranges::count_if(ratios, [](double ratio) { return ratio > 3; }) <= 3);
}

TEST_CASE("A line of the wrong colour is left out and named") {
  for (const double noise : {0.0, 1.0, 3.0}) {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      SolidDrawing truth = noisy(l_block(), three_point_views()[1], noise, seed);
      auto& strokes = truth.drawing.strokes;
      auto wrong = std::ranges::find(strokes, "e03", &PerspectiveStroke::id);
      wrong->group = static_cast<StrokeGroup>((axis_of(wrong->group) + 1) % 3);
      const CameraEstimate estimate = estimated(truth.drawing);
      INFO("noise " << noise << ", seed " << seed);
      REQUIRE(codes_of(estimate.warnings) == std::vector<std::string>{"VP_OUTLIER"});
      CHECK(estimate.warnings[0].subjects[0].id == "e03");
      const auto line =
          std::ranges::find(estimate.lines, static_cast<Index>(wrong - strokes.begin()), &VanishingLine::stroke);
      CHECK(line->outlier);
      CHECK_FALSE(line->used);
      CHECK(line->residual > 2);
    }
  }
}

TEST_CASE("Noise alone leaves out nothing, and never more than a third of an axis is left out") {
  int left_out = 0;
  int lines = 0;
  for (const PerspectiveSolid& solid : some_solids()) {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      const CameraEstimate estimate = estimated(noisy(solid, three_point_views()[1], 4, seed).drawing);
      PerAxis<int> all, out;
      for (const VanishingLine& line : estimate.lines) {
        ++all[line.axis];
        out[line.axis] += line.outlier;
      }
      for (int axis = 0; axis < 3; ++axis) {
        CHECK(3 * out[axis] <= all[axis]);
        left_out += out[axis];
        lines += all[axis];
      }
    }
  }
  CHECK(left_out * 500 <= lines);
}

TEST_CASE("An obtuse triangle of vanishing points has no eye, whatever could be left out") {
  const PerAxis<Vec2> obtuse{Vec2(-1500, 300), Vec2(2500, 300), Vec2(500, 900)};
  for (const int count : {2, 3, 5, 9}) {
    for (const double noise : {0.0, 0.3}) {
      if (count == 2 && noise > 0) continue;  // nothing tells noise from shape
      const Findings errors = errors_of(lines_towards(obtuse, count, noise));
      INFO(count << " lines, noise " << noise);
      REQUIRE(codes_of(errors) == std::vector<std::string>{"EYE_NONE"});
      CHECK(errors[0].category == Category::Geometry);
      CHECK(errors[0].subjects.size() == static_cast<std::size_t>(count));
      for (const Subject& subject : errors[0].subjects) CHECK(subject.id[0] == 'z');
    }
  }
  const PerAxis<Vec2> acute{Vec2(-1500, 300), Vec2(2500, 300), Vec2(500, 4000)};
  CHECK(error_of(lines_towards(acute, 3, 0)) == "none");
}

TEST_CASE("Lines that don't converge at all have no perspective") {
  const PerAxis<Vec2> directions{Vec2(1e9, 4e8), Vec2(-1e9, 5e8), Vec2(1e7, -1e9)};
  CHECK(error_of(lines_towards(directions, 4, 0)) == "ALL_PARALLEL");
  CHECK(error_of(lines_towards(directions, 4, 0.3)) == "ALL_PARALLEL");
}

TEST_CASE("Two vanishing points give the third, one gives none") {
  const SolidDrawing truth = drawn(box(), three_point_views()[1]);
  const PerspectiveDrawing two = without_lines_of(truth.drawing, StrokeGroup::ParallelZ);
  const CameraEstimate estimate = estimated(two);
  CHECK(codes_of(estimate.warnings) == std::vector<std::string>{"VP_INSUFFICIENT"});
  // The true principal point is where it is thought to be.
  CHECK(estimate.camera.focal_length == Approx(truth.camera.focal_length).epsilon(1e-6));
  CHECK((estimate.camera.rotation - truth.camera.rotation).norm() < 1e-6);
  CHECK(error_of(without_lines_of(two, StrokeGroup::ParallelX)) == "VP_INSUFFICIENT");
  PerspectiveDrawing empty;
  empty.image_size = Vec2(1000, 750);
  CHECK(error_of(empty) == "VP_INSUFFICIENT");
}

TEST_CASE("An uncertain focal length names the axis that hardly converges") {
  View far = three_point_views()[0];
  far.field_of_view = 8 * degree;
  int told = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const SolidDrawing truth = noisy(box(), far, 4, seed);
    CameraOptions options;
    options.mode = PerspectiveMode::ThreePoint;
    const CameraEstimate estimate = estimated(truth.drawing, options);
    const bool weak = estimate.focal_deviation > 0.15 * estimate.camera.focal_length;
    const std::vector<std::string> codes = codes_of(estimate.warnings);
    CHECK(std::ranges::count(codes, "VP_WEAK") == (weak ? 1 : 0));
    told += weak;
  }
  CHECK(told >= 3);
}

TEST_CASE("Axes point up and to the right, and can be turned round") {
  const SolidDrawing truth = drawn(box(), three_point_views()[1]);
  CameraOptions options;
  options.turn_round = true;
  const Camera one = estimated(truth.drawing).camera;
  const Camera other = estimated(truth.drawing, options).camera;
  CHECK(one.rotation.determinant() == Approx(1));
  CHECK(other.rotation.determinant() == Approx(1));
  CHECK((one.rotation.col(2) - other.rotation.col(2)).norm() < 1e-12);
  CHECK((one.rotation.col(0) + other.rotation.col(0)).norm() < 1e-12);
  CHECK((one.rotation.col(1) + other.rotation.col(1)).norm() < 1e-12);
}

TEST_CASE("The camera doesn't depend on the order and direction of strokes, nor on the sheet's size and place") {
  for (const View& view : all_views()) {
    const SolidDrawing truth = noisy(camera_body(), view, 2, 4);
    const Camera camera = estimated(truth.drawing).camera;
    const Camera shuffled = estimated(shuffled_and_renamed(truth.drawing, 9)).camera;
    INFO(view.name);
    CHECK(camera.focal_length == shuffled.focal_length);
    CHECK(camera.principal_point == shuffled.principal_point);
    CHECK(camera.rotation == shuffled.rotation);
    const Camera enlarged = estimated(scaled_and_moved(truth.drawing, 3.7, Vec2(-500, 220))).camera;
    CHECK(enlarged.focal_length == Approx(3.7 * camera.focal_length).epsilon(1e-8));
    CHECK((enlarged.rotation - camera.rotation).norm() < 1e-8);
  }
}

TEST_CASE("A camera search can be stopped") {
  std::atomic<bool> stop = true;
  Progress progress({}, &stop);
  CHECK_THROWS_AS(estimate_camera(drawn(box(), three_point_views()[0]).drawing, CameraOptions{}, progress), Cancelled);
}
