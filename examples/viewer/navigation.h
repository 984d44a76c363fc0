// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/render/camera_motion.h"
#include "window.h"

/// Turns a window's events into camera moves: drag (with or without Alt) turns, middle button or Shift moves, right
/// button or wheel comes nearer, F shows everything.
class Navigation {
 public:
  Navigation(const Window& window, std::vector<glm::dvec3> points);

  const croquis::render::Camera& camera() const { return camera_; }
  bool moving() const { return button_ >= 0; }  ///< a button is held
  bool take_change();                           ///< whether something changed since the last call

 private:
  void show_everything();
  void press(int button, bool down, int modifiers);
  void move(const glm::dvec2& place);
  void wheel(double steps);

  const Window& window_;
  std::vector<glm::dvec3> points_;  ///< of the model
  croquis::render::Camera camera_;
  glm::dvec2 place_ = glm::dvec2(0);  ///< of the pointer
  int button_ = -1;                   ///< that is held; -1 for none
  bool changed_ = true;
};
