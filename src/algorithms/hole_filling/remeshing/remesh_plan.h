// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/hole_filling/remesh.h"

namespace croquis::hole_filling {

/// @throws Error (E_PARAMETER) with one finding for every option out of its range
void require_options(const RemeshOptions& options);

/// Points of a slab. Pieces with open rims are smoothed when all slabs are done, which costs them every fit twice: they
/// are made in one slab unless slabs are asked for.
struct SlabPoints {
  std::size_t closed = 0, open = 0;
};
SlabPoints slab_points(const RemeshOptions& options);

/// @return the prediction
/// @throws Error (E_MEMORY) when it is above the limit, with the coarser cell that would fit
std::size_t require_memory(const PolyMesh& mesh, const RemeshOptions& options);

}  // namespace croquis::hole_filling
