// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "croquis/tools/pointer/pointer_event.h"
#include "support/random.h"

/// Event traces as tablet drivers send them.
namespace croquis::test {

using Trace = std::vector<PointerEvent>;

struct DriverTrace {
  std::string name;
  Trace pen;           ///< in the order sent; empty for a driver that speaks as a mouse only
  Trace mouse;         ///< the driver's mouse copies; empty for none
  std::size_t points;  ///< distinct samples from touch to lift
};

PointerEvent pointer(PointerEvent::Device device, PointerEvent::Action action, const Vec2& position, double time);

/// One stroke of `points` samples at 300 Hz beginning at `start`, as six kinds of drivers report it.
std::vector<DriverTrace> driver_traces(std::size_t points, double start);

/// Both sequences, each in its own order, mixed at random with delays up to `seconds` of the mouse's or the pen's.
Trace interleaved(const DriverTrace& driver, double seconds, Random& random);

}  // namespace croquis::test
