// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>

#include <catch2/catch.hpp>

#include "croquis/tools/pointer/pen.h"
#include "tools/pointer/pointer_traces.h"

namespace croquis {
namespace {

using test::pointer;
using Device = PointerEvent::Device;
using Action = PointerEvent::Action;
using Kind = PenStep::Kind;

struct CleanStroke {
  PenStep first;
  std::vector<PenSample> samples;
};

/// Feeds events and gathers what is reported, holding PenInput to its order of steps.
struct Feed {
  PenInput pen;
  std::vector<CleanStroke> finished;
  int cancelled = 0;
  std::optional<CleanStroke> open;

  explicit Feed(PenOptions options = {}) : pen(options) {}

  void take(const std::vector<PenStep>& steps) {
    for (const PenStep& step : steps) {
      REQUIRE(open.has_value() == (step.kind != Kind::Begin));
      if (step.kind == Kind::Begin) open = CleanStroke{step, {step.sample}};
      if (step.kind == Kind::Sample) open->samples.push_back(step.sample);
      if (step.kind == Kind::End) finished.push_back(*open);
      if (step.kind == Kind::Cancel) ++cancelled;
      if (step.kind == Kind::End || step.kind == Kind::Cancel) open.reset();
    }
  }
  void operator()(const PointerEvent& event) { take(pen.handle(event)); }
  void operator()(const test::Trace& trace) {
    for (const PointerEvent& event : trace) (*this)(event);
  }
  void operator()(Device device, Action action, const Vec2& at, double time, bool left = true, double pressure = 0.5) {
    PointerEvent event = pointer(device, action, at, time);
    event.buttons.left = left && action != Action::Release && action != Action::Hover;
    event.pressure = event.buttons.left ? pressure : 0;
    (*this)(event);
  }
};

bool times_rise(const std::vector<PenSample>& samples) {
  return std::is_sorted(samples.begin(), samples.end(),
                        [](const PenSample& a, const PenSample& b) { return a.time < b.time; });
}

TEST_CASE("ten seconds at 300 Hz keep all 3000 samples with place, pressure and time") {
  for (const test::DriverTrace& driver : test::driver_traces(3000, 5)) {
    INFO(driver.name);
    Feed feed;
    feed(driver.pen.empty() ? driver.mouse : driver.pen);
    REQUIRE(feed.finished.size() == 1);
    const CleanStroke& stroke = feed.finished.front();
    REQUIRE(stroke.samples.size() == 3000);
    CHECK(times_rise(stroke.samples));
    CHECK(stroke.samples[1000].time == Approx(5 + 1000 / 300.0));
    CHECK(stroke.samples[1000].position.x() == Approx(300.25 + 200 * std::cos(2 * 1000 / 300.0)));
    CHECK(stroke.samples[2077].pressure == Approx(driver.pen.empty() ? 1 : 0.2 + 0.5 * 0.77));
  }
}

TEST_CASE("any mix of pen events and their mouse copies is one stroke, the pen's, with every sample") {
  for (const double delay : {0.0, 0.003, 0.02, 0.15}) {
    for (const std::size_t points : {4U, 40U, 400U}) {
      for (const test::DriverTrace& driver : test::driver_traces(points, 2)) {
        test::Random random(points);
        for (int mix = 0; mix < 40; ++mix) {
          INFO(driver.name << ", " << points << " points, delay " << delay << ", mix " << mix);
          Feed feed;
          feed(test::interleaved(driver, delay, random));
          REQUIRE(feed.finished.size() == 1);
          REQUIRE(!feed.open);
          const CleanStroke& stroke = feed.finished.front();
          const bool whole_copy_first = !is_pen(stroke.first.device) && !driver.pen.empty();
          if (whole_copy_first) continue;  // a copy that ended before its pen began: nothing better is known
          CHECK(stroke.samples.size() == driver.points);
          CHECK(times_rise(stroke.samples));
        }
      }
    }
  }
}

TEST_CASE("a pen never loses its pressure to a copy that is less than a stroke early") {
  for (const test::DriverTrace& driver : test::driver_traces(200, 2)) {
    if (driver.pen.empty()) continue;
    test::Random random(11);
    for (int mix = 0; mix < 40; ++mix) {
      INFO(driver.name << ", mix " << mix);
      Feed feed;
      feed(test::interleaved(driver, 0.1, random));
      REQUIRE(feed.finished.size() == 1);
      CHECK(is_pen(feed.finished.front().first.device));
    }
  }
}

TEST_CASE("strokes in quick succession stay apart for every mix") {
  for (std::size_t kind = 0; kind < 6; ++kind) {
    test::Random random(kind);
    for (int mix = 0; mix < 20; ++mix) {
      Feed feed;
      std::string name;
      for (int k = 0; k < 5; ++k) {
        const test::DriverTrace driver = test::driver_traces(90, 2 + 0.45 * k)[kind];
        name = driver.name;
        feed(test::interleaved(driver, 0.02, random));
      }
      INFO(name << ", mix " << mix);
      REQUIRE(feed.finished.size() == 5);
      for (const CleanStroke& stroke : feed.finished) CHECK(stroke.samples.size() == 90);
    }
  }
}

TEST_CASE("the first point waits for its pressure") {
  Feed feed;
  feed(Device::Pen, Action::Press, {10, 10}, 1.000, true, 0);
  CHECK(feed.pen.down());
  CHECK(!feed.open);
  feed(Device::Pen, Action::Move, {11, 10}, 1.003, true, 0);
  CHECK(!feed.open);
  feed(Device::Pen, Action::Move, {12, 10}, 1.006, true, 0.4);
  REQUIRE(feed.open);
  REQUIRE(feed.open->samples.size() == 3);
  for (const PenSample& sample : feed.open->samples) CHECK(sample.pressure == 0.4);
}

TEST_CASE("a pen without pressure draws after a short wait, as if pressed fully") {
  Feed feed;
  for (int i = 0; i < 30; ++i) {
    feed(Device::Pen, i == 0 ? Action::Press : Action::Move, {10.0 + i, 10}, 1 + i / 300.0, true, 0);
    if (i > 16) CHECK(feed.open);
  }
  feed(Device::Pen, Action::Release, {39, 10}, 1.2);
  REQUIRE(feed.finished.size() == 1);
  CHECK(feed.finished[0].samples.size() == 30);
  for (const PenSample& sample : feed.finished[0].samples) CHECK(sample.pressure == 1);
}

TEST_CASE("a timer settles a tap that waits for its pressure") {
  Feed feed;
  feed(Device::Pen, Action::Press, {10, 10}, 1, true, 0);
  feed.take(feed.pen.settle(1.01));
  CHECK(!feed.open);
  feed.take(feed.pen.settle(1.1));
  REQUIRE(feed.open);
  CHECK(feed.open->samples[0].pressure == 1);
}

TEST_CASE("a lost release ends the stroke at the next press, at hovering, and on leaving") {
  for (const Device device : {Device::Pen, Device::Mouse}) {
    Feed press;
    press(device, Action::Press, {10, 10}, 1);
    press(device, Action::Move, {30, 10}, 1.1);
    press(device, Action::Press, {90, 90}, 3);
    CHECK(press.finished.size() == 1);
    CHECK(press.open);
    Feed hover;
    hover(device, Action::Press, {10, 10}, 1);
    hover(device, Action::Hover, {30, 10}, 1.5);
    CHECK(hover.finished.size() == 1);
    Feed leave;
    leave(device, Action::Press, {10, 10}, 1);
    leave(Device::Mouse, Action::Leave, {10, 10}, 1.5, false);
    CHECK(leave.finished.size() == 1);
    leave(device, Action::Move, {12, 10}, 1.51);
    CHECK(!leave.open);
  }
}

TEST_CASE("losing sight of the pen ends its stroke only when contact doesn't go on") {
  Feed feed;
  feed(Device::Pen, Action::Press, {10, 10}, 1);
  feed(Device::Pen, Action::ProximityOut, {10, 10}, 1.01);
  feed(Device::Pen, Action::Move, {11, 10}, 1.02);
  REQUIRE(feed.open);
  CHECK(feed.open->samples.size() == 2);
  feed(Device::Pen, Action::ProximityOut, {11, 10}, 1.03);
  feed.take(feed.pen.settle(1.1));
  CHECK(feed.open);
  feed.take(feed.pen.settle(1.5));
  CHECK(!feed.open);
  CHECK(feed.finished.size() == 1);
}

TEST_CASE("the mouse draws by itself, also shortly after the pen when it is elsewhere") {
  Feed feed;
  feed(Device::Pen, Action::Press, {10, 10}, 1);
  feed(Device::Pen, Action::Move, {20, 10}, 1.05);
  feed(Device::Pen, Action::Release, {20, 10}, 1.1);
  feed(Device::Mouse, Action::Press, {15, 11}, 1.2);  // a copy
  CHECK(!feed.open);
  feed(Device::Mouse, Action::Release, {20, 10}, 1.21);
  feed(Device::Mouse, Action::Press, {300, 200}, 1.25);
  CHECK(feed.open);
  feed(Device::Mouse, Action::Release, {300, 200}, 1.3);
  feed(Device::Mouse, Action::Press, {15, 11}, 2);  // same place, much later
  REQUIRE(feed.open);
  CHECK(feed.open->samples[0].pressure == 1);
}

TEST_CASE("a driver that reports hovering by pen but presses by mouse can draw") {
  Feed feed;
  double time = 1;
  for (int i = 0; i < 10; ++i) feed(Device::Pen, Action::Hover, {10, 10}, time += 0.01);
  feed(Device::Mouse, Action::Press, {10, 10}, time += 0.01);
  for (int i = 0; i < 50; ++i) feed(Device::Mouse, Action::Move, {10.0 + i, 10}, time += 0.01);
  CHECK(feed.open);
  feed(Device::Mouse, Action::Release, {60, 10}, time += 0.01);
  REQUIRE(feed.finished.size() == 1);
  CHECK(feed.finished[0].samples.size() == 52);
}

TEST_CASE("the eraser end erases, unless it was switched off, and keeps what it began as") {
  for (const bool erases : {true, false}) {
    PenOptions options;
    options.eraser_erases = erases;
    Feed feed(options);
    feed(Device::Eraser, Action::Press, {10, 10}, 1);
    feed(Device::Pen, Action::Move, {11, 10}, 1.01);
    feed(Device::Eraser, Action::Release, {11, 10}, 1.02);
    REQUIRE(feed.finished.size() == 1);
    CHECK(feed.finished[0].first.erases == erases);
    CHECK(feed.finished[0].samples.size() == 2);
  }
}

TEST_CASE("fingers, side switches and other buttons never draw") {
  Feed feed;
  feed(Device::Touch, Action::Press, {10, 10}, 1);
  feed(Device::Touch, Action::Move, {20, 10}, 1.1);
  PointerEvent barrel = pointer(Device::Pen, Action::Press, {10, 10}, 2);
  barrel.buttons.barrel = true;
  feed(barrel);
  barrel.buttons.left = true;  // and then the tip comes down
  barrel.pressure = 0.5;
  feed(barrel);
  barrel.action = Action::Move;
  barrel.buttons.barrel = false;  // the switch is let go first
  barrel.time = 2.5;
  feed(barrel);
  PointerEvent right = pointer(Device::Mouse, Action::Press, {400, 400}, 9);
  right.buttons.right = true;
  feed(right);
  CHECK(!feed.open);
  CHECK(feed.finished.empty());
}

TEST_CASE("a cancelled stroke is forgotten and its device draws again only after it was lifted") {
  for (const Device device : {Device::Pen, Device::Mouse}) {
    Feed feed;
    feed(device, Action::Press, {10, 10}, 1);
    feed.take(feed.pen.cancel());
    CHECK(feed.cancelled == 1);
    feed(device, Action::Move, {20, 10}, 1.1);
    CHECK(!feed.open);
    feed(device, Action::Release, {20, 10}, 1.2);
    feed(device, Action::Press, {10, 10}, 2);
    CHECK(feed.open);
  }
}

TEST_CASE("the pressure curve bends pressures and keeps its ends") {
  PenOptions options;
  options.pressure_gamma = 2;
  Feed feed(options);
  feed(Device::Pen, Action::Press, {10, 10}, 1, true, 0.5);
  feed(Device::Pen, Action::Move, {11, 10}, 1.01, true, 1.0);
  REQUIRE(feed.open);
  CHECK(feed.open->samples[0].pressure == 0.25);
  CHECK(feed.open->samples[1].pressure == 1);
}

TEST_CASE("random nonsense never breaks the order of steps, and a clean stroke still works afterwards") {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    test::Random random(seed);
    Feed feed;
    double time = 100;
    for (int i = 0; i < 200; ++i) {
      PointerEvent event = pointer(static_cast<Device>(random.below(4)), static_cast<Action>(random.below(8)),
                                   {random.between(0, 40), random.between(0, 40)}, time);
      event.buttons = {random.below(2) == 0, random.below(8) == 0, random.below(8) == 0, random.below(8) == 0};
      event.pressure = random.between(-0.2, 1.2);
      event.view = static_cast<int>(random.below(2));
      if (random.below(10) == 0) feed.take(feed.pen.cancel());
      if (random.below(10) == 0) feed.take(feed.pen.settle(time));
      feed(event);
      time += random.between(-0.02, 0.05);
    }
    for (const Device device : {Device::Mouse, Device::Pen}) feed(device, Action::Hover, {0, 0}, time += 10);
    for (const Device device : {Device::Mouse, Device::Pen}) {
      const std::size_t before = feed.finished.size();
      feed(device, Action::Press, {500, 500}, time += 10);
      feed(device, Action::Move, {510, 500}, time += 0.01);
      feed(device, Action::Release, {520, 500}, time += 0.01);
      REQUIRE(feed.finished.size() == before + 1);
      CHECK(feed.finished.back().samples.size() == 3);
    }
  }
}

TEST_CASE("the right button of a mouse draws where that is wanted, from its press to its release") {
  for (const bool wanted : {false, true}) {
    PenOptions options;
    options.right_draws = wanted;
    Feed feed(options);
    for (int i = 0; i < 10; ++i) {
      PointerEvent event = pointer(Device::Mouse, i == 0 ? Action::Press : Action::Move, {10.0 * i, 0}, 0.01 * i);
      event.buttons = {};
      event.buttons.right = true;
      feed(event);
    }
    PointerEvent release = pointer(Device::Mouse, Action::Release, {90, 0}, 0.1);
    release.buttons = {};
    feed(release);
    REQUIRE(feed.finished.size() == (wanted ? 1 : 0));
    if (wanted) {
      CHECK(feed.finished[0].first.right);
      CHECK(feed.finished[0].samples.size() == 10);
    }
    feed(Device::Mouse, Action::Press, {0, 50}, 1);
    feed(Device::Mouse, Action::Move, {50, 50}, 1.1);
    feed(Device::Mouse, Action::Release, {50, 50}, 1.2);
    REQUIRE(feed.finished.size() == (wanted ? 2 : 1));
    CHECK(!feed.finished.back().first.right);
  }
}

}  // namespace
}  // namespace croquis
