// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace croquis::implicit {

/// A = L L' in place, for a symmetric positive definite matrix of which the lower triangle is read and overwritten,
/// nothing else.
///
/// Blocked and right-looking, in an order of operations that depends on the size alone: the same bits on every machine,
/// which a library that fits its blocks to the caches doesn't guarantee. n^3/3 multiplications and additions.
/// @param a      column-major
/// @param stride between columns, >= n
/// @param least  a pivot not larger than this ends the factorisation
/// @return false then; the matrix is overwritten
bool factor_cholesky(double* a, std::size_t n, std::size_t stride, double least);

/// Solves L L' x = b in place, with the factor of factor_cholesky.
void solve_cholesky(const double* a, std::size_t n, std::size_t stride, double* b);

}  // namespace croquis::implicit
