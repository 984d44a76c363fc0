// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "croquis/base/described.h"
#include "croquis/base/progress.h"

namespace croquis::cli {

/// How long one step of a command took.
struct StageTime {
  std::string name;
  double seconds = 0;
};
inline auto described(const StageTime& stage) {
  return fields(named("name", stage.name), named("seconds", stage.seconds));
}
static_assert(describes_every_member<StageTime>);

/// Shows progress on standard error and keeps the time of every step.
class ProgressDisplay {
 public:
  enum class Style { None, Line, Json };

  /// @param choice "auto" (a line when standard error is a terminal), "none" or "json"
  ProgressDisplay(const std::string& choice, bool quiet);

  /// Removes an unfinished line.
  ~ProgressDisplay();

  ProgressDisplay(const ProgressDisplay&) = delete;
  ProgressDisplay& operator=(const ProgressDisplay&) = delete;

  /// The sink of a Progress. The display must outlive it.
  Progress::Sink sink();

  /// The steps in the order of their first report, with the time until the next step began; ends the last one.
  std::vector<StageTime> stages();

 private:
  using Clock = std::chrono::steady_clock;

  void update(double fraction, const std::string& step);
  void charge_step();
  void clear_line();

  Style style_ = Style::None;
  bool line_shown_ = false;
  int shown_percent_ = -1;
  std::string step_;
  Clock::time_point step_began_ = Clock::now();
  std::vector<StageTime> stages_;
};

}  // namespace croquis::cli
