// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/tools/holes/hole_tool.h"
#include "croquis/tools/recording/recording.h"
#include "tools/holes/hole_rings.h"
#include "tools/pointer/mesh_views.h"

namespace croquis {
namespace {

using Kind = PenStep::Kind;
using Holes = std::vector<Index>;
using recorded::HoleChoice;
using recorded::HolePoint;

constexpr Modifiers plain{};
constexpr Modifiers shift{true, false, false, false};
constexpr Modifiers ctrl{false, true, false, false};
constexpr Modifiers both{true, true, false, false};
const Vec3 nowhere(0, 1.8, 0);

/// A patch over the hole at the origin: a square in z = 0.
HolePatchView square_patch(Index hole, double half) {
  return {hole, {{-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}}, {{{0, 1, 2}}, {{0, 2, 3}}}};
}

/// Four holes beside each other before a camera, and a hand.
struct Desk {
  HoleTool tool;
  test::TestCamera camera;
  double clock = 0;

  Desk() {
    tool.set_rims({test::ring(7, {-1.5, 0, 0}, 0.3), test::ring(2, {0, 0, 0}, 0.4), test::ring(4, {1.5, 0, 0}, 0.3),
                   test::ring(5, {1.5, -1, 0}, 0.2)});
  }

  Verdict send(Kind kind, const Vec2& pixel, const Modifiers& modifiers = plain) {
    clock += 0.01;
    return tool.handle({kind, pixel, modifiers, camera.frame(), clock});
  }
  Verdict click(const Vec3& place, const Modifiers& modifiers = plain, double after = 1) {
    clock += after;
    send(Kind::Begin, camera.pixel_of(place), modifiers);
    return send(Kind::End, camera.pixel_of(place), modifiers);
  }
  Verdict double_click(const Vec3& place) {
    click(place);
    return click(place, plain, 0.05);
  }
  Verdict drag(const Vec2& from, const Vec2& to, const Modifiers& modifiers = plain) {
    clock += 1;
    send(Kind::Begin, from, modifiers);
    for (int i = 1; i <= 4; ++i) send(Kind::Sample, from + (to - from) * i / 4, modifiers);
    return send(Kind::End, to, modifiers);
  }
  Verdict box(const Vec3& from, const Vec3& to, const Modifiers& modifiers = plain) {
    return drag(camera.pixel_of(from), camera.pixel_of(to), modifiers);
  }
  bool hover(const Vec3& place) { return tool.hover(camera.pixel_of(place), camera.frame()); }
  const HoleHover& hovered() const { return tool.preview().hovered; }
  HoleChoice choice() const { return *tool.done()->as<HoleChoice>(); }
  HolePoint point() const { return *tool.done()->as<HolePoint>(); }
};

TEST_CASE("clicks on pins replace, toggle, remove and add; a click beside lets go") {
  Desk desk;
  CHECK(desk.click({0, 0, 0}) == Verdict::Commit);
  CHECK(desk.tool.selected() == Holes{2});
  CHECK(desk.choice().action == "select");
  CHECK(desk.choice().holes == Holes{2});
  CHECK(desk.click({0, 0, 0}) == Verdict::Continue);
  CHECK(desk.click({1.5, 0, 0}, shift) == Verdict::Commit);
  CHECK(desk.choice().action == "toggle");
  CHECK(desk.tool.selected() == Holes{2, 4});
  desk.click({0, 0, 0}, shift);
  CHECK(desk.tool.selected() == Holes{4});
  desk.click({-1.5, 0, 0}, both);
  CHECK(desk.choice().action == "add");
  CHECK(desk.tool.selected() == Holes{4, 7});
  desk.click({1.5, 0, 0}, ctrl);
  CHECK(desk.choice().action == "remove");
  CHECK(desk.tool.selected() == Holes{7});
  CHECK(desk.click(nowhere, shift) == Verdict::Continue);
  CHECK(desk.click(nowhere) == Verdict::Commit);
  CHECK(desk.tool.selected().empty());
  CHECK(desk.choice().holes.empty());
}

TEST_CASE("rims are picked within reach, pins before them") {
  Desk desk;
  const double unit = desk.camera.frame().units_per_pixel({0, 0, 0});
  CHECK(desk.hover({0.4 + 6 * unit, 0, 0}));
  CHECK(desk.hovered() == HoleHover{HolePart::Rim, {2}, 0, std::nullopt});
  CHECK_FALSE(desk.hover({0.4 + 5 * unit, 0, 0}));
  CHECK(desk.hover({0.4 + 8 * unit, 0, 0}));
  CHECK(desk.hovered() == HoleHover{});
  // Another rim runs through the pin of hole 2.
  std::vector<HoleRim> rims = desk.tool.rims();
  rims.push_back(test::ring(9, {0.9, 0, 0}, 0.9));
  desk.tool.set_rims(rims);
  desk.hover({0, 0, 0});
  CHECK(desk.hovered() == HoleHover{HolePart::Pin, {2}, 0, std::nullopt});
  CHECK(desk.tool.leave());
  CHECK_FALSE(desk.tool.leave());
}

TEST_CASE("a click into an opening picks its hole, the inner one of two, and none that looks away or is hidden") {
  Desk desk;
  desk.tool.set_rims({test::ring(1, {0, 0, 0}, 1.2), test::ring(3, {0.5, 0, 0}, 0.4)});
  const Vec3 between(-0.7, 0.3, 0), within(0.65, 0.15, 0);
  desk.hover(between);
  CHECK(desk.hovered() == HoleHover{HolePart::Opening, {1}, 0, std::nullopt});
  CHECK(desk.click(within) == Verdict::Commit);
  CHECK(desk.tool.selected() == Holes{3});
  desk.tool.set_sight([](const ViewFrame&, const Vec3& place) { return place.x() < -2; });
  desk.hover(between);
  CHECK(desk.hovered().part == HolePart::None);
  desk.tool.set_sight({});
  std::vector<HoleRim> away = desk.tool.rims();
  for (HoleRim& rim : away) rim.normal = -rim.normal;
  desk.tool.set_rims(away);
  desk.hover(between);
  CHECK(desk.hovered().part == HolePart::None);
}

TEST_CASE("hidden rims aren't picked, and boxes leave hidden holes out") {
  Desk desk;
  desk.tool.set_sight([](const ViewFrame&, const Vec3& place) { return place.x() < 0; });
  desk.hover({0.4, 0, 0});
  CHECK(desk.hovered().part == HolePart::None);
  desk.hover({-0.4, 0, 0});
  CHECK(desk.hovered().part == HolePart::Rim);
  desk.box({-2, -1.5, 0}, {2, 1, 0});
  CHECK(desk.tool.selected() == Holes{7});
  // Pins stand for hidden holes, too.
  desk.click({1.5, 0, 0});
  CHECK(desk.tool.selected() == Holes{4});
}

TEST_CASE("boxes pick the holes whose places are in them, with the keys of clicks") {
  Desk desk;
  CHECK(desk.box({-1.9, -0.6, 0}, {0.8, 0.6, 0}) == Verdict::Commit);
  CHECK(desk.tool.selected() == Holes{2, 7});
  desk.box({0.9, -1.4, 0}, {2, 0.6, 0}, both);
  CHECK(desk.tool.selected() == Holes{2, 4, 5, 7});
  desk.box({0.9, -1.4, 0}, {2, 0.6, 0}, ctrl);
  CHECK(desk.tool.selected() == Holes{2, 7});
  CHECK(desk.choice().holes == Holes{4, 5});
  desk.send(Kind::Begin, {10, 10});
  desk.send(Kind::Sample, {60, 90});
  REQUIRE(desk.tool.preview().box);
  CHECK(desk.tool.preview().box->high == Vec2(60, 90));
  CHECK(desk.send(Kind::Cancel, {60, 90}) == Verdict::Revert);
  CHECK_FALSE(desk.tool.preview().box);
  CHECK(desk.tool.selected() == Holes{2, 7});
}

TEST_CASE("a double click fills a hole, and leaves one open that is filled") {
  Desk desk;
  CHECK(desk.double_click({0, 0, 0}) == Verdict::Commit);
  CHECK(desk.choice().action == "fill");
  CHECK(desk.choice().holes == Holes{2});
  desk.tool.set_filled({7, 2});
  CHECK(desk.tool.is_filled(2));
  desk.double_click({0, 0, 0});
  CHECK(desk.choice().action == "leave");
  // Two clicks that are slow, or apart, are two clicks.
  desk.click({1.5, 0, 0});
  CHECK(desk.click({1.5, 0, 0}, plain, 1) == Verdict::Continue);
  desk.click({0, 0, 0}, plain, 0.05);
  CHECK(desk.choice().action == "select");
}

TEST_CASE("holes on one pin are picked and filled together") {
  Desk desk;
  HolePinOptions pins;
  pins.most_moved = 0;
  desk.tool = HoleTool(HoleToolOptions{.pins = pins});
  desk.tool.set_rims({test::ring(0, {0, 0, 0}, 0.01), test::ring(1, {0.01, 0, 0}, 0.02)});
  desk.hover({0.01, 0, 0});
  CHECK(desk.hovered() == HoleHover{HolePart::Pin, {0, 1}, 0, std::nullopt});
  desk.tool.set_filled({1});
  desk.double_click({0.01, 0, 0});
  CHECK(desk.choice().holes == Holes{0, 1});
  CHECK(desk.choice().action == "fill");
}

TEST_CASE("a place pulled off a patch stays under the pointer, in the plane across the view") {
  Desk desk;
  desk.camera.eye = {1, 2, 4};
  desk.camera.perspective = GENERATE(true, false);
  if (!desk.camera.perspective) desk.camera.half_height = 2;
  desk.tool.set_patches({square_patch(2, 0.35)});
  const Vec3 grip(0.25, 0.2, 0);
  const ViewFrame frame = desk.camera.frame();
  const Vec2 to = desk.camera.pixel_of(grip) + Vec2(40, -70);
  CHECK(desk.drag(desk.camera.pixel_of(grip), to) == Verdict::Commit);
  const HolePoint step = desk.point();
  CHECK(step.hole == 2);
  CHECK((*step.from - grip).norm() < 1e-6);
  CHECK((desk.camera.pixel_of(*step.to) - to).norm() < 1e-6);
  CHECK(std::abs((*step.to - *step.from).dot(desk.camera.forward())) < 1e-9);
  CHECK(frame.project(*step.to)->depth == Approx(frame.project(grip)->depth));
}

TEST_CASE("with Shift it moves along the patch's normal only") {
  Desk desk;
  desk.camera.eye = GENERATE(Vec3(3, 1, 3), Vec3(0, 0, 5), Vec3(3, 1, -3));
  desk.tool.set_patches({square_patch(2, 0.35)});
  const Vec3 grip(0.25, 0.2, 0);
  const Vec2 start = desk.camera.pixel_of(grip);
  desk.drag(start, start + Vec2(10, -50), shift);
  const Vec3 moved = *desk.point().to - *desk.point().from;
  CHECK(moved.head<2>().norm() < 1e-9);
  CHECK(std::abs(moved.z()) > 0.02);
  CHECK(std::abs(moved.z()) < 2);
  // Upwards on screen is outwards where the normal points up there, and when it points at the eye.
  if (desk.camera.eye.x() == 0) CHECK(moved.z() > 0);
}

TEST_CASE("along the normal the place keeps to the pointer") {
  Desk desk;
  desk.camera.eye = {4, 0, 0.5};
  desk.camera.up = Vec3::UnitZ();
  const Vec3 grip(0.3, 0.2, 0);
  desk.tool.set_handles({{2, grip, Vec3::UnitZ()}});
  desk.drag(desk.camera.pixel_of(grip), desk.camera.pixel_of(grip + Vec3(0, 0, 0.6)), shift);
  CHECK((*desk.point().to - Vec3(0.3, 0.2, 0.6)).norm() < 1e-3);
}

TEST_CASE("handles are moved, and taken away with Ctrl") {
  Desk desk;
  desk.tool.set_patches({square_patch(2, 0.35)});
  desk.tool.set_handles({{7, {-1.5, 0, 0.2}, Vec3::UnitZ()}, {2, {0.2, 0.2, 0.1}, Vec3::UnitZ()}});
  desk.hover({0.2, 0.2, 0.1});
  CHECK(desk.hovered().part == HolePart::Handle);
  CHECK(desk.hovered().handle == 1);

  const Vec2 start = desk.camera.pixel_of({0.2, 0.2, 0.1}) + Vec2(3, 0);
  desk.send(Kind::Begin, start);
  desk.send(Kind::Sample, start + Vec2(0, 30));
  REQUIRE(desk.tool.preview().pull);
  CHECK(desk.tool.preview().pull->handle == 1U);
  CHECK(desk.tool.preview().pull->from == Vec3(0.2, 0.2, 0.1));
  // The hand took hold beside the handle's middle: it keeps that much away.
  CHECK((desk.camera.pixel_of(desk.tool.preview().pull->to) - (start + Vec2(-3, 30))).norm() < 1e-6);
  // What the preview brings while dragging doesn't end the drag.
  desk.tool.set_handles({});
  desk.tool.set_patches({});
  CHECK(desk.send(Kind::End, start + Vec2(0, 30)) == Verdict::Commit);
  CHECK(desk.point().from == Vec3(0.2, 0.2, 0.1));

  desk.tool.set_handles({{2, {0.2, 0.2, 0.1}, Vec3::UnitZ()}});
  CHECK(desk.click({0.2, 0.2, 0.1}, ctrl) == Verdict::Commit);
  CHECK(desk.point().from == Vec3(0.2, 0.2, 0.1));
  CHECK_FALSE(desk.point().to);
}

TEST_CASE("a pull that is given up, or comes back, changes nothing") {
  Desk desk;
  desk.tool.set_patches({square_patch(2, 0.35)});
  const Vec2 start = desk.camera.pixel_of({0.25, 0.2, 0});
  desk.send(Kind::Begin, start);
  desk.send(Kind::Sample, start + Vec2(30, 0));
  CHECK(desk.tool.active());
  CHECK(desk.send(Kind::Cancel, start) == Verdict::Revert);
  CHECK_FALSE(desk.tool.preview().pull);
  CHECK(desk.send(Kind::End, start) == Verdict::Continue);
  CHECK_FALSE(desk.tool.done());

  desk.send(Kind::Begin, start);
  desk.send(Kind::Sample, start + Vec2(30, 0));
  desk.send(Kind::Sample, start);
  CHECK(desk.tool.preview().pull);
  desk.send(Kind::End, start);
  CHECK((desk.tool.done() ? (*desk.point().to - *desk.point().from).norm() : 0) < 1e-9);
}

TEST_CASE("a click on a patch selects its hole; the patch nearer to the eye wins") {
  Desk desk;
  HolePatchView before = square_patch(4, 0.35);
  for (Vec3& place : before.positions) place.z() = 0.5;
  desk.tool.set_patches({square_patch(2, 0.35), before});
  desk.click({0.2, 0.15, 0.5});
  CHECK(desk.tool.selected() == Holes{4});
}

TEST_CASE("selections outlive new rims as far as the holes are there") {
  Desk desk;
  desk.tool.select({4, 7, 99, 4});
  CHECK(desk.tool.selected() == Holes{4, 7});
  desk.tool.set_rims({test::ring(4, {0, 0, 0}, 0.2)});
  CHECK(desk.tool.selected() == Holes{4});
  CHECK(desk.tool.is_selected(4));
  CHECK(desk.tool.select({4}) == Verdict::Continue);
  CHECK(desk.tool.rim(7) == nullptr);
}

TEST_CASE("steps replay what was done by hand, and name each hole that isn't there") {
  Desk desk;
  Desk other;
  const auto same = [&] {
    const std::string line = recorded::to_line(*desk.tool.done());
    const recorded::Step step = recorded::parse(line, "", recorded::hole_steps()).front().step;
    other.tool.take(step);
    CHECK(other.tool.selected() == desk.tool.selected());
    CHECK(recorded::to_line(*other.tool.done()) == recorded::to_line(*desk.tool.done()));
  };
  desk.click({0, 0, 0});
  same();
  desk.box({0.9, -1.4, 0}, {2, 0.6, 0}, shift);
  same();
  desk.click({1.5, 0, 0});
  same();
  desk.click({1.5, 0, 0}, plain, 0.05);
  same();
  desk.tool.set_patches({square_patch(2, 0.35)});
  desk.drag(desk.camera.pixel_of({0.25, 0.2, 0}), {300, 100});
  same();
  try {
    other.tool.take(HoleChoice{{2, 50, 51}, "fill", {}});
    FAIL("holes 50 and 51 don't exist");
  } catch (const Error& error) {
    CHECK(error.findings().size() == 2);
    CHECK(error.findings()[1].message.find("51") != std::string::npos);
  }
  CHECK_THROWS_AS(other.tool.take(HolePoint{50, Vec3::Zero(), Vec3::Zero(), {}}), Error);
}

TEST_CASE("points of a patch are moved, made and taken away") {
  const std::vector<Vec3> through = {{0, 0, 0}, {1, 0, 0}, {0, 0, 0}};
  const Vec3 to(5, 5, 5);
  CHECK(moved_through(through, {0, Vec3(1, 0, 0), to, {}}) == std::vector<Vec3>{{0, 0, 0}, to, {0, 0, 0}});
  CHECK(moved_through(through, {0, Vec3(0, 0, 0), to, {}}) == std::vector<Vec3>{to, {1, 0, 0}, {0, 0, 0}});
  CHECK(moved_through(through, {0, Vec3(1, 0, 1e-9), to, {}}).size() == 4);
  CHECK(moved_through(through, {0, Vec3(0.9, 0, 0), to, {}}, 0.2)[1] == to);
  CHECK(moved_through(through, {0, std::nullopt, to, {}}).back() == to);
  CHECK(moved_through(through, {0, Vec3(1, 0, 0), std::nullopt, {}}) == std::vector<Vec3>{{0, 0, 0}, {0, 0, 0}});
  CHECK(moved_through(through, {0, Vec3(2, 0, 0), std::nullopt, {}}) == through);
}

TEST_CASE("rims that pass beside the eye, pixels that are none and patches without area do no harm") {
  Desk desk;
  HoleRim around = test::ring(0, {0, 0, 5}, 3);
  HoleRim through = test::ring(1, {0, 0, 0}, 8);
  for (Vec3& point : through.points) point = {point.x(), 0.1, point.y()};
  desk.tool.set_rims({around, through});
  HolePatchView flat = square_patch(0, 0);
  desk.tool.set_patches({flat});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (int x = 0; x <= 800; x += 100) {
    for (int y = 0; y <= 600; y += 100) desk.tool.hover(Vec2(x, y), desk.camera.frame());
  }
  CHECK_FALSE(desk.tool.hover(Vec2(nan, 3), desk.camera.frame()));
  CHECK(desk.send(Kind::Begin, Vec2(nan, 3)) == Verdict::Continue);
  CHECK_FALSE(desk.tool.active());
}

}  // namespace
}  // namespace croquis
