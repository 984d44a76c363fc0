// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/base/report.h"
#include "croquis/geometry/brep.h"
#include "croquis/operators/perspective_result.h"
#include "croquis/perspective/face_finding.h"
#include "croquis/perspective/network_reconstruction.h"
#include "croquis/perspective/solid.h"

namespace croquis {

/// What all steps found, as one value.
/// @param drawing with its parameters, as it was solved
/// @param findings of all steps: strokes that they name are flagged
PerspectiveResult result_of_perspective(const PerspectiveDrawing& drawing, const ReconstructedNetwork& network,
                                        const FaceFindingResult& faces, const Solid& solid, const Findings& findings);

/// Changes that would end contradictions, in the order in which these were found.
std::vector<ProposedFix> proposed_fixes(const PerspectiveDrawing& drawing,
                                        const std::vector<Contradiction>& contradictions);

/// The drawing with that change.
PerspectiveDrawing with_fix(PerspectiveDrawing drawing, const ProposedFix& fix);

/// Adds to each finding about a contradiction the change that would end it.
void attach_fixes(const std::vector<ProposedFix>& fixes, Findings& findings);

/// The `details` of the report.
Report to_report(const PerspectiveResult& result);

/// All surfaces of a solid: for each Gregory patch its face, the strokes along its sides and its 20 control points, for
/// each planar face its plane and loops.
/// @param faces by number of outline
/// @param stroke_of_curve ids of the strokes that curves of the network were drawn as
Report patch_report(const Brep& brep, const std::vector<PerspectiveFace>& faces,
                    const std::vector<std::string>& stroke_of_curve);

}  // namespace croquis
