// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/base/finding.h"
#include "croquis/hole_filling/fill_holes.h"

namespace croquis::hole_filling {

/// The analysis' findings, then what is to be said about the holes: left as OUTER, filled by another method, failed.
Findings fill_findings(const PolyMesh& scan, const FillResult& result);

}  // namespace croquis::hole_filling
