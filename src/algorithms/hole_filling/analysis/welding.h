// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "croquis/base/progress.h"
#include "croquis/geometry/poly_mesh.h"

namespace croquis::hole_filling {

struct Welding {
  std::vector<Index> representative;  ///< #V, or empty when no two used vertices are at one place
  std::size_t welded = 0;
};

/// For each vertex that a face uses the lowest such vertex with exactly equal coordinates; others stay themselves.
/// Expected linear: an open-addressed table of indices, whose order never shows.
Welding weld_identical(const PolyMesh& mesh, Progress& progress);

}  // namespace croquis::hole_filling
