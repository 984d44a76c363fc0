// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "croquis/render/color.h"

namespace croquis::render {

/// Red, green, blue at evenly spaced places of a scale, 0..255.
template <std::size_t stops>
using ColorRamp = std::array<std::array<double, 3>, stops>;

/// The colour at a place of the scale, between its stops by share. @param place 0..1, not NaN
template <std::size_t stops>
Color color_on(const ColorRamp<stops>& ramp, double place) {
  const double at = std::clamp(place, 0.0, 1.0) * (stops - 1);
  const auto stop = std::min(static_cast<std::size_t>(at), stops - 2);
  const double share = at - static_cast<double>(stop);
  Color color(0, 0, 0, 255);
  for (int i = 0; i < 3; ++i) {
    const auto c = static_cast<std::size_t>(i);
    color[i] = static_cast<std::uint8_t>(std::lround((1 - share) * ramp[stop][c] + share * ramp[stop + 1][c]));
  }
  return color;
}

}  // namespace croquis::render
