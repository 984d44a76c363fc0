// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include <Eigen/SparseCore>

#include "algorithms/subdivision/refinement/point_rules.h"
#include "algorithms/subdivision/refinement/refine.h"

namespace croquis::subdivision {

/// The size of a large page on the machines we build for.
inline constexpr std::size_t large_page = std::size_t{2} << 20;

/// Asks the system for large pages in memory that is still untouched; where it refuses pages are small.
void wish_large_pages(void* block, std::size_t bytes);

/// The points of a level from those of the level before.
/// @param old_points #V of `old`; @param points #V of `made`
void compute_positions(const HalfEdges& old, const Refinement& made, const FaceMask& mask, const Vec3* old_points,
                       Vec3* points, int threads);

/// What compute_positions does, as a matrix of #V of the new level by #V of the old.
Eigen::SparseMatrix<double, Eigen::RowMajor> level_weights(const HalfEdges& old, const Refinement& made,
                                                           const FaceMask& mask);

/// Memory held by their arrays.
std::size_t bytes_of(const Level& level);
std::size_t bytes_of(const Refinement& refinement);

}  // namespace croquis::subdivision
