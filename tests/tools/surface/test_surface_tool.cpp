// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <memory>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "croquis/attribute_surface/attribute_surface.h"
#include "croquis/base/error.h"
#include "croquis/base/progress.h"
#include "croquis/tools/all_steps.h"
#include "croquis/tools/recording/recording.h"
#include "tools/surface/surface_hand.h"

namespace croquis {
namespace {

using test::SurfaceHand;

/// Three corners on the ground.
const Vec3 left(-1, 0, 1), right(3, 0, 1), far(1, 0, -2);

std::vector<Vec3> arched(const Vec3& from, const Vec3& to, const Vec3& lift) {
  std::vector<Vec3> places;
  for (int i = 0; i <= 40; ++i) {
    const double t = i / 40.0;
    places.push_back((1 - t) * from + t * to + 4 * t * (1 - t) * lift);
  }
  return places;
}

/// Draws a triangle with one bent side.
void draw_triangle(SurfaceHand& hand) {
  REQUIRE(hand.stroke_through({left, right}) == Verdict::Commit);
  REQUIRE(hand.stroke_through({right, far}) == Verdict::Commit);
  REQUIRE(hand.stroke_through(arched(far, left, {-0.4, 0, -0.3})) == Verdict::Commit);
}

void fill_triangle(SurfaceHand& hand) {
  draw_triangle(hand);
  hand.tool.set_mode(SurfaceMode::Patch);
  REQUIRE(hand.click(hand.pixel((left + right + far) / 3)) == Verdict::Commit);
  hand.look();
}

TEST_CASE("three strokes drawn by hand make a loop with shared nodes on the ground, each one step back") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SurfaceHand hand;
    hand.random = test::Random(seed);
    INFO("seed " << seed);
    CHECK(hand.tool.node() == 0);
    draw_triangle(hand);
    REQUIRE(hand.network().curves.size() == 3);
    CHECK(hand.network().nodes.size() == 3);
    CHECK(validate(hand.network()).empty());
    CHECK(hand.tool.operation_node() != 0);
    CHECK(hand.network().curves[0].control.empty());
    CHECK(hand.network().curves[2].control.size() >= 3);
    for (const AttributeNode& node : hand.network().nodes) CHECK(std::abs(node.point.y()) < 1e-9);
    CHECK(hand.session.undo_labels() == std::vector<std::string>{"Draw curve c1", "Draw curve c2", "Draw curve c3"});
    hand.session.undo();
    CHECK(hand.network().curves.size() == 2);
    hand.session.undo();
    hand.session.undo();
    CHECK(hand.tool.node() == 0);
  }
}

TEST_CASE("a click in the loop fills it, a second one selects the patch") {
  SurfaceHand hand;
  draw_triangle(hand);
  hand.tool.set_mode(SurfaceMode::Patch);
  const Vec2 middle = hand.pixel((left + right + far) / 3);
  CHECK(hand.tool.hover(middle, hand.camera.frame()));
  REQUIRE(hand.tool.preview().loop);
  CHECK(hand.tool.preview().loop->loop.sides.size() == 3);
  CHECK(hand.click(middle) == Verdict::Commit);
  REQUIRE(hand.network().faces.size() == 1);
  hand.click(middle);
  CHECK(hand.network().faces.size() == 1);
  CHECK(hand.tool.selected().faces == std::vector<std::string>{"f1"});
  CHECK(hand.click({5, 5}) == Verdict::Revert);
  CHECK(hand.tool.notes().size() == 1);
}

TEST_CASE("selected curves fill a loop in any order; what isn't closed is named") {
  SurfaceHand hand;
  draw_triangle(hand);
  hand.tool.set_mode(SurfaceMode::Select);
  hand.drag({20, 20}, {780, 580});
  CHECK(hand.tool.selected().curves.size() == 3);
  CHECK(hand.tool.selected().nodes.size() == 3);
  CHECK(hand.tool.take(recorded::SurfacePatch{{"c1", "c3"}}) == Verdict::Revert);
  REQUIRE(hand.tool.notes().size() == 1);
  CHECK(hand.tool.notes()[0].code == "E_OPEN_LOOP");
  CHECK(hand.tool.take(recorded::SurfacePatch{hand.tool.selected().curves}) == Verdict::Commit);
  CHECK(hand.network().faces.size() == 1);
}

