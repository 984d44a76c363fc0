// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "croquis/attribute_surface/contour_network.h"
#include "croquis/base/error.h"
#include "croquis/geometry/bounds.h"
#include "support/random.h"

namespace croquis::test {
namespace {

Stroke stroke_of(const std::string& id, const std::vector<Vec2>& points, bool closed = false) {
  Stroke stroke;
  stroke.id = id;
  stroke.closed = closed;
  for (const Vec2& point : points) stroke.samples.push_back({point});
  return stroke;
}

std::vector<Vec2> arc(double from, double to, double radius, std::size_t count = 60) {
  std::vector<Vec2> points;
  for (std::size_t i = 0; i <= count; ++i) {
    const double t = from + (to - from) * static_cast<double>(i) / static_cast<double>(count);
    points.emplace_back(radius * std::cos(t), radius * std::sin(t));
  }
  return points;
}

Stroke circle(double radius) {
  std::vector<Vec2> points = arc(0, 2 * std::numbers::pi, radius);
  points.pop_back();
  return stroke_of("circle", points, true);
}

Drawing drawing_of(std::vector<Stroke> strokes) {
  Drawing drawing;
  drawing.strokes = std::move(strokes);
  return drawing;
}

ContourNetwork made(const Drawing& drawing, const ContourNetworkOptions& options = {}) {
  Progress progress;
  return network_of_contours(drawing, options, progress);
}

/// Places along all curves, from the control points alone.
std::vector<Vec3> places_of(const AttributeNetwork& network) {
  std::vector<Vec3> places;
  for (const AttributeCurve& curve : network.curves) {
    for (int i = 0; i <= 200; ++i) places.push_back(bezier_point(control_polygon(network, curve), i / 200.0));
  }
  return places;
}

/// To the chords between places; those from one curve to the next are left out.
double distance_to(const std::vector<Vec3>& places, const Vec3& point) {
  double least = 1e300;
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    if (i % 201 == 200) continue;
    const Vec3 along = places[i + 1] - places[i];
    const double t = std::clamp((point - places[i]).dot(along) / along.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (places[i] + t * along - point).norm());
  }
  return least;
}

Vec3 in_space(const DrawingPlane& plane, const Vec2& p) { return plane.origin + p.x() * plane.u + p.y() * plane.v; }

std::vector<std::string> curve_names(const AttributeNetwork& network) {
  std::vector<std::string> names;
  for (const AttributeCurve& curve : network.curves) names.push_back(curve.id);
  return names;
}

/// How many curve ends are at each node.
std::vector<int> valences(const AttributeNetwork& network) {
  std::vector<int> valences(network.nodes.size(), 0);
  for (const AttributeCurve& curve : network.curves) {
    ++valences[curve.from];
    ++valences[curve.to];
  }
  return valences;
}

TEST_CASE("a closed stroke without corners becomes four curves that go on smoothly into each other") {
  const AttributeNetwork network = made(drawing_of({circle(3)})).network;
  CHECK(curve_names(network) == std::vector<std::string>{"circle/1", "circle/2", "circle/3", "circle/4"});
  REQUIRE(network.nodes.size() == 4);
  for (std::size_t k = 0; k < 4; ++k) {
    const auto a = control_polygon(network, network.curves[k]),
               b = control_polygon(network, network.curves[(k + 1) % 4]);
    CHECK(network.curves[k].to == network.curves[(k + 1) % 4].from);
    CHECK(angle_between(a.back() - a[a.size() - 2], b[1] - b[0]) < 1e-6);
  }
  for (const Vec3& place : places_of(network)) CHECK(std::abs(place.norm() - 3) < 0.002 * 6 * std::sqrt(2));
}

TEST_CASE("a polygon becomes its sides, straight and with nodes at its corners") {
  const std::vector<Vec2> corners{{0, 0}, {4, 0}, {5, 2}, {1, 3}};
  const AttributeNetwork network = made(drawing_of({stroke_of("quad", corners, true)})).network;
  REQUIRE(network.curves.size() == 4);
  for (const AttributeCurve& curve : network.curves) CHECK(curve.control.empty());
  for (const Vec2& corner : corners) {
    const Vec3 place(corner.x(), corner.y(), 0);
    CHECK(std::ranges::count(network.nodes, place, &AttributeNode::point) == 1);
  }
}

TEST_CASE("strokes at random on random planes: curves lie on the plane and near the strokes") {
  Random random(17);
  for (int trial = 0; trial < 20; ++trial) {
    INFO("trial " << trial);
    Drawing drawing;
    const Eigen::Quaterniond turn =
        Eigen::Quaterniond(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1), random.between(-1, 1))
            .normalized();
    drawing.plane = {Vec3(random.between(-5, 5), 2, 3), turn * Vec3::UnitX(), turn * Vec3::UnitY()};
    for (int s = 0; s < 4; ++s) {
      const double phase = random.between(0, 6), wave = random.between(1, 4), closed = random.below(2);
      std::vector<Vec2> points;
      for (int i = 0; i < 200; ++i) {
        const double t = 2 * std::numbers::pi * i / 200 * (closed == 1 ? 1 : 0.7),
                     r = 1 + 0.2 * std::sin(3 * t + phase);
        points.emplace_back(wave * r * std::cos(t) + 10 * s, wave * r * std::sin(t));
      }
      drawing.strokes.push_back(stroke_of("s" + std::to_string(s), points, closed == 1));
    }
    const AttributeNetwork network = made(drawing).network;
    const auto box = *bounds_of(drawing);
    const double diagonal = (box[1] - box[0]).norm();
    const std::vector<Vec3> places = places_of(network);
    const Vec3 normal = drawing.plane.u.cross(drawing.plane.v);
    for (const Vec3& place : places) CHECK(std::abs(normal.dot(place - drawing.plane.origin)) < 1e-12 * diagonal);
    for (const Stroke& stroke : drawing.strokes) {
      for (const StrokeSample& sample : stroke.samples)
        CHECK(distance_to(places, in_space(drawing.plane, sample.position)) < 0.0025 * diagonal);
    }
    for (const AttributeCurve& curve : network.curves) {
      const auto control = control_polygon(network, curve);
      CHECK(control.front() == network.nodes[curve.from].point);
      CHECK(control.back() == network.nodes[curve.to].point);
    }
    CHECK(validate(network).empty());
  }
}

