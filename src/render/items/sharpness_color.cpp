// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/render/sharpness_color.h"

#include <array>
#include <cmath>

#include <glm/glm.hpp>

#include "croquis/geometry/mesh_tags.h"
#include "render/items/color_ramp.h"

namespace croquis::render {
namespace {

constexpr ColorRamp<4> sharpness_ramp = {{{104, 206, 172}, {22, 156, 142}, {26, 96, 146}, {44, 26, 104}}};
constexpr Color infinite_color = {200, 0, 112, 255};

/// In [0, 1]: half a level matters more between 0 and 2 than between 8 and 10.
double share_of_ramp(double sharpness) {
  if (!(sharpness > 0)) return 0;
  return std::log1p(std::min(sharpness, greatest_sharpness)) / std::log1p(greatest_sharpness);
}

std::string label_of(double sharpness) {
  if (sharpness > greatest_sharpness) return "infinite";
  const bool half = sharpness != std::floor(sharpness);
  return std::to_string(static_cast<int>(sharpness)) + (half ? ".5" : "");
}

}  // namespace

Color sharpness_color(double sharpness) {
  if (sharpness > greatest_sharpness) return infinite_color;
  return color_on(sharpness_ramp, share_of_ramp(sharpness));
}

float sharpness_width(double sharpness) {
  if (sharpness > greatest_sharpness) return 4;
  return static_cast<float>(2 + 1.5 * share_of_ramp(sharpness));
}

std::vector<SharpnessSample> sharpness_legend() {
  std::vector<SharpnessSample> samples;
  for (const double sharpness : {0.5, 1.0, 2.0, 3.0, 5.0, 10.0, infinite_sharpness}) {
    samples.push_back({sharpness, label_of(sharpness), sharpness_color(sharpness)});
  }
  return samples;
}

}  // namespace croquis::render