TEST_CASE("a stroke that ends on a curve splits it there") {
  SurfaceHand hand;
  draw_triangle(hand);
  REQUIRE(hand.stroke_through({(left + right) / 2, far}) == Verdict::Commit);
  CHECK(hand.network().curves.size() == 5);
  CHECK(hand.network().nodes.size() == 4);
  CHECK(validate(hand.network()).empty());
  const double miss = (hand.network().nodes[3].point - (left + right) / 2).norm();
  CHECK(miss < 0.3);
}

TEST_CASE("a stroke between two nodes in space lies in a plane through both") {
  SurfaceHand hand;
  draw_triangle(hand);
  hand.tool.take(recorded::SurfaceDrag{{{"n3"}, {}, {}, {}}, {}, {0, 2, 0}, {}});
  const Vec3 high = hand.node_place("n3"), low = hand.node_place("n1");
  REQUIRE(hand.stroke({hand.pixel(low), hand.pixel((low + high) / 2) + Vec2(40, 20), hand.pixel(high)}) ==
          Verdict::Commit);
  const AttributeCurve& drawn = hand.network().curves[3];
  CHECK(drawn.from == 0);
  CHECK(drawn.to == 2);
  const Vec3 chord = high - low;
  const Vec3 across = hand.camera.frame().to_eye((low + high) / 2);
  const Vec3 normal = (across - chord * chord.dot(across) / chord.squaredNorm()).normalized();
  for (const Vec3& place : control_polygon(hand.network(), drawn)) CHECK(std::abs((place - low).dot(normal)) < 1e-9);
}

TEST_CASE("a curve is drawn across the view where the ground is seen from its edge, and on the plane chosen") {
  SurfaceHand hand;
  hand.camera = {};
  hand.camera.eye = {0, 0.2, 5};
  hand.stroke({{200, 300}, {600, 250}});
  for (const AttributeNode& node : hand.network().nodes) CHECK(std::abs(node.point.z()) < 0.05);
  hand.tool.settings().chosen = {{0, 0, 1}, {0.3, 0, 1}};
  hand.tool.settings().plane = SurfacePlane::Chosen;
  hand.stroke({{200, 500}, {600, 450}});
  const Vec3 normal = Vec3(0.3, 0, 1).normalized();
  CHECK(std::abs((hand.network().nodes[2].point - Vec3(0, 0, 1)).dot(normal)) < 1e-9);
  CHECK(std::abs((hand.network().nodes[3].point - Vec3(0, 0, 1)).dot(normal)) < 1e-9);
}

TEST_CASE("dragged nodes take their curves along, join others, and Escape gives the drag up") {
  SurfaceHand hand;
  draw_triangle(hand);
  hand.tool.set_mode(SurfaceMode::Select);
  const std::string before = hand.text();
  const Vec2 start = hand.pixel(hand.node_place("n2"));
  hand.step(PenStep::Kind::Begin, start);
  hand.step(PenStep::Kind::Sample, start + Vec2(40, -30));
  CHECK(hand.text() != before);  // live
  CHECK(hand.tool.active());
  CHECK(hand.step(PenStep::Kind::Cancel, start) == Verdict::Revert);
  CHECK(hand.text() == before);
  CHECK(hand.drag(start, start + Vec2(40, -30)) == Verdict::Commit);
  CHECK((hand.pixel(hand.node_place("n2")) - start - Vec2(40, -30)).norm() < 1);
  CHECK(hand.session.undo_labels().back() == "Move node n2");
  hand.session.undo();
  CHECK(hand.text() == before);
  CHECK(hand.drag(start, hand.pixel(hand.node_place("n1")) + Vec2(5, -4)) == Verdict::Commit);
  CHECK(hand.network().nodes.size() == 2);
  CHECK(hand.network().curves.size() == 2);  // the straight one between them is gone
  CHECK(validate(hand.network()).empty());
}

