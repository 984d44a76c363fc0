// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/render/offscreen_context.h"

#include <string>
#include <string_view>

// Before EGL: it has types of its own for those of Khronos, and takes no others.
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <epoxy/gl.h>

#include "croquis/base/error.h"

namespace croquis::render {
namespace {

[[noreturn]] void throw_no_gl(const std::string& missing) {
  throw Error(make_error(Category::Io, "E_NO_GL",
                         "No picture can be drawn because " + missing +
                             "; install Mesa's software driver (Debian: libegl-mesa0 and libgl1-mesa-dri)."));
}

bool has_extension(const char* list, std::string_view name) {
  const std::string words = " " + std::string(list != nullptr ? list : "") + " ";
  return words.find(" " + std::string(name) + " ") != std::string::npos;
}

EGLDisplay open_display() {
  if (!has_extension(eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS), "EGL_MESA_platform_surfaceless")) {
    throw_no_gl("EGL knows no platform without a screen (EGL_MESA_platform_surfaceless)");
  }
  const auto get_display =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  if (get_display == nullptr) throw_no_gl("EGL has no eglGetPlatformDisplayEXT");
  EGLDisplay display = get_display(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
  if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) == EGL_FALSE) {
    throw_no_gl("EGL can't start its platform without a screen");
  }
  return display;
}

EGLContext make_context(EGLDisplay display) {
  const char* extensions = eglQueryString(display, EGL_EXTENSIONS);
  if (!has_extension(extensions, "EGL_KHR_surfaceless_context") ||
      !has_extension(extensions, "EGL_KHR_no_config_context")) {
    throw_no_gl("the EGL driver makes no context without a surface");
  }
  if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) throw_no_gl("the EGL driver has no OpenGL");
  constexpr EGLint wanted[] = {
      EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
  EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted);
  if (context == EGL_NO_CONTEXT) throw_no_gl("the EGL driver makes no OpenGL 3.3 core context");
  return context;
}

}  // namespace

struct OffscreenContext::Handles {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;

  // The display is shared by all its users in the process, so it stays initialised.
  ~Handles() {
    if (context == EGL_NO_CONTEXT) return;
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display, context);
  }
};

OffscreenContext::OffscreenContext() : handles_(std::make_unique<Handles>()) {
  handles_->display = open_display();
  handles_->context = make_context(handles_->display);
  if (eglMakeCurrent(handles_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, handles_->context) == EGL_FALSE) {
    throw_no_gl("the EGL driver can't use a context without a surface");
  }
}

OffscreenContext::~OffscreenContext() = default;

}  // namespace croquis::render
