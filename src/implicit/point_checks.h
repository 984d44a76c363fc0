// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "croquis/implicit/local_fit.h"

namespace croquis::implicit {

/// @throws Error E_NO_POINTS without any, E_NOT_FINITE naming the first such point, E_COUNT when sizes differ
void require_constraints(const Constraints& constraints);

/// As above for points with normals, of which there may be none.
void require_points(std::span<const Vec3> positions, std::span<const Vec3> normals);

/// @throws Error E_PARAMETER unless `holds`
/// @param rule what is accepted, as in "the cell size must be positive"
void require_parameter(bool holds, const std::string& name, const std::string& rule);

}  // namespace croquis::implicit
