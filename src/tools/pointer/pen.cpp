// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/pointer/pen.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace croquis {
namespace {

using Action = PointerEvent::Action;
using Steps = std::vector<PenStep>;

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

bool down(const PenState& pen) { return pen.phase != PenState::Phase::Idle; }
bool pen_draws(const PenState& pen) { return down(pen) && is_pen(pen.owner.device); }
bool mouse_draws(const PenState& pen) { return down(pen) && !is_pen(pen.owner.device); }
bool ended_by_pen(const PenState& pen) { return !down(pen) && !pen.samples.empty() && is_pen(pen.owner.device); }

// ---- Copies of events

void note_pen(PenState& pen, const PointerEvent& event) {
  pen.pen_seen = event.time;
  std::erase_if(pen.trail,
                [&](const PenSample& sample) { return std::abs(sample.time - event.time) > pen.options.twin_seconds; });
  if (event.action != Action::ProximityIn && event.action != Action::ProximityOut)
    pen.trail.push_back({event.position, 0, Vec2::Zero(), event.time});
}

bool is_repeated_press(const PenState& pen, const PointerEvent& event) {
  const bool late = !is_after(event.time, pen.samples.back().time);
  const bool again = std::abs(event.time - pen.samples.front().time) <= pen.options.rebound_seconds &&
                     (event.position - pen.samples.front().position).norm() <= repeated_press_pixels;
  return late || again;
}

bool is_copy_of_pen(const PenState& pen, const PointerEvent& event) {
  const bool by_pen = !pen.samples.empty() && is_pen(pen.owner.device);
  const bool near_stroke = by_pen && is_near(pen.samples, event.position, pen.options.twin_pixels);
  // Copies keep the time of what they copy, and may come after the whole stroke.
  const double since = near_stroke ? std::min(pen.pen_seen, pen.samples.front().time) : pen.pen_seen;
  const bool recent =
      event.time >= since - pen.options.twin_seconds && event.time <= pen.pen_seen + pen.options.twin_seconds;
  // Two devices don't draw at once, and a pen held still sends nothing: while it touches either reason is enough.
  if (pen_draws(pen)) return recent || (pen.samples.back().position - event.position).norm() <= pen.options.twin_pixels;
  return recent && (near_stroke || is_near(pen.trail, event.position, pen.options.twin_pixels));
}

bool is_twin_of_mouse_stroke(const PenState& pen, const PointerEvent& event) {
  if (pen.samples.empty() || is_pen(pen.owner.device)) return false;
  const double last = down(pen) ? pen.samples.back().time : pen.ended;
  return event.time >= pen.samples.front().time - pen.options.twin_seconds &&
         event.time <= last + pen.options.twin_seconds && is_near(pen.samples, event.position, pen.options.twin_pixels);
}

// ---- The stroke

void report_waiting(PenState& pen, double pressure, Steps& steps) {
  pen.phase = PenState::Phase::Drawing;
  for (std::size_t i = 0; i < pen.samples.size(); ++i) {
    pen.samples[i].pressure = pressure;
    steps.push_back(step_at(pen.owner, i == 0 ? PenStep::Kind::Begin : PenStep::Kind::Sample, pen.samples[i]));
  }
}

void begin(PenState& pen, const PointerEvent& event, Steps& steps) {
  const bool erases = event.device == PointerEvent::Device::Eraser && pen.options.eraser_erases;
  const bool right = !is_pen(event.device) && event.buttons.right;
  pen.owner = {PenStep::Kind::Begin, {}, event.device, erases, right, event.view, event.modifiers};
  pen.samples = {sample_of(event, pen.options)};
  pen.lost_since.reset();
  if (is_pen(event.device)) pen.pen_touches = true;
  pen.has_pressure = pen.samples.front().pressure > 0;
  pen.phase = pen.has_pressure ? PenState::Phase::Drawing : PenState::Phase::Waiting;
  if (pen.has_pressure) steps.push_back(step_at(pen.owner, PenStep::Kind::Begin, pen.samples.front()));
}

void extend(PenState& pen, const PointerEvent& event, Steps& steps) {
  PenSample sample = sample_of(event, pen.options);
  const PenSample& last = pen.samples.back();
  const bool repeats = sample.time == last.time && sample.position == last.position;
  if (pen.phase == PenState::Phase::Waiting && sample.pressure > 0) {
    pen.has_pressure = true;
    report_waiting(pen, sample.pressure, steps);
  }
  if (repeats || is_late(sample.time, pen.samples.back().time)) return;
  if (pen.phase == PenState::Phase::Drawing) {
    pen.has_pressure = pen.has_pressure || sample.pressure > 0;
    if (!pen.has_pressure) sample.pressure = 1;
    steps.push_back(step_at(pen.owner, PenStep::Kind::Sample, sample));
  }
  pen.samples.push_back(sample);
  if (pen.phase == PenState::Phase::Waiting && sample.time - pen.samples.front().time > pen.options.pressure_seconds)
    report_waiting(pen, 1, steps);
}

void finish(PenState& pen, PenStep::Kind kind, double time, Steps& steps) {
  if (pen.phase == PenState::Phase::Waiting && kind == PenStep::Kind::End) report_waiting(pen, 1, steps);
  if (pen.phase == PenState::Phase::Drawing) steps.push_back(step_at(pen.owner, kind, pen.samples.back()));
  pen.phase = PenState::Phase::Idle;
  pen.lost_since.reset();
  pen.ended = std::max(time, pen.samples.back().time);
}

// ---- Mouse

bool draws_alone(const PenState& pen, const Buttons& buttons) {
  return buttons.left ? !buttons.middle && !buttons.right : pen.options.right_draws && buttons.right && !buttons.middle;
}

void mouse_event(PenState& pen, const PointerEvent& event, Steps& steps);

void release_suspects(PenState& pen, Steps& steps) {
  const std::vector<PointerEvent> events = std::exchange(pen.suspects, {});
  begin(pen, events.front(), steps);
  for (auto event = events.begin() + 1; event != events.end(); ++event) mouse_event(pen, *event, steps);
}

/// The pen hovers here, but presses come by mouse alone: its driver may leave contact to the mouse, or be late.
void mouse_suspect(PenState& pen, const PointerEvent& event, Steps& steps) {
  pen.suspects.push_back(event);
  const bool waited = event.time - pen.suspects.front().time > pen.options.twin_seconds;
  if (waited || !event.buttons.left) release_suspects(pen, steps);
}

void mouse_press(PenState& pen, const PointerEvent& event, Steps& steps) {
  if (!draws_alone(pen, event.buttons)) return;
  if (mouse_draws(pen) && is_repeated_press(pen, event)) return;
  pen.mouse_muted = is_copy_of_pen(pen, event) && (pen.pen_touches || pen_draws(pen));
  if (pen.mouse_muted) return;
  pen.suspects.clear();
  if (down(pen)) finish(pen, PenStep::Kind::End, event.time, steps);
  if (is_copy_of_pen(pen, event) && event.buttons.left) {
    pen.suspects.push_back(event);
  } else {
    begin(pen, event, steps);
  }
}

void mouse_event(PenState& pen, const PointerEvent& event, Steps& steps) {
  if (event.action == Action::Press) {
    mouse_press(pen, event, steps);
    return;
  }
  const bool lifted = mouse_draws(pen) && pen.owner.right ? !event.buttons.right : !event.buttons.left;
  if (pen.mouse_muted) {
    pen.mouse_muted = !lifted;
  } else if (!pen.suspects.empty()) {
    mouse_suspect(pen, event, steps);
  } else if (mouse_draws(pen)) {
    const bool moved = event.position != pen.samples.back().position;
    if (event.action == Action::Move ? !lifted : event.action == Action::Release && moved) extend(pen, event, steps);
    if (lifted) finish(pen, PenStep::Kind::End, event.time, steps);
  }
}

// ---- Pen

void pen_press(PenState& pen, const PointerEvent& event, Steps& steps) {
  const bool other_button = event.buttons.barrel || event.buttons.right || event.buttons.middle;
  if (pen_draws(pen) && (other_button || is_repeated_press(pen, event))) {
    extend(pen, event, steps);
    return;
  }
  if (ended_by_pen(pen) && !is_after(event.time, pen.ended)) return;
  pen.pen_muted = other_button || (!down(pen) && is_twin_of_mouse_stroke(pen, event));
  if (pen.pen_muted) return;
  if (mouse_draws(pen) || !pen.suspects.empty()) pen.mouse_muted = true;
  pen.suspects.clear();
  if (down(pen)) {
    const bool takes_over = mouse_draws(pen) && is_twin_of_mouse_stroke(pen, event);
    finish(pen, takes_over ? PenStep::Kind::Cancel : PenStep::Kind::End, event.time, steps);
  }
  begin(pen, event, steps);
}

void pen_moved_touching(PenState& pen, const PointerEvent& event, Steps& steps) {
  if (pen.pen_muted) return;
  if (pen_draws(pen)) {
    pen.lost_since.reset();
    extend(pen, event, steps);
    return;
  }
  const bool rebounds = ended_by_pen(pen) && !is_after(event.time, pen.ended + pen.options.rebound_seconds);
  if (!rebounds && (!down(pen) || is_twin_of_mouse_stroke(pen, event))) pen_press(pen, event, steps);
}

void pen_lifted(PenState& pen, const PointerEvent& event, Steps& steps) {
  if (event.action == Action::Release && event.buttons.left) return;  // only the side switch was let go
  const bool released = event.action == Action::Release;
  if (pen_draws(pen) && is_late(event.time, released ? pen.samples.front().time : pen.samples.back().time)) return;
  pen.pen_muted = false;
  if (!pen_draws(pen)) return;
  if (released && event.position != pen.samples.back().position) extend(pen, event, steps);
  finish(pen, PenStep::Kind::End, event.time, steps);
}

void pen_event(PenState& pen, const PointerEvent& event, Steps& steps) {
  note_pen(pen, event);
  if (event.action == Action::ProximityOut) {
    if (pen_draws(pen) && !pen.lost_since) pen.lost_since = event.time;
  } else if (touches(event)) {
    if (event.action == Action::Press) {
      pen_press(pen, event, steps);
    } else {
      pen_moved_touching(pen, event, steps);
    }
  } else if (event.action != Action::ProximityIn) {
    pen_lifted(pen, event, steps);
  }
}

// ---- Losing sight of it

void end_if_lost(PenState& pen, double now, Steps& steps) {
  if (pen.lost_since && down(pen) && now - *pen.lost_since > pen.options.twin_seconds)
    finish(pen, PenStep::Kind::End, *pen.lost_since, steps);
}

void left_view(PenState& pen, const PointerEvent& event, Steps& steps) {
  if (!pen.suspects.empty()) release_suspects(pen, steps);
  if (down(pen) && event.view != pen.owner.view) return;
  if (mouse_draws(pen) && !is_pen(event.device)) finish(pen, PenStep::Kind::End, event.time, steps);
  if (!pen_draws(pen)) return;
  if (is_pen(event.device) || event.time - pen.pen_seen >= pen.options.twin_seconds) {
    finish(pen, PenStep::Kind::End, event.time, steps);
    pen.pen_muted = true;
  } else if (!pen.lost_since) {
    pen.lost_since = event.time;
  }
}

}  // namespace

