// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "croquis/geometry/vector.h"

namespace croquis {

/// Gives equal points one index, in the order of their first appearance. 0 and -0 are equal, as they are in the
/// coordinates of neighbouring facets. O(1) a point (open addressing over mixed bits).
class PositionJoiner {
 public:
  PositionJoiner();

  /// The point's index; new ones are appended to `positions`, which is the table's own array.
  Index add(const Vec3& point, std::vector<Vec3>& positions);

 private:
  void grow(const std::vector<Vec3>& positions);

  std::vector<Index> slots_;
};

}  // namespace croquis
