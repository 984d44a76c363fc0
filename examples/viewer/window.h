// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include <glm/glm.hpp>

struct GLFWwindow;

/// A GLFW window with an OpenGL 3.3 core context, current as long as it lives.
class Window {
 public:
  /// @throws std::runtime_error with GLFW's words when there is no display or no such context
  Window(const glm::ivec2& size, const std::string& title);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  GLFWwindow* handle() const { return window_; }
  glm::ivec2 framebuffer_size() const;  ///< device pixels
  glm::dvec2 size() const;              ///< the unit of pointer positions
  double pixel_ratio() const;           ///< device pixels per such unit

 private:
  GLFWwindow* window_ = nullptr;
};
