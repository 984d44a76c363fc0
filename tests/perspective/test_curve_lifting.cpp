// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "croquis/perspective/curve_lifting.h"
#include "perspective/network_truth.h"
#include "support/perspective/solids.h"
#include "support/perspective/views.h"

using namespace croquis;
using namespace croquis::test;

namespace {

/// Nearest distance of a place from a drawn path.
double distance_to_path(const Vec2& place, const std::vector<PictureCubic>& path) {
  const auto at = [](const PictureCubic& b, double t) {
    const double s = 1 - t;
    return Vec2(s * s * s * b[0] + 3 * s * s * t * b[1] + 3 * s * t * t * b[2] + t * t * t * b[3]);
  };
  double nearest = 1e300;
  for (const PictureCubic& piece : path) {
    double best = 0;
    double least = 1e300;
    for (int i = 0; i <= 200; ++i) {
      const double distance = (at(piece, i / 200.0) - place).norm();
      if (distance < least) {
        least = distance;
        best = i / 200.0;
      }
    }
    double step = 1 / 200.0;
    for (int round = 0; round < 60; ++round, step /= 2) {
      for (const double t : {best - step, best + step}) {
        const double inside = std::clamp(t, 0.0, 1.0);
        const double distance = (at(piece, inside) - place).norm();
        if (distance < least) {
          least = distance;
          best = inside;
        }
      }
    }
    nearest = std::min(nearest, least);
  }
  return nearest;
}

/// How far off the drawn paths curves are seen.
double greatest_distance(const PerspectiveDrawing& drawing, const ReconstructedNetwork& network,
                         const std::function<std::vector<RationalCubic>(std::size_t)>& pieces_of) {
  double greatest = 0;
  const LiftedCurves& curves = network.curves;
  for (std::size_t i = 0; i < curves.network.curves.size(); ++i) {
    const PerspectiveStroke& stroke = drawing.strokes[curves.stroke[i]];
    if (stroke.straight) continue;
    for (const RationalCubic& piece : pieces_of(i)) {
      for (int j = 0; j <= 100; ++j) {
        const Vec2 seen = network.coordinates.camera.project(piece.at(j / 100.0));
        greatest = std::max(greatest, distance_to_path(seen, stroke.pieces));
      }
    }
  }
  return greatest;
}

std::vector<PerspectiveSolid> round_solids() {
  return {rounded_block(), d_block(), cylinder(), soap(), bottle(), camera_body(), camera_ring(), ball()};
}

SolidDrawing clean(const PerspectiveSolid& solid, const View& view) {
  SolidDrawingOptions options;
  options.vertex_ids = false;
  SolidDrawing truth = drawn(solid, view, options);
  if (view.name == frontal_view().name) truth.drawing.field_of_view = view.field_of_view;
  return truth;
}

PerspectiveStroke edge(const std::string& id, StrokeGroup group, std::vector<PictureCubic> pieces) {
  PerspectiveStroke stroke;
  stroke.id = id;
  stroke.group = group;
  stroke.pieces = std::move(pieces);
  return stroke;
}

/// A camera at height 2 over the plane z = 0, looking horizontally along y; the horizon is at y = 0 in the picture.
Camera level_camera() {
  Camera camera;
  camera.focal_length = 1000;
  camera.image_size = Vec2(1000, 750);
  camera.eye = Vec3(0, 0, 2);
  camera.rotation << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  return camera;
}

/// The drawing of one stroke in the plane z = 0, its ends being where they are seen.
LiftedCurves lifted_alone(const PerspectiveStroke& stroke) {
  PerspectiveDrawing drawing;
  drawing.origin = Vec2(-500, -375);
  drawing.image_size = Vec2(1000, 750);
  drawing.strokes = {stroke};
  const DrawingVertices vertices = find_drawing_vertices(drawing);
  VertexCoordinates coordinates;
  coordinates.camera = level_camera();
  coordinates.groups = {stroke.group};
  for (const DrawingVertex& vertex : vertices.vertices) {
    const Vec3 ray = coordinates.camera.ray(vertex.position);
    Vec3 position = coordinates.camera.eye - 2 / ray.z() * ray;
    position.z() = 0;
    coordinates.positions.push_back(position);
    coordinates.in_front.push_back(true);
  }
  return lift_curves(drawing, vertices, coordinates, {});
}

}  // namespace

