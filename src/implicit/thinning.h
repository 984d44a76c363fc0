// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "croquis/implicit/box_weight.h"

namespace croquis::implicit {

/// At most `most` of the candidates, evenly spread: one per cell of a grid over the box, the one nearest to the box'
/// middle, the lower index of equals; the cells grow until few enough are left. Ascending.
/// The result depends on the points alone, not on the candidates' order.
std::vector<Index> thinned(std::span<const Vec3> positions, std::vector<Index> candidates, const Box& box,
                           std::size_t most);

}  // namespace croquis::implicit
