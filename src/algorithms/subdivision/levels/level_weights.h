// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/SparseCore>

#include "algorithms/subdivision/refinement/face_mask.h"
#include "algorithms/subdivision/refinement/refine.h"

namespace croquis::subdivision {

/// What compute_positions does, as a matrix of #V of the new level by #V of the old.
Eigen::SparseMatrix<double, Eigen::RowMajor> level_weights(const HalfEdges& old, const Refinement& made,
                                                           const FaceMask& mask);

}  // namespace croquis::subdivision
