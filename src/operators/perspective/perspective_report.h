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
/// @param faces by number of outline
/// @param stroke_of_curve ids of the strokes that curves of the network were drawn as
Report patch_report(const Brep& brep, const std::vector<PerspectiveFace>& faces,
                    const std::vector<std::string>& stroke_of_curve);

}  // namespace croquis
