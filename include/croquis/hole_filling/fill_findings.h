// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "croquis/base/finding.h"
#include "croquis/hole_filling/fill_holes.h"

namespace croquis::hole_filling {

/// The analysis' findings, then those about the holes: left as OUTER, filled by another method, failed.
Findings fill_findings(const PolyMesh& scan, const FillResult& result);

/// How people ask for what a method makes: "by rbf", "smooth", "flat" or "bridged".
std::string option_of(std::string_view method);

/// Why a hole failed of which the whole piece was left out; the finding is about the piece.
inline constexpr const char* piece_left_out = "its piece of the mesh was left out";

/// Why the rim of a few triangles was left that hang in a hole by a vertex: the first of its companions.
inline constexpr const char* hangs_at_rim = "hangs at the rim of a hole by a corner";

}  // namespace croquis::hole_filling
