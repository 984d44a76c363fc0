// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/base/report.h"
#include "croquis/geometry/brep.h"
#include "croquis/operators/perspective_result.h"

namespace croquis {

/// The `details` of the report.
Report to_report(const PerspectiveResult& result);

/// All surfaces of a solid: for each Gregory patch its face, the strokes along its sides and its 20 control points, for
/// each planar face its plane and loops.
/// @param faces of the B-rep, in its order
Report patch_report(const Brep& brep, const std::vector<PerspectiveFace>& faces);

}  // namespace croquis