TEST_CASE("a press and a release far away are a drag, too") {
  SurfaceHand hand;
  draw_triangle(hand);
  hand.tool.set_mode(SurfaceMode::Select);
  const Vec2 start = hand.pixel(hand.node_place("n2"));
  hand.step(PenStep::Kind::Begin, start);
  CHECK(hand.step(PenStep::Kind::End, start + Vec2(60, 10)) == Verdict::Commit);
  CHECK((hand.pixel(hand.node_place("n2")) - start - Vec2(60, 10)).norm() < 1);
}

TEST_CASE("handles of a selected line bend it") {
  SurfaceHand hand;
  draw_triangle(hand);
  hand.tool.set_mode(SurfaceMode::Select);
  hand.click(hand.pixel((hand.node_place("n1") + hand.node_place("n2")) / 2));
  REQUIRE(hand.tool.selected().curves == std::vector<std::string>{"c1"});
  REQUIRE(handles_of(hand.tool).size() == 2);
  const Vec3 handle = control_handles(hand.network(), hand.network().curves[0])[1];
  CHECK(hand.drag(hand.pixel(handle), hand.pixel(handle) + Vec2(0, -50)) == Verdict::Commit);
  REQUIRE(hand.network().curves[0].control.size() == 4);
  CHECK((hand.pixel(hand.network().curves[0].control[1]) - hand.pixel(handle) - Vec2(0, -50)).norm() < 1);
  CHECK(hand.tool.take(other_join(hand.network(), hand.tool.selected().curves)) == Verdict::Commit);
  CHECK(hand.network().curves[0].join == CurveJoin::Smooth);
  CHECK(hand.tool.take(recorded::SurfaceDelete{hand.tool.selected()}) == Verdict::Commit);
  CHECK(hand.network().curves.size() == 2);
}

TEST_CASE("something else that changes the session ends a drag without a step") {
  SurfaceHand hand;
  draw_triangle(hand);
  hand.tool.set_mode(SurfaceMode::Select);
  const Vec2 start = hand.pixel(hand.node_place("n2"));
  hand.step(PenStep::Kind::Begin, start);
  hand.step(PenStep::Kind::Sample, start + Vec2(40, -30));
  hand.session.undo();
  const std::string now = hand.text();
  CHECK(hand.step(PenStep::Kind::Sample, start + Vec2(50, -30)) == Verdict::Revert);
  CHECK(hand.text() == now);
  CHECK_FALSE(hand.tool.active());
}

TEST_CASE("a press on a patch and a drag pull a point that follows the pointer, and its ring its radius") {
  SurfaceHand hand;
  fill_triangle(hand);
  const std::string before = hand.text();
  hand.tool.set_mode(SurfaceMode::Point);
  const Vec2 press = hand.pixel((left + right + far) / 3);
  CHECK(hand.drag(press, press + Vec2(0, -60)) == Verdict::Commit);
  REQUIRE(hand.network().points.size() == 1);
  const PointAttribute point = hand.network().points[0];
  REQUIRE(point.fan);
  CHECK((hand.pixel(point.point) - press - Vec2(0, -60)).norm() < 3);
  CHECK(point.point.y() > 0.5);  // along the normal of what lies on the ground
  CHECK(std::abs(point.point.x() - 1) < 0.3);
  CHECK(hand.tool.selected().points == std::vector<std::string>{"p1"});
  hand.look();
  const std::vector<Vec3> ring = ring_of(hand.tool);
  REQUIRE(ring.size() > 20);
  const Vec2 on_ring = hand.pixel(ring[3]);
  const Vec2 centre = hand.pixel(point.point);
  CHECK(hand.drag(on_ring, centre + 1.5 * (on_ring - centre)) == Verdict::Commit);
  CHECK(hand.network().points[0].radius);
  CHECK(hand.drag(hand.pixel(point.point), hand.pixel(point.point) + Vec2(2, 40)) == Verdict::Commit);
  CHECK(hand.network().points[0].point.y() < point.point.y() - 0.3);
  CHECK(hand.network().points[0].fan == point.fan);
  hand.tool.take(recorded::SurfaceDelete{hand.tool.selected()});
  CHECK(hand.text() == before);
}

