// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "croquis/geometry/camera.h"
#include "croquis/geometry/curve_network.h"
#include "croquis/geometry/perspective_drawing.h"
#include "croquis/geometry/vector.h"

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

// Units of length of perspective drawings, and numbers with units as people type them.

/// "mm", "cm", "m", "in".
const std::vector<std::string>& length_units();

/// @return metres; 0 for an empty or unknown unit
double metres_of_unit(std::string_view unit);

/// "120", "12 cm", "4,5in": a length in the drawing's unit. A number without a unit is in the drawing's own one.
/// @param unit the drawing's, empty for none: then no unit may be typed
/// @return nothing for another text and for lengths that aren't above 0
std::optional<double> read_length(std::string_view text, std::string_view unit);

/// "0 0 0", "10, 0, 2.5 cm": coordinates in the drawing's unit.
std::optional<Vec3> read_point(std::string_view text, std::string_view unit);

}  // namespace croquis
