// SPDX-License-Identifier: GPL-3.0-or-later
#include "window.h"

#include <stdexcept>

#define GLFW_INCLUDE_NONE  // the renderer finds OpenGL's functions by itself
#include <GLFW/glfw3.h>

namespace {

std::runtime_error no_window() {
  const char* words = nullptr;
  glfwGetError(&words);
  return std::runtime_error(std::string("No window: ") + (words != nullptr ? words : "unknown reason"));
}

}  // namespace

Window::Window(const glm::ivec2& size, const std::string& title) {
  if (glfwInit() != GLFW_TRUE) throw no_window();
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  window_ = glfwCreateWindow(size.x, size.y, title.c_str(), nullptr, nullptr);
  if (window_ == nullptr) {
    const std::runtime_error error = no_window();
    glfwTerminate();
    throw error;
  }
  glfwMakeContextCurrent(window_);
  glfwSwapInterval(1);
}

Window::~Window() {
  glfwDestroyWindow(window_);
  glfwTerminate();
}

glm::ivec2 Window::framebuffer_size() const {
  glm::ivec2 size(0);
  glfwGetFramebufferSize(window_, &size.x, &size.y);
  return size;
}

glm::dvec2 Window::size() const {
  glm::ivec2 size(0);
  glfwGetWindowSize(window_, &size.x, &size.y);
  return size;
}

double Window::pixel_ratio() const {
  float x = 1, y = 1;
  glfwGetWindowContentScale(window_, &x, &y);
  return x;
}