TEST_CASE("the surface meets the point that was pulled") {
  SurfaceHand hand;
  fill_triangle(hand);
  hand.tool.set_mode(SurfaceMode::Point);
  const Vec2 press = hand.pixel((left + right + far) / 3);
  hand.drag(press, press + Vec2(3, -50));
  hand.look();
  hand.tool.leave();
  hand.tool.set_mode(SurfaceMode::Select);
  hand.tool.select({});
  Progress progress;
  const AttributeSurface surface = make_attribute_surface(hand.network(), progress);
  const FaceSurface& patch = *surface.faces[0].surface;
  const Vec3 met = patch.at(place_in(patch.domain(), *hand.network().points[0].fan));
  CHECK((met - hand.network().points[0].point).norm() < 1e-9);
}

TEST_CASE("a stroke on a patch becomes an inner curve, one across it divides it") {
  SurfaceHand hand;
  fill_triangle(hand);
  hand.tool.set_mode(SurfaceMode::Draw);
  REQUIRE(hand.stroke_through(arched({0.4, 0, 0.4}, {1.6, 0, 0.4}, {0, 0, -0.3})) == Verdict::Commit);
  REQUIRE(hand.network().faces[0].inner.size() == 1);
  const AttributeCurve& inner = hand.network().curves[hand.network().faces[0].inner[0].curve];
  CHECK(inner.from == no_index);
  for (const Vec3& place : inner.control) CHECK(std::abs(place.y()) < 0.1);
  hand.look();
  REQUIRE(hand.stroke_through({(left + right) / 2 + Vec3(0.9, 0, 0), far}) == Verdict::Commit);
  CHECK(hand.network().faces.size() == 2);
  CHECK(validate(hand.network()).empty());
  CHECK(hand.session.undo_labels().back() == "Split patch f1");
}

TEST_CASE("with Ctrl a stroke over a patch goes past it") {
  SurfaceHand hand;
  fill_triangle(hand);
  hand.tool.set_mode(SurfaceMode::Draw);
  hand.held.ctrl = true;
  REQUIRE(hand.stroke_through({{0.4, 0, 0.4}, {1.6, 0, 0.4}}) == Verdict::Commit);
  CHECK(hand.network().faces[0].inner.empty());
  CHECK(hand.network().nodes.size() == 5);
}

TEST_CASE("the handle of a slope turns the surface's normal about the curve") {
  SurfaceHand hand;
  fill_triangle(hand);
  hand.tool.set_mode(SurfaceMode::Select);
  hand.tool.select({{}, {"c1"}, {}, {}});
  REQUIRE(slopes_of(hand.tool).size() == 1);
  const SlopeTip tip = slopes_of(hand.tool)[0];
  CHECK(tip.automatic);
  CHECK(hand.drag(hand.pixel(tip.tip), hand.pixel(tip.tip) + Vec2(0, -40)) == Verdict::Commit);
  REQUIRE(hand.network().slopes.size() == 1);
  const SlopeAttribute& slope = hand.network().slopes[0];
  CHECK(slope.magnitude > 0);
  CHECK(std::abs(slope.normals[0].normalized().dot((right - left).normalized())) < 0.05);
  hand.look();
  const SlopeTip now = slopes_of(hand.tool)[0];
  CHECK_FALSE(now.automatic);
  CHECK((hand.pixel(now.tip) - hand.pixel(tip.tip) - Vec2(0, -40)).norm() < 4);
  CHECK(hand.tool.take(recorded::SurfaceSlope{now.side, {}}) == Verdict::Commit);
  CHECK(hand.network().slopes.empty());
}

