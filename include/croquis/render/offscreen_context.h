// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

namespace croquis::render {

/// An OpenGL 3.3 core context without window, screen or display server (EGL, Mesa's surfaceless platform), current in
/// its thread for as long as it lives. There is no default framebuffer: its user binds one.
///
/// It shares nothing with the contexts of windows, so another thread may draw a window meanwhile. Two contexts of one
/// display may not: Mesa 22.3 reads the frames of all of them without a lock when a buffer of one is written.
class OffscreenContext {
 public:
  /// @throws Error (E_NO_GL, io) naming what is missing and the packages that have it
  OffscreenContext();
  ~OffscreenContext();
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

 private:
  struct Handles;
  std::unique_ptr<Handles> handles_;
};

}  // namespace croquis::render
