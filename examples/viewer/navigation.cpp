// SPDX-License-Identifier: GPL-3.0-or-later
#include "navigation.h"

#include <cmath>
#include <utility>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace {

constexpr double radians_per_pixel = 0.008;

Navigation& navigation_of(GLFWwindow* window) { return *static_cast<Navigation*>(glfwGetWindowUserPointer(window)); }

}  // namespace

Navigation::Navigation(const Window& window, std::vector<glm::dvec3> points)
    : window_(window), points_(std::move(points)) {
  GLFWwindow* handle = window.handle();
  glfwSetWindowUserPointer(handle, this);
  glfwSetMouseButtonCallback(handle, [](GLFWwindow* from, int button, int action, int modifiers) {
    navigation_of(from).press(button, action == GLFW_PRESS, modifiers);
  });
  glfwSetCursorPosCallback(handle, [](GLFWwindow* from, double x, double y) { navigation_of(from).move({x, y}); });
  glfwSetScrollCallback(handle, [](GLFWwindow* from, double, double steps) { navigation_of(from).wheel(steps); });
  glfwSetKeyCallback(handle, [](GLFWwindow* from, int key, int, int action, int) {
    if (action == GLFW_PRESS && key == GLFW_KEY_F) navigation_of(from).show_everything();
    if (action == GLFW_PRESS && key == GLFW_KEY_ESCAPE) glfwSetWindowShouldClose(from, GLFW_TRUE);
  });
  glfwSetWindowRefreshCallback(handle, [](GLFWwindow* from) { navigation_of(from).changed_ = true; });
  show_everything();
}

bool Navigation::take_change() { return std::exchange(changed_, false); }

void Navigation::show_everything() {
  using namespace croquis::render;
  const glm::dvec2 size = window_.size();
  camera_ = frame(points_, view_direction(NamedView::Perspective), size.x / size.y);
  changed_ = true;
}

void Navigation::press(int button, bool down, int modifiers) {
  if (down && button_ < 0) {
    button_ = button == GLFW_MOUSE_BUTTON_LEFT && (modifiers & GLFW_MOD_SHIFT) != 0 ? GLFW_MOUSE_BUTTON_MIDDLE : button;
  } else if (!down) {
    button_ = -1;
  }
  changed_ = true;
}

void Navigation::move(const glm::dvec2& place) {
  using namespace croquis::render;
  const glm::dvec2 way = place - std::exchange(place_, place);
  if (button_ < 0) return;
  if (button_ == GLFW_MOUSE_BUTTON_LEFT) camera_ = tumble(camera_, camera_.target, way * radians_per_pixel);
  if (button_ == GLFW_MOUSE_BUTTON_MIDDLE) camera_ = track(camera_, way, window_.size().y);
  if (button_ == GLFW_MOUSE_BUTTON_RIGHT) camera_ = dolly(camera_, std::exp(0.01 * (way.x - way.y)));
  changed_ = true;
}

void Navigation::wheel(double steps) {
  camera_ = croquis::render::dolly_about(camera_, std::pow(1.15, steps), place_, window_.size());
  changed_ = true;
}