std::vector<PenStep> PenInput::handle(const PointerEvent& event) {
  Steps steps;
  if (event.device == PointerEvent::Device::Touch || event.action == Action::Wheel) return steps;
  end_if_lost(state_, event.time, steps);
  if (event.action == Action::Leave) {
    left_view(state_, event, steps);
  } else if (is_pen(event.device)) {
    pen_event(state_, event, steps);
  } else {
    mouse_event(state_, event, steps);
  }
  return steps;
}

std::vector<PenStep> PenInput::settle(double now) {
  Steps steps;
  end_if_lost(state_, now, steps);
  if (state_.phase == PenState::Phase::Waiting && now - state_.samples.front().time > state_.options.pressure_seconds)
    report_waiting(state_, 1, steps);
  if (!state_.suspects.empty() && now - state_.suspects.front().time > state_.options.twin_seconds)
    release_suspects(state_, steps);
  return steps;
}

std::vector<PenStep> PenInput::cancel() {
  Steps steps;
  if (!state_.suspects.empty() || mouse_draws(state_)) state_.mouse_muted = true;
  state_.suspects.clear();
  if (!down()) return steps;
  state_.pen_muted = state_.pen_muted || pen_draws(state_);
  finish(state_, PenStep::Kind::Cancel, state_.samples.back().time, steps);
  return steps;
}

}  // namespace croquis
