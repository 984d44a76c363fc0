// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/pointer/pointer_traces.h"

#include <algorithm>
#include <cmath>

namespace croquis::test {
namespace {

using Device = PointerEvent::Device;
using Action = PointerEvent::Action;

constexpr double rate = 300;

Vec2 place(std::size_t i) {
  const double t = static_cast<double>(i) / rate;
  return {300 + 200 * std::cos(2 * t) + 0.25, 300 + 150 * std::sin(3 * t) + 0.125};
}

double when(double start, std::size_t i) { return start + static_cast<double>(i) / rate; }

/// Press, moves, release: `points` samples, the release at the last one's place.
Trace touching(Device device, std::size_t points, double start) {
  Trace trace;
  for (std::size_t i = 0; i < points; ++i) {
    trace.push_back(pointer(device, i == 0 ? Action::Press : Action::Move, place(i), when(start, i)));
    trace.back().pressure = is_pen(device) ? 0.2 + 0.5 * static_cast<double>(i % 100) / 100 : 0;
    trace.back().buttons.left = true;
  }
  trace.push_back(pointer(device, Action::Release, place(points - 1), when(start, points)));
  return trace;
}

Trace hovering(double from, double seconds, const Vec2& at, Device device) {
  Trace trace;
  for (double t = 0; t < seconds; t += 0.01) trace.push_back(pointer(device, Action::Hover, at, from + t));
  return trace;
}

void append(Trace& trace, const Trace& more) { trace.insert(trace.end(), more.begin(), more.end()); }

/// Rounded to whole pixels, and only every n-th move.
Trace mouse_copy(const Trace& pen, std::size_t every) {
  Trace copy;
  for (std::size_t i = 0; i < pen.size(); ++i) {
    const bool is_move = pen[i].action == Action::Move || pen[i].action == Action::Hover;
    if (pen[i].action == Action::ProximityIn || pen[i].action == Action::ProximityOut) continue;
    if (is_move && i % every != 0) continue;
    copy.push_back(pen[i]);
    copy.back().device = Device::Mouse;
    copy.back().pressure = 0;
    copy.back().position = pen[i].position.array().round();
  }
  return copy;
}

DriverTrace with_proximity(std::size_t points, double start) {
  DriverTrace driver{"proximity, hovering and a copy of everything", {}, {}, points};
  driver.pen = {pointer(Device::Pen, Action::ProximityIn, place(0), start - 0.1)};
  append(driver.pen, hovering(start - 0.09, 0.08, place(0), Device::Pen));
  append(driver.pen, touching(Device::Pen, points, start));
  const double end = when(start, points);
  append(driver.pen, hovering(end + 0.01, 0.05, place(points - 1), Device::Pen));
  driver.pen.push_back(pointer(Device::Pen, Action::ProximityOut, place(points - 1), end + 0.07));
  driver.mouse = mouse_copy(driver.pen, 1);
  return driver;
}

DriverTrace without_proximity(std::size_t points, double start) {
  DriverTrace driver{"no proximity, compressed copies", touching(Device::Pen, points, start), {}, points};
  driver.mouse = mouse_copy(driver.pen, 5);
  return driver;
}

/// Pressure comes late, the tip's button only with the press, and a last event with pressure after the release.
DriverTrace careless(std::size_t points, double start) {
  DriverTrace driver{"late pressure, missing buttons", touching(Device::Pen, points, start), {}, points};
  for (std::size_t i = 0; i < 4; ++i) driver.pen[i].pressure = 0;
  for (std::size_t i = 4; i < points; ++i) driver.pen[i].buttons.left = false;
  PointerEvent rebound = driver.pen[points - 1];
  rebound.time = when(start, points) + 0.004;
  driver.pen.push_back(rebound);
  driver.mouse = mouse_copy(driver.pen, 3);
  std::erase_if(driver.mouse,
                [](const PointerEvent& event) { return event.action == Action::Move && !event.buttons.left; });
  return driver;
}

DriverTrace mouse_only(std::size_t points, double start) {
  return {"mouse only", {}, touching(Device::Mouse, points, start), points};
}

/// The eraser bit flips on the way, sight of the pen is lost twice, and every seventh event comes twice.
DriverTrace flickering(std::size_t points, double start) {
  DriverTrace driver{"flickering tool and doubled events", {}, {}, points};
  const Trace clean = touching(Device::Pen, points, start);
  for (std::size_t i = 0; i < clean.size(); ++i) {
    driver.pen.push_back(clean[i]);
    if (i % 5 == 3) driver.pen.back().device = Device::Eraser;
    if (i % 7 == 0) driver.pen.push_back(driver.pen.back());
    if (i == points / 3 || i == points / 2) {
      driver.pen.push_back(pointer(Device::Pen, Action::ProximityOut, clean[i].position, clean[i].time));
      driver.pen.push_back(pointer(Device::Eraser, Action::ProximityIn, clean[i].position, clean[i].time));
    }
  }
  driver.mouse = mouse_copy(clean, 2);
  return driver;
}

DriverTrace press_lost(std::size_t points, double start) {
  DriverTrace driver{"the press is lost", touching(Device::Pen, points, start), {}, points};
  driver.pen.front().action = Action::Move;
  driver.mouse = mouse_copy(touching(Device::Pen, points, start), 4);
  return driver;
}

}  // namespace

PointerEvent pointer(Device device, Action action, const Vec2& position, double time) {
  PointerEvent event;
  event.device = device;
  event.action = action;
  event.position = position;
  event.time = time;
  return event;
}

std::vector<DriverTrace> driver_traces(std::size_t points, double start) {
  return {with_proximity(points, start), without_proximity(points, start), careless(points, start),
          mouse_only(points, start),     flickering(points, start),        press_lost(points, start)};
}

Trace interleaved(const DriverTrace& driver, double seconds, Random& random) {
  const double mouse_delay = random.between(-seconds, seconds);
  Trace mixed;
  std::size_t pen = 0;
  std::size_t mouse = 0;
  while (pen < driver.pen.size() || mouse < driver.mouse.size()) {
    const double jitter = random.between(-0.3, 0.3) * seconds;
    const bool take_pen =
        mouse == driver.mouse.size() ||
        (pen < driver.pen.size() && driver.pen[pen].time < driver.mouse[mouse].time + mouse_delay + jitter);
    mixed.push_back(take_pen ? driver.pen[pen++] : driver.mouse[mouse++]);
  }
  return mixed;
}

}  // namespace croquis::test
