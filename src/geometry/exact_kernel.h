// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "croquis/geometry/vector.h"

namespace croquis {

/// Coordinates are doubles as they are; predicates on them are exact.
using ExactKernel = CGAL::Exact_predicates_inexact_constructions_kernel;

inline ExactKernel::Point_3 exact_point(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

}  // namespace croquis
