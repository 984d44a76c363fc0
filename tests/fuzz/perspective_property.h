// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "croquis/geometry/perspective_drawing.h"

/// What must hold for any bytes that are read as perspective drawings and cameras: shared by the fuzzers and the tests.
namespace croquis::test {

/// Equality of all that files hold (not of file and lines); NaN equals itself.
bool same_drawing(const PerspectiveDrawing& a, const PerspectiveDrawing& b);

/// Reading as SVG, or as JSON when the first byte is '{', either throws an Error with findings, or gives strokes that
/// follow the rules of PerspectiveStroke and come back the same through both formats.
/// @return what did not hold; empty when all did
std::string broken_perspective(std::string_view bytes);

/// Reading either throws an Error with findings, or gives a camera that comes back the same.
std::string broken_camera(std::string_view bytes);

}  // namespace croquis::test
