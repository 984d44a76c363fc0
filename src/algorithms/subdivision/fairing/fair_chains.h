// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/subdivision/edge_chain.h"

namespace croquis::subdivision {

/// Minimises |second differences|^2 / h^2 + w |C - C0|^2 over the inner vertices of an open chain or all of a closed
/// one. A planar chain moves within its plane.
/// @param points        of the chain's vertices in order
/// @param edge_length   h
/// @return the moved points
std::vector<Vec3> fair_chain(const EdgeChain& chain, const ChainShape& shape, std::vector<Vec3> points,
                             double edge_length, double weight);

}  // namespace croquis::subdivision
