// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/pointer/pen.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace croquis {
namespace {

using Action = PointerEvent::Action;

/// Events older than this against the last one come from a clock that was set back, not from a late driver.
constexpr double clock_jump_seconds = 1;

/// A press repeated by the driver is at the same place up to rounding.
constexpr double repeated_press_pixels = 2;

bool is_late(double time, double reference) { return time < reference && time > reference - clock_jump_seconds; }

bool is_after(double time, double reference) { return time > reference || time <= reference - clock_jump_seconds; }

bool is_near(const std::vector<PenSample>& samples, const Vec2& place, double distance) {
  return std::any_of(samples.begin(), samples.end(),
                     [&](const PenSample& sample) { return (sample.position - place).norm() <= distance; });
}

/// The tip is on the tablet. Some drivers leave out the button, some the pressure.
bool touches(const PointerEvent& event) {
  if (event.action != Action::Press && event.action != Action::Move) return false;
  const bool bare_press = event.action == Action::Press && !event.buttons.any();
  return event.buttons.left || event.pressure > 0 || bare_press;
}

PenSample sample_of(const PointerEvent& event, const PenOptions& options) {
  if (!is_pen(event.device)) return {event.position, 1, event.tilt, event.time};
  const double pressure = std::clamp(std::isfinite(event.pressure) ? event.pressure : 0.0, 0.0, 1.0);
  return {event.position, std::pow(pressure, options.pressure_gamma), event.tilt, event.time};
}

/// A step of the owner's stroke.
PenStep step_at(const PenStep& owner, PenStep::Kind kind, const PenSample& sample) {
  PenStep step = owner;
  step.kind = kind;
  step.sample = sample;
  return step;
}

}  // namespace

std::vector<PenStep> PenInput::handle(const PointerEvent& event) {
  Steps steps;
  if (event.device == PointerEvent::Device::Touch || event.action == Action::Wheel) return steps;
  end_if_lost(event.time, steps);
  if (event.action == Action::Leave) {
    left_view(event, steps);
  } else if (is_pen(event.device)) {
    pen_event(event, steps);
  } else {
    mouse_event(event, steps);
  }
  return steps;
}

std::vector<PenStep> PenInput::settle(double now) {
  Steps steps;
  end_if_lost(now, steps);
  if (phase_ == Phase::Waiting && now - samples_.front().time > options_.pressure_seconds) report_waiting(1, steps);
  if (!suspects_.empty() && now - suspects_.front().time > options_.twin_seconds) release_suspects(steps);
  return steps;
}

std::vector<PenStep> PenInput::cancel() {
  Steps steps;
  if (!suspects_.empty() || mouse_draws()) mouse_muted_ = true;
  suspects_.clear();
  if (!down()) return steps;
  pen_muted_ = pen_muted_ || pen_draws();
  finish(PenStep::Kind::Cancel, samples_.back().time, steps);
  return steps;
}

void PenInput::end_if_lost(double now, Steps& steps) {
  if (lost_since_ && down() && now - *lost_since_ > options_.twin_seconds)
    finish(PenStep::Kind::End, *lost_since_, steps);
}

void PenInput::left_view(const PointerEvent& event, Steps& steps) {
  if (!suspects_.empty()) release_suspects(steps);
  if (down() && event.view != owner_.view) return;
  if (mouse_draws() && !is_pen(event.device)) finish(PenStep::Kind::End, event.time, steps);
  if (!pen_draws()) return;
  if (is_pen(event.device) || event.time - pen_seen_ >= options_.twin_seconds) {
    finish(PenStep::Kind::End, event.time, steps);
    pen_muted_ = true;
  } else if (!lost_since_) {
    lost_since_ = event.time;
  }
}

// ---- Pen

void PenInput::pen_event(const PointerEvent& event, Steps& steps) {
  note_pen(event);
  if (event.action == Action::ProximityOut) {
    if (pen_draws() && !lost_since_) lost_since_ = event.time;
  } else if (touches(event)) {
    if (event.action == Action::Press) {
      pen_press(event, steps);
    } else {
      pen_moved_touching(event, steps);
    }
  } else if (event.action != Action::ProximityIn) {
    pen_lifted(event, steps);
  }
}

