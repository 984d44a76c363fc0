// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "croquis/perspective/edge_continuity.h"

using namespace croquis;

namespace {

/// Two curves that meet in the origin: a along -x, b in the direction given.
CurveNetwork two_curves(const Vec3& b_direction, bool a_straight, bool b_straight) {
  CurveNetwork network;
  network.vertices = {{-3, 0, 0}, {0, 0, 0}, 3 * b_direction};
  if (!b_straight) network.vertices[2] += Vec3(0, 0, b_direction.y() == 0 ? 1 : 0);
  RationalCubic a = straight_cubic(network.vertices[0], network.vertices[1]);
  RationalCubic b = straight_cubic(network.vertices[1], network.vertices[2]);
  if (!a_straight) a.points[1].z() = 0.5;
  b.points[1] = b_direction;
  network.curves = {{"a", 0, 1, {a}, a_straight}, {"b", 1, 2, {b}, b_straight}};
  return network;
}

double turn_of(const CurveNetwork& network) {
  return angle_between(-network.curves[0].direction_from_end(), network.curves[1].direction_from_start());
}

Vec3 inclined(double angle) { return {std::cos(angle), 0, std::sin(angle)}; }

}  // namespace

TEST_CASE("curves that nearly go on into each other do so exactly") {
  CurveNetwork network = two_curves(inclined(0.2), true, false);
  const double length = (network.curves[1].pieces[0].points[1]).norm();
  const auto joints = join_smoothly(network, nullptr);
  REQUIRE(joints.size() == 1);
  CHECK(joints[0].angle == Approx(0.2));
  CHECK(turn_of(network) < 1e-12);
  CHECK(network.curves[0].direction_from_end() == Vec3(-1, 0, 0));  // the line stays
  CHECK((network.curves[1].pieces[0].points[1]).norm() == Approx(length));
  CHECK(network.curves[1].pieces[0].points[1].y() == 0);  // in its plane to the bit

  network = two_curves(inclined(0.2), false, false);
  CHECK(join_smoothly(network, nullptr).size() == 1);
  CHECK(turn_of(network) < 1e-9);
}

TEST_CASE("corners stay corners") {
  CurveNetwork network = two_curves(inclined(0.4), true, false);
  CHECK(join_smoothly(network, nullptr).empty());
  network = two_curves(inclined(0.2), true, false);
  CurveContinuityOptions options;
  options.corners = {{1, false}};
  CHECK(join_smoothly(network, nullptr, options).empty());
  CHECK(turn_of(network) == Approx(0.2));
  network = two_curves(inclined(0.2), true, true);
  CHECK(join_smoothly(network, nullptr).empty());  // lines can't turn
}

TEST_CASE("curves of different planes take the axis that both contain") {
  CurveNetwork network = two_curves(inclined(0.1), false, false);  // both in y = 0
  std::array<Vec3, 4>& a = network.curves[0].pieces[0].points;     // now in z = 0
  a[1] = {-2, 0.5, 0};
  a[2] = {-1, 0.1, 0};
  REQUIRE(join_smoothly(network, nullptr).size() == 1);
  CHECK(network.curves[0].direction_from_end() == Vec3(-1, 0, 0));
  CHECK(network.curves[1].direction_from_start() == Vec3(1, 0, 0));
}

TEST_CASE("the weight of a moved handle follows its depth") {
  CurveNetwork network = two_curves(inclined(0.2), true, false);
  Camera camera;
  camera.eye = {0, 0, -5};
  const double before = camera.depth(network.curves[1].pieces[0].points[1]);
  join_smoothly(network, &camera);
  const RationalCubic& b = network.curves[1].pieces[0];
  CHECK(b.weights[1] == Approx(before / camera.depth(b.points[1])));
}