TEST_CASE("Lifted curves are seen exactly where they were drawn, and are the true ones") {
  for (const View& view : all_views()) {
    for (const PerspectiveSolid& solid : round_solids()) {
      const SolidDrawing truth = clean(solid, view);
      const ReconstructedNetwork network = reconstructed(truth.drawing);
      INFO(view.name << ", " << solid.name);
      REQUIRE(network.curves.network.curves.size() == solid.network.curves.size());
      CHECK(greatest_distance(truth.drawing, network,
                              [&](std::size_t i) { return network.curves.network.curves[i].pieces; }) < 1e-6);
      for (const NetworkCurve& curve : network.curves.network.curves) {
        const auto found = std::ranges::find(truth.network.curves, curve.id, &NetworkCurve::id);
        const Vec3 middle = curve.pieces[curve.pieces.size() / 2].at(curve.pieces.size() % 2 == 0 ? 0 : 0.5);
        double nearest = 1e300;
        for (const RationalCubic& piece : found->pieces) {
          for (int i = 0; i <= 20000; ++i) nearest = std::min(nearest, (piece.at(i / 20000.0) - middle).norm());
        }
        CHECK(nearest < 1e-3 * true_diagonal(truth));
      }
    }
  }
}

TEST_CASE("Taking control points as they are isn't seen where it was drawn") {
  for (const View& view : {three_point_views()[1], three_point_views()[2]}) {
    const SolidDrawing truth = clean(bottle(), view);
    const ReconstructedNetwork network = reconstructed(truth.drawing);
    const double distance = greatest_distance(truth.drawing, network, [&](std::size_t i) {
      std::vector<RationalCubic> pieces = network.curves.network.curves[i].pieces;
      for (RationalCubic& piece : pieces) piece.weights = {1, 1, 1, 1};
      return pieces;
    });
    CHECK(distance > 0.1);
  }
}

TEST_CASE("Curves end at their vertices and stay in their planes bit by bit, drawn by hand too") {
  for (const double noise : {0.0, 4.0}) {
    for (const PerspectiveSolid& solid : round_solids()) {
      SolidDrawingOptions options;
      options.noise = noise;
      const SolidDrawing truth = drawn(solid, three_point_views()[1], options);
      const ReconstructedNetwork network = reconstructed(truth.drawing);
      const CurveNetwork& curves = network.curves.network;
      INFO(solid.name << ", noise " << noise);
      for (std::size_t i = 0; i < curves.curves.size(); ++i) {
        const NetworkCurve& curve = curves.curves[i];
        for (const std::vector<RationalCubic>& pieces : {curve.pieces, network.fitted[i].pieces}) {
          CHECK(pieces.front().points[0] == curves.vertices[curve.start]);
          CHECK(pieces.back().points[3] == curves.vertices[curve.end]);
          for (std::size_t p = 1; p < pieces.size(); ++p) CHECK(pieces[p].points[0] == pieces[p - 1].points[3]);
          const StrokeGroup group = network.coordinates.groups[network.curves.stroke[i]];
          for (const RationalCubic& piece : pieces) {
            for (int k = 0; k < 3; ++k) {
              if ((k == axis_of(group)) == is_parallel(group)) continue;
              for (const Vec3& point : piece.points) CHECK(point[k] == curves.vertices[curve.start][k]);
            }
            for (const double weight : piece.weights) CHECK(weight > 0);
            CHECK(piece.weights[0] == piece.weights[3]);
          }
        }
      }
    }
  }
}

