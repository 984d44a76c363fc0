// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

#include "croquis/geometry/vector.h"

namespace croquis::render {

inline glm::dvec3 to_glm(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

}  // namespace croquis::render
