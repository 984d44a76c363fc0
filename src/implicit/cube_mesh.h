// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/base/progress.h"
#include "croquis/implicit/marching_cubes.h"
#include "implicit/sparse_lattice.h"

namespace croquis::implicit {

/// Makes vertices on all crossed edges and triangles in all active cubes, both in the order of their blocks' places.
void make_cube_mesh(SparseLattice& lattice, const PolygonizerOptions& options, Polygonized& result, Progress& progress);

}  // namespace croquis::implicit
