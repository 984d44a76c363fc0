// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "croquis/geometry/camera.h"
#include "croquis/geometry/curve_network.h"
#include "croquis/geometry/perspective_drawing.h"

namespace croquis {

/// What is known of a perspective drawing from the last time that it was computed, as far as the hand needs it. It may
/// be older than the drawing: strokes are found in it by their ids.
struct SolvedDrawing {
  Camera camera;
  std::array<Vec3, 3> vanishing_points{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};  ///< homogeneous, px
  CurveNetwork network;
  std::vector<std::vector<std::string>> faces;  ///< the strokes of each one's outer loop
  std::vector<std::string> open_strokes;        ///< that lack a face
};

}  // namespace croquis