TEST_CASE("with a symmetry plane both sides are drawn and moved") {
  SurfaceHand hand;
  CHECK(hand.tool.take(recorded::SurfaceSymmetry{SymmetryPlane{{1, 0, 0}, {1, 0, 0}}}) == Verdict::Commit);
  hand.stroke_through({{2, 0, 1}, {3, 0, -1}});
  REQUIRE(hand.network().curves.size() == 2);
  CHECK(hand.network().nodes.size() == 4);
  hand.tool.set_mode(SurfaceMode::Select);
  const Vec2 start = hand.pixel(hand.node_place("n2"));
  hand.drag(start, start + Vec2(30, 25));
  const Vec3 moved = hand.node_place("n2"), image = hand.node_place("n2_m");
  CHECK((mirrored(moved, *hand.tool.symmetry()) - image).norm() < 1e-12);
  hand.tool.take(recorded::SurfaceSymmetry{});
  hand.drag(hand.pixel(moved), hand.pixel(moved) + Vec2(-30, 0));
  CHECK(hand.node_place("n2_m") == image);
}

TEST_CASE("every recorded step does again what the hand did") {
  SurfaceHand hand;
  fill_triangle(hand);
  hand.tool.set_mode(SurfaceMode::Point);
  const Vec2 press = hand.pixel((left + right + far) / 3);
  hand.drag(press, press + Vec2(0, -60));
  hand.look();
  hand.tool.set_mode(SurfaceMode::Select);
  const Vec2 start = hand.pixel(hand.node_place("n2"));
  hand.drag(start, start + Vec2(40, -30));
  hand.look();
  hand.tool.set_mode(SurfaceMode::Draw);
  hand.stroke_through({(hand.node_place("n1") + hand.node_place("n2")) / 2, hand.node_place("n3")});
  const auto note = [&](const recorded::Step& step) {
    REQUIRE(hand.tool.take(step) == Verdict::Commit);
    hand.recording.push_back(recorded::to_line(*hand.tool.done()));
  };
  note(recorded::SurfaceJoin{{"c1", "c2"}, CurveJoin::Smooth});
  note(recorded::SurfaceFaceSetting{{"f1"}, {AttributeMode::Position, AttributeDomain::Uniform, 0.25}, false});
  note(recorded::SurfaceFaceSetting{{"f1"}, {}, true});
  note(recorded::SurfaceSlope{{"c2", {}}, SlopeHandle{0.5, Vec3(0, 1, 0.2), 1.5}});
  note(recorded::SurfaceSlope{{"c2", {}}, {}});
  note(recorded::SurfaceDrag{{}, ControlHandle{"c2", 1}, {0, 0.2, 0}, {}});
  note(recorded::SurfaceSplit{"c2", 0.25, {}});
  PointSetting setting;
  setting.profile = PointProfile::Cone;
  setting.radius = std::optional(0.3);
  note(recorded::SurfacePointSetting{{"p1"}, setting});
  setting = {};
  setting.radius = std::optional<double>();
  setting.normal = std::optional(Vec3(0, 1, 0));
  note(recorded::SurfacePointSetting{{"p1"}, setting});
  note(recorded::SurfaceMirror{{{0, 0, 1.5}, {0, 0, 1}}});
  note(recorded::SurfaceSymmetry{SymmetryPlane{{0, 0, 1.5}, {0, 0, 1}}});
  note(recorded::SurfaceChoice{{{"n1"}, {"c1"}, {}, {"p1"}}});
  note(recorded::SurfaceDelete{{{}, {}, {"f1_m"}, {}}});
  note(recorded::SurfaceSymmetry{});

  SurfaceHand again;
  for (const std::string& line : hand.recording) {
    INFO(line);
    const auto steps = recorded::parse(line, "test", recorded::all_steps());
    CHECK(again.tool.take(steps.front().step) != Verdict::Revert);
    CHECK(recorded::to_line(steps.front().step) == line);
  }
  CHECK(again.text() == hand.text());
  CHECK(again.tool.selected() == hand.tool.selected());
}

