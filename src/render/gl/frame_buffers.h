// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/gl/gl_handle.h"

namespace croquis::render {

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
