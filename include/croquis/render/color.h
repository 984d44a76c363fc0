// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>

namespace croquis::render {

/// A display colour as pictures store it (sRGB), 0..255; alpha is the strength of what is drawn.
using Color = glm::u8vec4;

}  // namespace croquis::render