/// A ball to draw on, and nothing else.
class BallSight final : public SurfaceSight {
 public:
  explicit BallSight(const Vec3& middle) : middle_(middle) {}

  std::optional<MeshHit> mesh_under(const Ray& ray) const override {
    const Vec3 offset = ray.origin - middle_;
    const double half = offset.dot(ray.direction);
    const double rest = half * half - offset.squaredNorm() + 1;
    if (rest < 0) return std::nullopt;
    const double distance = -half - std::sqrt(rest);
    return MeshHit{ray.at(distance), (ray.at(distance) - middle_).normalized(), distance};
  }
  std::optional<SurfaceHit> patch_under(const Ray&) const override { return std::nullopt; }
  std::optional<Vec3> normal_at(const std::string&) const override { return std::nullopt; }
  std::optional<double> radius_of(const std::string&) const override { return std::nullopt; }
  std::vector<Vec3> ring_of(const std::string&, double) const override { return {}; }
  std::optional<SlopeFrame> slope_at(const std::string&, const std::string&, double) const override { return {}; }

 private:
  Vec3 middle_;
};

TEST_CASE("a stroke that begins on a mesh lies on it, and so does one between nodes on it") {
  SurfaceHand hand;
  const Vec3 middle(1, 1, 0);
  hand.tool.settings().sight = std::make_shared<const BallSight>(middle);
  const Vec2 centre = hand.pixel(middle);
  REQUIRE(hand.stroke({centre + Vec2(-45, 10), centre + Vec2(40, -15)}) == Verdict::Commit);
  const auto distance = [&](const Vec3& place) { return std::abs((place - middle).norm() - 1); };
  for (const Vec3& place : traced_curve(hand.network(), 0)) CHECK(distance(place) < 0.05);
  CHECK(hand.network().curves[0].control.size() >= 3);
  REQUIRE(hand.stroke({hand.pixel(hand.node_place("n2")), centre + Vec2(5, 40), hand.pixel(hand.node_place("n1"))}) ==
          Verdict::Commit);
  CHECK(hand.network().nodes.size() <= 3);
  for (Index curve = 1; curve < hand.network().curves.size(); ++curve) {
    for (const Vec3& place : traced_curve(hand.network(), curve)) CHECK(distance(place) < 0.05);
  }
  CHECK(hand.stroke({{20, 560}, {200, 560}}) == Verdict::Commit);  // beside it: on the ground
  CHECK(std::abs(hand.network().nodes.back().point.y()) < 1e-9);
}

TEST_CASE("commands about what isn't there are refused, and nothing changes") {
  SurfaceHand hand;
  draw_triangle(hand);
  const std::string before = hand.text();
  CHECK_THROWS_AS(hand.tool.take(recorded::SurfaceDrag{{{"n9"}, {}, {}, {}}, {}, Vec3::UnitX(), {}}), Error);
  CHECK_THROWS_AS(hand.tool.take(recorded::SurfaceMerge{"c1"}), Error);
  CHECK_THROWS_AS(hand.tool.take(recorded::SurfaceStroke{{{0, 0, 0}, {1, 0, 0}}, 0.01, {"n9", {}, 0}, {}, {}}), Error);
  CHECK(hand.tool.take(recorded::SurfaceDelete{{{"n9"}, {}, {}, {}}}) == Verdict::Continue);
  CHECK(hand.text() == before);
  CHECK_THROWS_WITH(
      recorded::parse(R"({"do":"surface-join","curves":["c1"],"join":"round"})", "test", recorded::all_steps()),
      Catch::Contains("join"));
}

}  // namespace
}  // namespace croquis
