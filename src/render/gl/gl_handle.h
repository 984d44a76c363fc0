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

/// Size of what is drawn off screen: the viewport and a border, so that lines and hollows at its sides come out whole.
struct FrameSize {
  int pixel_width = 0;   ///< border included
  int pixel_height = 0;  ///< border included
  int samples = 1;       ///< per pixel and axis

  int width() const { return pixel_width * samples; }
  int height() const { return pixel_height * samples; }
  bool operator==(const FrameSize&) const = default;
};

/// The textures between the passes of one drawing, and the framebuffers that fill them.
struct FrameBuffers {
  /// @throws Error (E_GL) when the driver can't make them
  explicit FrameBuffers(const FrameSize& size);

  FrameSize size;
  GlHandle colors, normals, depths;  ///< per sample, from the surfaces; depths holds the patch, too
  GlHandle veil;                     ///< per sample, of translucent surfaces; made when first needed
  GlHandle overlay;                  ///< per sample, from polylines and wire
  GlHandle marks, row_distances;     ///< per sample, of contours
  GlHandle openness;                 ///< per pixel
  GlHandle depth_buffer;             ///< shared by surfaces and overlay
  /// Makes the veil, if it isn't there. @throws Error (E_GL) when the driver can't
  void require_veil();

  GlHandle surface_target, overlay_target, marks_target, row_distances_target, openness_target, veil_target;
};

}  // namespace croquis::render
