// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/geometry/vector.h"

namespace croquis {

/// Moves the samples near the first one so that it lies on `place`; the movement fades out smoothly over `run`, an arc
/// length.
template <typename Iterator>
void bend_end(Iterator first, Iterator last, const Vec2& place, double run) {
  const Vec2 shift = place - first->position;
  Vec2 before = first->position;
  double length = 0;
  for (Iterator sample = first; sample != last; ++sample) {
    const Vec2 drawn = sample->position;
    length += (drawn - before).norm();
    before = drawn;
    const double t = run > 0 ? length / run : (length > 0 ? 1 : 0);
    if (t >= 1) return;
    sample->position += (1 - t * t * (3 - 2 * t)) * shift;
  }
}

}  // namespace croquis
