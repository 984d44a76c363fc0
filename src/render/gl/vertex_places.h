// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <epoxy/gl.h>

namespace croquis::render {

/// Where shaders of surfaces and of lines alike read a vertex's position and colour.
inline constexpr GLuint position_place = 0;
inline constexpr GLuint color_place = 2;

}  // namespace croquis::render
