// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
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

/// Takes away what is said of the ends of a stroke, by itself and by others: they are elsewhere, or gone.
void forget_ends(Drawing& drawing, const std::string& id);

}  // namespace croquis
