// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/hole_filling/remesh.h"

namespace croquis::hole_filling {

/// The analysis' findings; then holes left as OUTER, filled by patches after all, failed, or of low confidence; pieces
/// of which nothing came out; and what the checks found.
/// @param mesh the one given; @param lost pieces without a surface
Findings remesh_findings(const PolyMesh& mesh, const RemeshResult& result, std::size_t lost, std::size_t left_out);

}  // namespace croquis::hole_filling
