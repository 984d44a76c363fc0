// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "croquis/geometry/drawing.h"

namespace croquis {

/// Where the samples of a stroke lie.
inline std::vector<Vec2> places_of(std::span<const StrokeSample> samples) {
  std::vector<Vec2> places;
  places.reserve(samples.size());
  for (const StrokeSample& sample : samples) places.push_back(sample.position);
  return places;
}

}  // namespace croquis
