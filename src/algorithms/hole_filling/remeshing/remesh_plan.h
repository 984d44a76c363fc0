// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/hole_filling/remesh.h"

namespace croquis::hole_filling {

/// @throws Error (E_PARAMETER) with one finding for every option out of its range
void require_options(const RemeshOptions& options);

/// @return the prediction
/// @throws Error (E_MEMORY) when it is above the limit, with the coarser cell that would fit
std::size_t require_memory(const PolyMesh& mesh, const RemeshOptions& options);

}  // namespace croquis::hole_filling