void PenInput::pen_press(const PointerEvent& event, Steps& steps) {
  const bool other_button = event.buttons.barrel || event.buttons.right || event.buttons.middle;
  if (pen_draws() && (other_button || is_repeated_press(event))) {
    extend(event, steps);
    return;
  }
  if (ended_by_pen() && !is_after(event.time, ended_)) return;
  pen_muted_ = other_button || (!down() && is_twin_of_mouse_stroke(event));
  if (pen_muted_) return;
  if (mouse_draws() || !suspects_.empty()) mouse_muted_ = true;
  suspects_.clear();
  if (down()) {
    const bool takes_over = mouse_draws() && is_twin_of_mouse_stroke(event);
    finish(takes_over ? PenStep::Kind::Cancel : PenStep::Kind::End, event.time, steps);
  }
  begin(event, steps);
}

void PenInput::pen_moved_touching(const PointerEvent& event, Steps& steps) {
  if (pen_muted_) return;
  if (pen_draws()) {
    lost_since_.reset();
    extend(event, steps);
    return;
  }
  const bool rebounds = ended_by_pen() && !is_after(event.time, ended_ + options_.rebound_seconds);
  if (!rebounds && (!down() || is_twin_of_mouse_stroke(event))) pen_press(event, steps);
}

void PenInput::pen_lifted(const PointerEvent& event, Steps& steps) {
  if (event.action == Action::Release && event.buttons.left) return;  // only the side switch was let go
  const bool released = event.action == Action::Release;
  if (pen_draws() && is_late(event.time, released ? samples_.front().time : samples_.back().time)) return;
  pen_muted_ = false;
  if (!pen_draws()) return;
  if (released && event.position != samples_.back().position) extend(event, steps);
  finish(PenStep::Kind::End, event.time, steps);
}

// ---- Mouse

bool PenInput::draws_alone(const Buttons& buttons) const {
  return buttons.left ? !buttons.middle && !buttons.right : options_.right_draws && buttons.right && !buttons.middle;
}

void PenInput::mouse_event(const PointerEvent& event, Steps& steps) {
  if (event.action == Action::Press) {
    mouse_press(event, steps);
    return;
  }
  const bool lifted = mouse_draws() && owner_.right ? !event.buttons.right : !event.buttons.left;
  if (mouse_muted_) {
    mouse_muted_ = !lifted;
  } else if (!suspects_.empty()) {
    mouse_suspect(event, steps);
  } else if (mouse_draws()) {
    const bool moved = event.position != samples_.back().position;
    if (event.action == Action::Move ? !lifted : event.action == Action::Release && moved) extend(event, steps);
    if (lifted) finish(PenStep::Kind::End, event.time, steps);
  }
}

void PenInput::mouse_press(const PointerEvent& event, Steps& steps) {
  if (!draws_alone(event.buttons)) return;
  if (mouse_draws() && is_repeated_press(event)) return;
  mouse_muted_ = is_copy_of_pen(event) && (pen_touches_ || pen_draws());
  if (mouse_muted_) return;
  suspects_.clear();
  if (down()) finish(PenStep::Kind::End, event.time, steps);
  if (is_copy_of_pen(event) && event.buttons.left) {
    suspects_.push_back(event);
  } else {
    begin(event, steps);
  }
}

/// The pen hovers here, but presses come by mouse alone: its driver may leave contact to the mouse, or be late.
void PenInput::mouse_suspect(const PointerEvent& event, Steps& steps) {
  suspects_.push_back(event);
  const bool waited = event.time - suspects_.front().time > options_.twin_seconds;
  if (waited || !event.buttons.left) release_suspects(steps);
}

void PenInput::release_suspects(Steps& steps) {
  const std::vector<PointerEvent> events = std::exchange(suspects_, {});
  begin(events.front(), steps);
  for (auto event = events.begin() + 1; event != events.end(); ++event) mouse_event(*event, steps);
}

// ---- The stroke

