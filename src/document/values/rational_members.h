// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/geometry/rational_cubic.h"
#include "document/values/member_bytes.h"

namespace croquis {

inline auto members(const RationalCubic& cubic) { return std::tie(cubic.points, cubic.weights); }
static_assert(lists_every_member<RationalCubic>);

inline void require_valid(const RationalCubic& cubic) {
  for (const double weight : cubic.weights) {
    if (!(weight > 0 && weight <= 1e300)) throw BadBytes("a curve's weight is not positive");
  }
}

}  // namespace croquis
