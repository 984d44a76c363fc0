// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/render/mesh_item.h"

namespace croquis::render {

enum class Shading {
  Clay,  ///< key light from the upper left, sky and ground, soft rim; the lights turn with the camera
  Flat   ///< the colours as they are
};

/// The look of a picture. Widths are in pixels of the finished picture.
struct RenderOptions {
  Color background_top = {250, 250, 251, 255};     ///< a vertical gradient from here …
  Color background_bottom = {214, 218, 224, 255};  ///< … to here
  Shading shading = Shading::Clay;
  bool occlusion = true;       ///< with Clay: darkens hollows and where parts come close
  bool contours = true;        ///< lines where the surface turns away from the eye, at creases and where patches meet
  double contour_width = 1.5;  ///< in [0.5, 8]
  Color contour_color = {40, 36, 42, 235};  ///< alpha is the strength
  bool wire = false;                        ///< the polygons' edges (not the triangles drawn for them)
  double wire_width = 0.8;                  ///< in [0.1, 8]
  Color wire_color = {44, 50, 62, 150};     ///< alpha is the strength
  double line_width = 2;                    ///< of polylines, in [0.1, 32]
  int supersampling = 3;  ///< samples per pixel and axis, 1..4; lowered where the driver allows no texture that large
};

}  // namespace croquis::render
