// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "croquis/geometry/vector.h"

namespace croquis {

/// The places of the keys in ascending order, equal keys as they come. Linear: one pass per digit of 11 bits, sparing
/// those in which all keys agree, as the low ones of coordinates that were stored in single precision.
std::vector<Index> radix_order(std::span<const std::uint64_t> keys);

}  // namespace croquis