void PenInput::begin(const PointerEvent& event, Steps& steps) {
  const bool erases = event.device == PointerEvent::Device::Eraser && options_.eraser_erases;
  const bool right = !is_pen(event.device) && event.buttons.right;
  owner_ = {PenStep::Kind::Begin, {}, event.device, erases, right, event.view, event.modifiers};
  samples_ = {sample_of(event, options_)};
  lost_since_.reset();
  if (is_pen(event.device)) pen_touches_ = true;
  has_pressure_ = samples_.front().pressure > 0;
  phase_ = has_pressure_ ? Phase::Drawing : Phase::Waiting;
  if (has_pressure_) steps.push_back(step_at(owner_, PenStep::Kind::Begin, samples_.front()));
}

void PenInput::extend(const PointerEvent& event, Steps& steps) {
  PenSample sample = sample_of(event, options_);
  const PenSample& last = samples_.back();
  const bool repeats = sample.time == last.time && sample.position == last.position;
  if (phase_ == Phase::Waiting && sample.pressure > 0) {
    has_pressure_ = true;
    report_waiting(sample.pressure, steps);
  }
  if (repeats || is_late(sample.time, samples_.back().time)) return;
  if (phase_ == Phase::Drawing) {
    has_pressure_ = has_pressure_ || sample.pressure > 0;
    if (!has_pressure_) sample.pressure = 1;
    steps.push_back(step_at(owner_, PenStep::Kind::Sample, sample));
  }
  samples_.push_back(sample);
  if (phase_ == Phase::Waiting && sample.time - samples_.front().time > options_.pressure_seconds)
    report_waiting(1, steps);
}

void PenInput::report_waiting(double pressure, Steps& steps) {
  phase_ = Phase::Drawing;
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    samples_[i].pressure = pressure;
    steps.push_back(step_at(owner_, i == 0 ? PenStep::Kind::Begin : PenStep::Kind::Sample, samples_[i]));
  }
}

void PenInput::finish(PenStep::Kind kind, double time, Steps& steps) {
  if (phase_ == Phase::Waiting && kind == PenStep::Kind::End) report_waiting(1, steps);
  if (phase_ == Phase::Drawing) steps.push_back(step_at(owner_, kind, samples_.back()));
  phase_ = Phase::Idle;
  lost_since_.reset();
  ended_ = std::max(time, samples_.back().time);
}

// ---- Copies of events

void PenInput::note_pen(const PointerEvent& event) {
  pen_seen_ = event.time;
  std::erase_if(trail_,
                [&](const PenSample& sample) { return std::abs(sample.time - event.time) > options_.twin_seconds; });
  if (event.action != Action::ProximityIn && event.action != Action::ProximityOut)
    trail_.push_back({event.position, 0, Vec2::Zero(), event.time});
}

bool PenInput::is_repeated_press(const PointerEvent& event) const {
  const bool late = !is_after(event.time, samples_.back().time);
  const bool again = std::abs(event.time - samples_.front().time) <= options_.rebound_seconds &&
                     (event.position - samples_.front().position).norm() <= repeated_press_pixels;
  return late || again;
}

bool PenInput::is_copy_of_pen(const PointerEvent& event) const {
  const bool by_pen = !samples_.empty() && is_pen(owner_.device);
  const bool near_stroke = by_pen && is_near(samples_, event.position, options_.twin_pixels);
  // Copies keep the time of what they copy, and may come after the whole stroke.
  const double since = near_stroke ? std::min(pen_seen_, samples_.front().time) : pen_seen_;
  const bool recent = event.time >= since - options_.twin_seconds && event.time <= pen_seen_ + options_.twin_seconds;
  // Two devices don't draw at once, and a pen held still sends nothing: while it touches either reason is enough.
  if (pen_draws()) return recent || (samples_.back().position - event.position).norm() <= options_.twin_pixels;
  return recent && (near_stroke || is_near(trail_, event.position, options_.twin_pixels));
}

bool PenInput::is_twin_of_mouse_stroke(const PointerEvent& event) const {
  if (samples_.empty() || is_pen(owner_.device)) return false;
  const double last = down() ? samples_.back().time : ended_;
  return event.time >= samples_.front().time - options_.twin_seconds && event.time <= last + options_.twin_seconds &&
         is_near(samples_, event.position, options_.twin_pixels);
}

}  // namespace croquis
