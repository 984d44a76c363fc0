// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/pointer/navigation.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace croquis {
namespace {

using Device = PointerEvent::Device;
using Action = PointerEvent::Action;
using Kind = CameraMotion::Kind;

/// Pixels. Fingers nearer than this to each other give no meaningful spread.
constexpr double smallest_spread = 10;

std::optional<Kind> alt_binding(const Buttons& buttons) {
  if (buttons.right) return Kind::Dolly;
  if (buttons.middle) return Kind::Track;
  if (buttons.left) return Kind::Tumble;
  return std::nullopt;
}

Kind middle_binding(NavigationPreset preset, const Modifiers& modifiers) {
  const bool blender = preset == NavigationPreset::Blender;
  if (modifiers.shift) return blender ? Kind::Track : Kind::Dolly;
  if (modifiers.ctrl) return blender ? Kind::Dolly : Kind::Track;
  return Kind::Tumble;
}

Kind barrel_binding(const Modifiers& modifiers) {
  if (modifiers.shift) return Kind::Track;
  return modifiers.ctrl ? Kind::Dolly : Kind::Tumble;
}

}  // namespace

Navigation::Answer Navigation::handle(const PointerEvent& event) {
  note_alt(event);
  if (event.action == Action::Wheel) return wheel(event);
  if (event.device == Device::Touch) return touch(event);
  if (is_pen(event.device)) {
    pen_seen_ = event.time;
    pen_down_ = event.buttons.any() || (event.action == Action::Move && event.pressure > 0);
    if (pen_down_) {
      for (auto& [id, finger] : fingers_) finger.palm = true;
    }
  }
  return mouse_or_pen(event);
}

bool Navigation::active() const {
  const auto fingers = std::count_if(fingers_.begin(), fingers_.end(), [](const auto& f) { return !f.second.palm; });
  return drag_.has_value() || fingers == 2;
}

void Navigation::set_flat(int view, bool flat) {
  if (flat) {
    flat_views_.insert(view);
  } else {
    flat_views_.erase(view);
  }
}

// ---- Buttons

Navigation::Answer Navigation::mouse_or_pen(const PointerEvent& event) {
  if (drag_) return drag_on(event);
  if (twin_muted_ && event.device == Device::Mouse) {
    twin_muted_ = event.action != Action::Press && event.buttons.any();
    return {true, std::nullopt, std::nullopt};
  }
  const std::optional<Kind> kind = event.action == Action::Press ? binding(event) : std::nullopt;
  if (!kind) return {};
  drag_ = Drag{in_view(*kind, event.view), event.device, event.position, event.position, event.view};
  return {true, std::nullopt, std::nullopt};
}

std::optional<Kind> Navigation::binding(const PointerEvent& event) const {
  if (event.modifiers.alt || event.modifiers.super || twin_key_) return alt_binding(event.buttons);
  if (is_pen(event.device) && event.buttons.barrel) return barrel_binding(event.modifiers);
  if (options_.preset != NavigationPreset::Maya && event.buttons.middle)
    return middle_binding(options_.preset, event.modifiers);
  return std::nullopt;
}

Navigation::Answer Navigation::drag_on(const PointerEvent& event) {
  Answer answer{true, std::nullopt, std::nullopt};
  const bool own = event.device == drag_->device || (is_pen(event.device) && is_pen(drag_->device));
  if (!own) {
    // Mouse events while a pen drags are its copies: they stay muted until their buttons are up.
    if (event.device == Device::Mouse) twin_muted_ = event.buttons.any();
    return answer;
  }
  if (event.action == Action::ProximityIn || event.action == Action::ProximityOut) return answer;
  // When one button is released while another is pressed the drag goes on; it ends when none is pressed.
  const bool ends = event.action == Action::Leave || event.action == Action::Hover || !event.buttons.any();
  if (event.action != Action::Leave && event.action != Action::Press && event.position != drag_->last) {
    const Vec2 delta = event.position - drag_->last;
    drag_->last = event.position;
    const double nearer = options_.dolly_per_pixel * (delta.x() - delta.y());
    const double factor = drag_->kind == Kind::Dolly ? std::exp(nearer) : 1;
    answer.motion = CameraMotion{drag_->kind, delta, factor, drag_->start, drag_->view};
  }
  if (ends) drag_.reset();
  return answer;
}

Navigation::Answer Navigation::wheel(const PointerEvent& event) const {
  const double factor = std::exp(options_.dolly_per_notch * event.wheel);
  return {true, CameraMotion{Kind::Dolly, Vec2::Zero(), factor, event.position, event.view}, std::nullopt};
}

Kind Navigation::in_view(Kind kind, int view) const {
  return kind == Kind::Tumble && flat_views_.contains(view) ? Kind::Track : kind;
}

// ---- Fingers

Navigation::Answer Navigation::touch(const PointerEvent& event) {
  Answer answer{true, std::nullopt, std::nullopt};
  if (event.action == Action::Press) {
    const bool palm = pen_down_ || std::abs(event.time - pen_seen_) < options_.palm_seconds;
    fingers_[event.device_id] = {event.position, palm};
  } else if (event.action != Action::Move) {
    fingers_.erase(event.device_id);
    if (event.action == Action::Leave) fingers_.clear();
  } else if (const auto finger = fingers_.find(event.device_id); finger != fingers_.end()) {
    if (!finger->second.palm && active() && !drag_) answer = pinch(finger->second, event.position, event.view);
    finger->second.at = event.position;
  }
  return answer;
}

Navigation::Answer Navigation::pinch(Finger& moved, const Vec2& to, int view) {
  const auto other = std::find_if(fingers_.begin(), fingers_.end(),
                                  [&](const auto& entry) { return !entry.second.palm && &entry.second != &moved; });
  const Vec2& still = other->second.at;
  const Vec2 middle = (still + to) / 2;
  Answer answer{true, CameraMotion{Kind::Track, (to - moved.at) / 2, 1, middle, view}, std::nullopt};
  const double before = std::max((moved.at - still).norm(), smallest_spread);
  const double factor = std::max((to - still).norm(), smallest_spread) / before;
  if (factor != 1) answer.second = CameraMotion{Kind::Dolly, Vec2::Zero(), factor, middle, view};
  return answer;
}

// ---- Alt

void Navigation::modifiers_changed(const Modifiers& now) {
  if (now.alt && !alt_held_) pressed_with_alt_ = false;
  alt_held_ = now.alt;
}

void Navigation::window_moved() {
  if (alt_held_ && !pressed_with_alt_) alt_swallowed_ = true;
}

void Navigation::note_alt(const PointerEvent& event) {
  if (event.action == Action::Press || event.action == Action::Wheel) alt_swallowed_ = false;
  // Touch events have no modifiers, and leave events report none.
  if (event.device == Device::Touch || event.action == Action::Leave) return;
  if (!event.modifiers.alt) alt_held_ = false;
  if (event.action == Action::Press && event.modifiers.alt) pressed_with_alt_ = true;
}

}  // namespace croquis
