// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/event_clock.h"

#include <algorithm>

namespace croquis::app {
namespace {

/// No window is this late: the stamps' clock was reset (X servers count 49 days).
constexpr double clock_jump_seconds = 60;

/// By which the least difference is forgotten with every event: two clocks never run exactly alike.
constexpr double drift_seconds = 1e-5;

}  // namespace

double EventClock::time_of(std::uint64_t stamp, double now) {
  if (stamp == 0) {
    time_ += now - taken_;
    lag_ = 0;
  } else {
    time_ = static_cast<double>(stamp) * 1e-3;
    const double difference = now - time_;
    if (!quickest_ || difference - *quickest_ > clock_jump_seconds) quickest_ = difference;
    quickest_ = std::min(*quickest_ + drift_seconds, difference);
    lag_ = difference - *quickest_;
  }
  taken_ = now;
  return time_;
}

}  // namespace croquis::app