TEST_CASE("ends that nearly meet share a node, also the two of one stroke") {
  const double quarter = std::numbers::pi / 2;
  std::vector<Vec2> second = arc(quarter, 2 * quarter, 5);
  for (Vec2& point : second) point += Vec2(0.03, -0.02);
  const AttributeNetwork two = made(drawing_of({stroke_of("a", arc(0, quarter, 5)), stroke_of("b", second)})).network;
  CHECK(two.curves.size() == 2);
  CHECK(two.nodes.size() == 3);

  const AttributeNetwork one = made(drawing_of({stroke_of("a", arc(0, 3.999 * quarter, 5))})).network;
  CHECK(one.curves.size() == 4);
  CHECK(one.nodes.size() == 4);
  CHECK(std::ranges::all_of(valences(one), [](int valence) { return valence == 2; }));
}

TEST_CASE("an end that lies on another stroke cuts it there, ends apart do not") {
  for (const double gap : {0.0, 0.04, 1.0}) {
    INFO("gap " << gap);
    const Drawing drawing = drawing_of({stroke_of("bar", {{-5, 0}, {5, 0}}), stroke_of("post", {{1, gap}, {1, 4}})});
    const AttributeNetwork network = made(drawing).network;
    const bool meets = gap < 0.5;
    CHECK(network.curves.size() == (meets ? 3 : 2));
    CHECK(network.nodes.size() == 4);
    CHECK(std::ranges::count(valences(network), 3) == (meets ? 1 : 0));
    const bool has_node = std::ranges::count(network.nodes, Vec3(1, 0, 0), &AttributeNode::point) == 1;
    CHECK(has_node == meets);
  }
}

TEST_CASE("two ends at one place of a stroke cut it once") {
  const Drawing drawing = drawing_of({stroke_of("bar", {{-5, 0}, {5, 0}}), stroke_of("up", {{1, 0}, {1, 4}}),
                                      stroke_of("down", {{1.02, -0.01}, {1, -4}})});
  const AttributeNetwork network = made(drawing).network;
  CHECK(network.curves.size() == 4);
  CHECK(std::ranges::count(valences(network), 4) == 1);
}

TEST_CASE("an end at a corner of another stroke shares its node") {
  const Drawing drawing =
      drawing_of({stroke_of("roof", {{-3, 0}, {0, 2}, {3, 0}}), stroke_of("mast", {{0.02, 2.03}, {0, 5}})});
  const AttributeNetwork network = made(drawing).network;
  CHECK(network.curves.size() == 3);
  CHECK(network.nodes.size() == 4);
  CHECK(std::ranges::count(network.nodes, Vec3(0, 2, 0), &AttributeNode::point) == 1);
}

TEST_CASE("strokes that are too short are left out by name") {
  const Drawing drawing = drawing_of({circle(3), stroke_of("dot", {{9, 9}}), stroke_of("speck", {{1, 1}, {1, 1.001}})});
  const ContourNetwork network = made(drawing);
  CHECK(network.network.curves.size() == 4);
  REQUIRE(network.warnings.size() == 2);
  CHECK(network.warnings[0].code == "STROKE_LEFT_OUT");
  CHECK(network.warnings[0].subjects.at(0).id == "dot");
  CHECK(network.warnings[1].subjects.at(0).id == "speck");
}

TEST_CASE("a drawing of nothing but dots is refused with all of them named") {
  try {
    made(drawing_of({stroke_of("a", {{1, 1}}), stroke_of("b", {{2, 1}})}));
    FAIL("not refused");
  } catch (const Error& error) {
    CHECK(error.findings().size() == 3);
    CHECK(error.findings()[0].code == "E_NO_STROKES");
  }
}

TEST_CASE("curves don't depend on the drawing's size, and hardly on where it lies") {
  const Drawing drawing = drawing_of({circle(3), stroke_of("bar", {{-3, 0}, {5, 0}})});
  Drawing large = drawing;
  for (Stroke& stroke : large.strokes) {
    for (StrokeSample& sample : stroke.samples) sample.position *= 1024;
  }
  const AttributeNetwork small_network = made(drawing).network, large_network = made(large).network;
  CHECK(curve_names(small_network) == curve_names(large_network));
  const std::vector<Vec3> a = places_of(small_network), b = places_of(large_network);
  REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) CHECK((1024 * a[i] - b[i]).norm() < 1e-9 * 1024);
}

}  // namespace
}  // namespace croquis::test
