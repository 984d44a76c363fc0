// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "croquis/geometry/vector.h"

/// Units of length of perspective drawings, and numbers with units as people type them.
namespace croquis {

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