TEST_CASE("Polynomial stand-ins are near, with the same directions at the ends") {
  for (const View& view : three_point_views()) {
    for (const PerspectiveSolid& solid : round_solids()) {
      const SolidDrawing truth = clean(solid, view);
      const ReconstructedNetwork network = reconstructed(truth.drawing);
      INFO(view.name << ", " << solid.name);
      for (std::size_t i = 0; i < network.curves.network.curves.size(); ++i) {
        const NetworkCurve& curve = network.curves.network.curves[i];
        const FittedCurve& fitted = network.fitted[i];
        const bool near = fitted.distance <= 0.5 || fitted.error <= 1e-3 * true_diagonal(truth);
        CHECK((near || fitted.pieces.size() == 2 * curve.pieces.size()));
        NetworkCurve stand_in = curve;
        stand_in.pieces = fitted.pieces;
        CHECK(angle_between(stand_in.direction_from_start(), curve.direction_from_start()) < 1e-9);
        CHECK(angle_between(stand_in.direction_from_end(), curve.direction_from_end()) < 1e-9);
        for (std::size_t p = 1; p < fitted.pieces.size(); ++p) {
          if (curve.pieces.size() > 1) continue;  // joints of the stroke itself are as it was drawn
          const Vec3 before = fitted.pieces[p - 1].derivative(1);
          CHECK(angle_between(before, fitted.pieces[p].derivative(0)) < 1e-9);
        }
      }
    }
  }
}

TEST_CASE("A tighter limit takes two cubics, which are nearer") {
  const SolidDrawing truth = clean(bottle(), three_point_views()[2]);
  NetworkReconstructionOptions tight;
  tight.curves.fit_distance = 1e-3;
  tight.curves.fit_error = 1e-6;
  const ReconstructedNetwork one = reconstructed(truth.drawing);
  const ReconstructedNetwork two = reconstructed(truth.drawing, tight);
  for (std::size_t i = 0; i < one.fitted.size(); ++i) {
    if (one.curves.network.curves[i].straight) continue;
    CHECK(two.fitted[i].pieces.size() == 2);
    if (one.fitted[i].pieces.size() == 1) {
      CHECK(two.fitted[i].distance < 0.5 * one.fitted[i].distance);
    }
  }
}

TEST_CASE("Corners of a path become vertices, smooth joints don't") {
  const Vec2 a(-200, 150), b(0, 100), c(200, 150), d(300, 300);
  const auto line = [](const Vec2& p, const Vec2& q) { return PictureCubic{p, p + (q - p) / 3, q - (q - p) / 3, q}; };
  const PictureCubic round{c, c + (c - b) / 3, d + Vec2(0, -40), d};
  const LiftedCurves lifted = lifted_alone(edge("path", StrokeGroup::NormalZ, {line(a, b), line(b, c), round}));
  REQUIRE(lifted.network.curves.size() == 2);
  CHECK(lifted.network.vertices.size() == 3);
  CHECK(lifted.network.curves[0].id == "path/1");
  CHECK(lifted.network.curves[0].straight);
  CHECK(lifted.network.curves[1].id == "path/2");
  CHECK_FALSE(lifted.network.curves[1].straight);
  CHECK(lifted.network.curves[1].pieces.size() == 2);
  CHECK(lifted.network.curves[0].end == lifted.network.curves[1].start);
  for (const Vec3& vertex : lifted.network.vertices) CHECK(vertex.z() == 0);
}

TEST_CASE("Control points beyond the horizon split a curve, a curve beyond it stays in the picture") {
  // The curve stays below the horizon, its handles don't.
  const PictureCubic handles{Vec2(-300, 60), Vec2(-100, -15), Vec2(100, -15), Vec2(300, 60)};
  const LiftedCurves split = lifted_alone(edge("arc", StrokeGroup::NormalZ, {handles}));
  REQUIRE(split.network.curves.size() == 1);
  CHECK(split.warnings.empty());
  CHECK(split.network.curves[0].pieces.size() > 1);
  for (const RationalCubic& piece : split.network.curves[0].pieces) {
    for (int j = 0; j <= 100; ++j) {
      const Vec3 point = piece.at(j / 100.0);
      CHECK(distance_to_path(level_camera().project(point), {handles}) < 1e-6);
      CHECK(point.z() == Approx(0).margin(1e-9));
    }
  }
  const PictureCubic beyond{Vec2(-300, 60), Vec2(-100, -90), Vec2(100, -90), Vec2(300, 60)};
  const LiftedCurves flat = lifted_alone(edge("arc", StrokeGroup::NormalZ, {beyond}));
  CHECK(codes_of(flat.warnings) == std::vector<std::string>{"CURVE_BEHIND_HORIZON"});
  CHECK(flat.warnings[0].subjects[0].id == "arc");
  CHECK(flat.network.curves.empty());
  CHECK(flat.flat == std::vector<Index>{0});
}
