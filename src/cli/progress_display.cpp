// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/progress_display.h"

#include <algorithm>
#include <cstdio>
#include <string_view>

#include <unistd.h>

namespace croquis::cli {
namespace {

bool is_number(std::string_view word) {
  return !word.empty() && word.find_first_not_of("0123456789") == std::string_view::npos;
}

/// A step's name without the count behind it: "make patches" of "make patches 12 of 40".
std::string_view uncounted(std::string_view step) {
  const std::size_t of = step.rfind(" of ");
  if (of == std::string_view::npos || !is_number(step.substr(of + 4))) return step;
  const std::size_t blank = step.find_last_of(' ', of - 1);
  const bool is_counted =
      of > 0 && blank != std::string_view::npos && is_number(step.substr(blank + 1, of - blank - 1));
  return is_counted ? step.substr(0, blank) : step;
}

}  // namespace

ProgressDisplay::ProgressDisplay(const std::string& choice, bool quiet) {
  if (choice == "json") {
    style_ = Style::Json;
  } else if (choice == "auto" && !quiet && isatty(STDERR_FILENO) != 0) {
    style_ = Style::Line;
  }
}

ProgressDisplay::~ProgressDisplay() { clear_line(); }

Progress::Sink ProgressDisplay::sink() {
  return [this](double fraction, const std::string& step) { update(fraction, step); };
}

std::vector<StageTime> ProgressDisplay::stages() {
  charge_step();
  step_.clear();
  return stages_;
}

void ProgressDisplay::charge_step() {
  const Clock::time_point now = Clock::now();
  const double seconds = std::chrono::duration<double>(now - step_began_).count();
  step_began_ = now;
  if (step_.empty()) return;
  const std::string_view name = uncounted(step_);
  const auto known =
      std::find_if(stages_.begin(), stages_.end(), [name](const StageTime& stage) { return stage.name == name; });
  if (known == stages_.end()) {
    stages_.push_back({std::string(name), seconds});
  } else {
    known->seconds += seconds;
  }
}

void ProgressDisplay::update(double fraction, const std::string& step) {
  const bool new_step = step != step_;
  if (new_step) {
    charge_step();
    step_ = step;
  }
  const int percent = static_cast<int>(fraction * 100);
  if (style_ == Style::None || (!new_step && percent == shown_percent_)) return;
  shown_percent_ = percent;
  if (style_ == Style::Json) {
    std::fprintf(stderr, "{\"progress\":%.3f,\"step\":\"%s\"}\n", fraction, step.c_str());
  } else {
    std::fprintf(stderr, "\r\033[K%3d %% %s", percent, step.c_str());
    line_shown_ = true;
  }
  std::fflush(stderr);
}

void ProgressDisplay::clear_line() {
  if (line_shown_) std::fputs("\r\033[K", stderr);
  line_shown_ = false;
}

}  // namespace croquis::cli
