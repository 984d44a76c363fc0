// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>

#include "croquis/tools/pointer/pointer_event.h"

namespace croquis {

/// What pointer and wheel ask a view's camera to do.
struct CameraMotion {
  enum class Kind {
    Tumble,  ///< turn about the centre of interest
    Track,   ///< shift with the pointer
    Dolly    ///< nearer or further
  };

  Kind kind = Kind::Tumble;
  Vec2 delta = Vec2::Zero();  ///< pixels since the last motion, y down
  double factor = 1;          ///< of a Dolly: how many times larger things are to appear; > 1 comes nearer
  Vec2 about = Vec2::Zero();  ///< pixels: the place that stays where it is when a flat view dollies
  int view = 0;
};

enum class NavigationPreset {
  Maya,     ///< Alt + left tumbles, + middle tracks, + right dollies
  Blender,  ///< the middle button tumbles, with Shift tracks, with Ctrl dollies
  Cad       ///< the middle button tumbles, with Ctrl tracks, with Shift dollies
};

struct NavigationOptions {
  NavigationPreset preset = NavigationPreset::Maya;  ///< the others understand Alt and its twins as well
  double dolly_per_pixel = 0.005;                    ///< a drag of d pixels right or up gives the factor exp(d × this)
  double dolly_per_notch = 0.14;                     ///< the same per notch of the wheel
  double palm_seconds = 0.5;                         ///< fingers this soon after the pen are the palm
};

/// Finds the camera's motions among raw events; feed it before the pen, which gets only what isn't taken.
///
/// Twins for desktops that keep Alt for themselves: Super, or a key held (the one left of 1), with the same buttons. A
/// pen with its side switch held tumbles, with Shift tracks, with Ctrl dollies. Two fingers track and dolly, unless a
/// pen is near. In flat views Tumble becomes Track. A drag belongs to the device that began it. Pure; O(1) per event.
class Navigation {
 public:
  struct Answer {
    bool taken = false;                  ///< nothing else may see the event
    std::optional<CameraMotion> motion;  ///< the first of at most two …
    std::optional<CameraMotion> second;  ///< … two fingers track and dolly at once
  };

  explicit Navigation(NavigationOptions options = {}) : options_(options) {}

  Answer handle(const PointerEvent& event);

  /// Whether a drag or a pair of fingers is moving a camera.
  bool active() const;

  void set_options(NavigationOptions options) { options_ = options; }
  void set_flat(int view, bool flat);
  void set_twin_key(bool held) { twin_key_ = held; }

  /// To be called for every change of the modifier keys, and when the window itself was moved.
  void modifiers_changed(const Modifiers& now);
  void window_moved();

  /// Whether the window manager seems to keep Alt and a drag for itself: the window moved while Alt was held and no
  /// press had arrived. Until the next press of whatever kind, turn of the wheel, or `something_done`. (Under Wayland
  /// windows get no events of their moves.)
  bool alt_swallowed() const { return alt_swallowed_; }

  /// By keys, menus or panels.
  void something_done() { alt_swallowed_ = false; }

 private:
  struct Drag {
    CameraMotion::Kind kind = CameraMotion::Kind::Tumble;
    PointerEvent::Device device = PointerEvent::Device::Mouse;
    Vec2 start = Vec2::Zero();
    Vec2 last = Vec2::Zero();
    int view = 0;
  };
  struct Finger {
    Vec2 at = Vec2::Zero();
    bool palm = false;
  };

  Answer mouse_or_pen(const PointerEvent& event);
  Answer touch(const PointerEvent& event);
  Answer drag_on(const PointerEvent& event);
  Answer pinch(Finger& moved, const Vec2& to, int view);
  Answer wheel(const PointerEvent& event) const;
  std::optional<CameraMotion::Kind> binding(const PointerEvent& event) const;
  CameraMotion::Kind in_view(CameraMotion::Kind kind, int view) const;
  void note_alt(const PointerEvent& event);

  NavigationOptions options_;
  std::set<int> flat_views_;
  bool twin_key_ = false;
  std::optional<Drag> drag_;
  bool twin_muted_ = false;  ///< the mouse copy of a pen's drag, until its buttons are up
  std::map<std::uint64_t, Finger> fingers_;
  bool pen_down_ = false;
  double pen_seen_ = -1e300;
  bool alt_held_ = false;
  bool pressed_with_alt_ = false;
  bool alt_swallowed_ = false;
};

}  // namespace croquis
