// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "algorithms/remeshing/remesh_memory.h"
#include "croquis/remeshing/remesh.h"

namespace croquis::remeshing {

/// @throws Error (E_PARAMETER) with one finding for every option out of its range
void require_options(const RemeshOptions& options);

/// @throws Error (E_MEMORY) when the least that is needed is above the limit (0: none), with the coarser cell that
///         would fit
void require_memory(const RemeshMemory& memory, std::size_t limit);

/// As predicted_remesh_bytes when nothing has to be tried again, in thin slabs: the least limit that isn't refused.
std::size_t least_remesh_bytes(const PolyMesh& mesh, const RemeshOptions& options);

/// A number of bytes as it is reported.
std::size_t whole_bytes(double bytes);

}  // namespace croquis::remeshing
