// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <catch2/catch.hpp>

#include "croquis/tools/pointer/navigation.h"
#include "tools/pointer/pointer_traces.h"

namespace croquis {
namespace {

using test::pointer;
using Device = PointerEvent::Device;
using Action = PointerEvent::Action;
using Kind = CameraMotion::Kind;

/// What a drag by (30, -10) with these buttons and modifiers does, and whether it leaves anything behind.
struct Dragged {
  bool taken = false;
  std::optional<CameraMotion> motion;
};

Dragged drag(Navigation& navigation, Device device, Buttons buttons, Modifiers modifiers, int view = 0) {
  PointerEvent event = pointer(device, Action::Press, {100, 100}, 1);
  event.buttons = buttons;
  event.modifiers = modifiers;
  event.view = view;
  Dragged result;
  result.taken = navigation.handle(event).taken;
  event.action = Action::Move;
  event.position = {130, 90};
  event.time = 1.01;
  result.motion = navigation.handle(event).motion;
  event.action = Action::Release;
  event.buttons = {};
  event.time = 1.02;
  CHECK(navigation.handle(event).taken == result.taken);
  CHECK(!navigation.active());
  return result;
}

constexpr Buttons left = {.left = true};
constexpr Buttons middle = {.middle = true};
constexpr Buttons right = {.right = true};
constexpr Buttons barrel = {.barrel = true};
constexpr Modifiers none = {};
constexpr Modifiers shift = {.shift = true};
constexpr Modifiers ctrl = {.ctrl = true};
constexpr Modifiers alt = {.alt = true};
constexpr Modifiers super = {.super = true};

struct Row {
  NavigationPreset preset;
  Device device;
  Buttons buttons;
  Modifiers modifiers;
  std::optional<Kind> expected;
};

TEST_CASE("every preset's buttons and modifiers give the camera motion they stand for") {
  using enum NavigationPreset;
  const std::vector<Row> rows = {
      {Maya, Device::Mouse, left, alt, Kind::Tumble},       {Maya, Device::Mouse, middle, alt, Kind::Track},
      {Maya, Device::Mouse, right, alt, Kind::Dolly},       {Maya, Device::Mouse, left, super, Kind::Tumble},
      {Maya, Device::Mouse, middle, super, Kind::Track},    {Maya, Device::Mouse, right, super, Kind::Dolly},
      {Maya, Device::Mouse, left, none, std::nullopt},      {Maya, Device::Mouse, middle, none, std::nullopt},
      {Maya, Device::Mouse, right, none, std::nullopt},     {Maya, Device::Mouse, left, shift, std::nullopt},
      {Maya, Device::Pen, barrel, none, Kind::Tumble},      {Maya, Device::Pen, barrel, shift, Kind::Track},
      {Maya, Device::Pen, barrel, ctrl, Kind::Dolly},       {Maya, Device::Pen, left, none, std::nullopt},
      {Maya, Device::Pen, left, alt, Kind::Tumble},         {Maya, Device::Eraser, left, none, std::nullopt},
      {Blender, Device::Mouse, middle, none, Kind::Tumble}, {Blender, Device::Mouse, middle, shift, Kind::Track},
      {Blender, Device::Mouse, middle, ctrl, Kind::Dolly},  {Blender, Device::Mouse, left, super, Kind::Tumble},
      {Blender, Device::Mouse, left, none, std::nullopt},   {Blender, Device::Pen, barrel, none, Kind::Tumble},
      {Cad, Device::Mouse, middle, none, Kind::Tumble},     {Cad, Device::Mouse, middle, ctrl, Kind::Track},
      {Cad, Device::Mouse, middle, shift, Kind::Dolly},     {Cad, Device::Mouse, left, alt, Kind::Tumble},
      {Cad, Device::Mouse, right, none, std::nullopt},      {Cad, Device::Pen, barrel, ctrl, Kind::Dolly},
  };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    INFO("row " << i);
    const Row& row = rows[i];
    NavigationOptions options;
    options.preset = row.preset;
    Navigation navigation(options);
    const Dragged dragged = drag(navigation, row.device, row.buttons, row.modifiers, 3);
    CHECK(dragged.taken == row.expected.has_value());
    REQUIRE(dragged.motion.has_value() == row.expected.has_value());
    if (!row.expected) continue;
    CHECK(dragged.motion->kind == *row.expected);
    CHECK(dragged.motion->delta == Vec2(30, -10));
    CHECK(dragged.motion->about == Vec2(100, 100));
    CHECK(dragged.motion->view == 3);
    CHECK(dragged.motion->factor == Approx(row.expected == Kind::Dolly ? std::exp(0.005 * 40) : 1));
  }
}

TEST_CASE("a held twin key stands for Alt") {
  Navigation navigation;
  navigation.set_twin_key(true);
  CHECK(drag(navigation, Device::Mouse, left, none).motion->kind == Kind::Tumble);
  CHECK(drag(navigation, Device::Pen, left, none).motion->kind == Kind::Tumble);
  navigation.set_twin_key(false);
  CHECK(!drag(navigation, Device::Mouse, left, none).taken);
}

TEST_CASE("a flat view is tracked where another would tumble, and dollies as any") {
  Navigation navigation;
  navigation.set_flat(1, true);
  CHECK(drag(navigation, Device::Mouse, left, alt, 1).motion->kind == Kind::Track);
  CHECK(drag(navigation, Device::Pen, barrel, none, 1).motion->kind == Kind::Track);
  CHECK(drag(navigation, Device::Mouse, right, alt, 1).motion->kind == Kind::Dolly);
  CHECK(drag(navigation, Device::Mouse, left, alt, 2).motion->kind == Kind::Tumble);
}

TEST_CASE("the wheel comes nearer about the pointer, and back by the same amount") {
  Navigation navigation;
  PointerEvent event = pointer(Device::Mouse, Action::Wheel, {40, 50}, 1);
  event.wheel = 1;
  const Navigation::Answer nearer = navigation.handle(event);
  event.wheel = -1;
  const Navigation::Answer further = navigation.handle(event);
  REQUIRE((nearer.motion && further.motion));
  CHECK(nearer.motion->kind == Kind::Dolly);
  CHECK(nearer.motion->factor > 1.1);
  CHECK(nearer.motion->factor * further.motion->factor == Approx(1));
  CHECK(nearer.motion->about == Vec2(40, 50));
}

TEST_CASE("the motions of a drag add up to its whole way") {
  Navigation navigation;
  PointerEvent event = pointer(Device::Mouse, Action::Press, {0, 0}, 1);
  event.buttons = middle;
  event.modifiers = alt;
  navigation.handle(event);
  event.action = Action::Move;
  event.modifiers = none;  // Alt may be let go once the drag has begun
  test::Random random(3);
  Vec2 sum = Vec2::Zero();
  for (int i = 0; i < 100; ++i) {
    event.position = {random.between(-50, 50), random.between(-50, 50)};
    if (const auto motion = navigation.handle(event).motion) sum += motion->delta;
  }
  CHECK((sum - event.position).norm() < 1e-9);
}

TEST_CASE("mouse copies of a pen's drag move nothing and draw nothing") {
  Navigation navigation;
  PointerEvent pen = pointer(Device::Pen, Action::Press, {0, 0}, 1);
  pen.buttons = barrel;
  CHECK(navigation.handle(pen).taken);
  PointerEvent copy = pointer(Device::Mouse, Action::Press, {0, 0}, 1);
  copy.buttons = right;
  CHECK(navigation.handle(copy).taken);
  copy.action = Action::Move;
  copy.position = {50, 50};
  const Navigation::Answer moved = navigation.handle(copy);
  CHECK(moved.taken);
  CHECK(!moved.motion);
  pen.action = Action::Release;
  pen.buttons = {};
  navigation.handle(pen);
  CHECK(navigation.handle(copy).taken);  // the copy's button is still down
  copy.action = Action::Release;
  copy.buttons = {};
  CHECK(navigation.handle(copy).taken);
  copy.action = Action::Press;
  copy.buttons = left;
  CHECK(!navigation.handle(copy).taken);
}

PointerEvent finger(std::uint64_t id, Action action, const Vec2& at, double time) {
  PointerEvent event = pointer(Device::Touch, action, at, time);
  event.device_id = id;
  return event;
}

TEST_CASE("two fingers track by their middle and dolly by their spread; one does nothing") {
  Navigation navigation;
  CHECK(navigation.handle(finger(1, Action::Press, {100, 100}, 1)).taken);
  CHECK(!navigation.handle(finger(1, Action::Move, {110, 100}, 1.1)).motion);
  navigation.handle(finger(2, Action::Press, {210, 100}, 1.2));
  const Navigation::Answer answer = navigation.handle(finger(2, Action::Move, {310, 100}, 1.3));
  REQUIRE((answer.motion && answer.second));
  CHECK(answer.motion->kind == Kind::Track);
  CHECK(answer.motion->delta == Vec2(50, 0));
  CHECK(answer.second->kind == Kind::Dolly);
  CHECK(answer.second->factor == Approx(2));
  CHECK(answer.second->about == Vec2(210, 100));
  navigation.handle(finger(3, Action::Press, {0, 0}, 1.4));
  CHECK(!navigation.handle(finger(2, Action::Move, {300, 100}, 1.5)).motion);
}

TEST_CASE("fingers do nothing while a pen is near or draws: they are the palm until lifted") {
  Navigation navigation;
  PointerEvent pen = pointer(Device::Pen, Action::Hover, {0, 0}, 1);
  navigation.handle(pen);
  for (const std::uint64_t id : {1U, 2U}) navigation.handle(finger(id, Action::Press, {100.0 * double(id), 0}, 1.2));
  CHECK(!navigation.handle(finger(2, Action::Move, {300, 0}, 5)).motion);
  for (const std::uint64_t id : {1U, 2U}) navigation.handle(finger(id, Action::Release, {0, 0}, 6));
  for (const std::uint64_t id : {1U, 2U}) navigation.handle(finger(id, Action::Press, {100.0 * double(id), 0}, 7));
  CHECK(navigation.handle(finger(2, Action::Move, {300, 0}, 7.1)).motion);
  pen.action = Action::Press;
  pen.buttons = left;
  pen.time = 7.2;
  CHECK(!navigation.handle(pen).taken);
  CHECK(!navigation.handle(finger(2, Action::Move, {400, 0}, 7.3)).motion);
}

TEST_CASE("a window that moves under Alt without a press reports that Alt is swallowed, until a press comes") {
  Navigation navigation;
  navigation.window_moved();
  CHECK(!navigation.alt_swallowed());
  navigation.modifiers_changed(alt);
  navigation.window_moved();
  CHECK(navigation.alt_swallowed());
  drag(navigation, Device::Mouse, left, alt);
  CHECK(!navigation.alt_swallowed());
  navigation.window_moved();  // by something else, after a press that did arrive
  CHECK(!navigation.alt_swallowed());
  navigation.modifiers_changed(none);
  navigation.modifiers_changed(alt);
  navigation.window_moved();
  CHECK(navigation.alt_swallowed());
}

TEST_CASE("what was reported of a swallowed Alt is old once anything else is done") {
  Navigation navigation;
  const auto swallow = [&] {
    navigation.modifiers_changed(none);
    navigation.modifiers_changed(alt);
    navigation.window_moved();
    REQUIRE(navigation.alt_swallowed());
  };
  for (const Device device : {Device::Mouse, Device::Pen, Device::Touch}) {
    swallow();
    PointerEvent event;
    event.device = device;
    navigation.handle(event);  // only looks about
    CHECK(navigation.alt_swallowed());
    event.action = Action::Press;
    event.buttons = left;
    navigation.handle(event);
    CHECK(!navigation.alt_swallowed());
    event.action = Action::Release;
    event.buttons = {};
    navigation.handle(event);
  }
  swallow();
  PointerEvent wheel;
  wheel.action = Action::Wheel;
  wheel.wheel = 1;
  navigation.handle(wheel);
  CHECK(!navigation.alt_swallowed());
  swallow();
  navigation.something_done();
  CHECK(!navigation.alt_swallowed());
}

TEST_CASE("Alt that was let go where the window couldn't hear it isn't held any more") {
  Navigation navigation;
  navigation.modifiers_changed(alt);
  PointerEvent hover;  // without Alt
  navigation.handle(hover);
  navigation.window_moved();
  CHECK(!navigation.alt_swallowed());
}

}  // namespace
}  // namespace croquis
