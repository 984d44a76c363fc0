// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace croquis::render {

/// How far hollows look around for what hides their sky.
struct OcclusionReach {
  int pixels = 0;
  double picture_share = 0;  ///< the same relative to the picture's height
};

/// Seven hundredths of the picture's height, but no more pixels than a tile's border may reasonably have.
inline OcclusionReach occlusion_reach(int picture_height) {
  const int pixels = std::clamp(picture_height * 7 / 100, 1, 80);
  return {pixels, static_cast<double>(pixels) / picture_height};
}

}  // namespace croquis::render
