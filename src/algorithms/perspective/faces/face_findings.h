// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/perspective/face_finding.h"

namespace croquis {

/// The warnings about a result that has everything else.
Findings face_findings(const CurveNetwork& network, const FaceFindingResult& result, bool limited);

}  // namespace croquis
