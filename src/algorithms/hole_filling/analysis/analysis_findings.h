// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/base/finding.h"
#include "croquis/hole_filling/hole_analysis.h"

namespace croquis::hole_filling {

/// What the analysis reports about a faulty mesh, one finding per type of fault.
Findings analysis_findings(const HoleAnalysis& analysis);

}  // namespace croquis::hole_filling
