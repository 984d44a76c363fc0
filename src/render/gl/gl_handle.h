// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace croquis::render {

/// An OpenGL object that is deleted with its owner, in whose lifetime the context is current. 0 means none.
class GlHandle {
 public:
  using Deleter = void (*)(unsigned name);

  GlHandle() = default;
  GlHandle(unsigned name, Deleter deleter) : name_(name), deleter_(deleter) {}
  GlHandle(GlHandle&& other) noexcept : name_(std::exchange(other.name_, 0)), deleter_(other.deleter_) {}
  GlHandle& operator=(GlHandle&& other) noexcept {
    std::swap(name_, other.name_);
    std::swap(deleter_, other.deleter_);
    return *this;
  }
  ~GlHandle() {
    if (name_ != 0) deleter_(name_);
  }

  unsigned name() const { return name_; }

 private:
  unsigned name_ = 0;
  Deleter deleter_ = nullptr;
};

GlHandle make_buffer();
GlHandle make_vertex_array();
GlHandle make_framebuffer();
GlHandle make_depth_buffer(int width, int height);
GlHandle make_depth_stencil_buffer(int width, int height);

/// A new buffer with these bytes; it stays bound.
/// @param target what OpenGL binds it to
GlHandle upload(unsigned target, std::span<const std::byte> bytes);

/// A place in the bound buffer, as OpenGL's functions take it.
inline const void* byte_offset(std::size_t offset) { return reinterpret_cast<const void*>(offset); }

/// A texture without mipmaps that is read texel by texel.
/// @param format OpenGL's sized internal format
GlHandle make_texture(unsigned format, int width, int height);

/// Throws the driver's message.
[[noreturn]] void throw_gl_error(const std::string& message);

/// @param doing what was being done, for the sentence
/// @throws Error (E_GL) when the driver has recorded an error since the last call
void check_gl(std::string_view doing);

/// @throws Error (E_GL) when the framebuffer bound for drawing can't be drawn into
void check_framebuffer();

}  // namespace croquis::render
