// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/sketches/characters/rosette.h"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "croquis/geometry/polyline.h"
#include "support/sketches/characters/character.h"
#include "support/sketches/sketch_layers.h"

namespace croquis::test {

Sketch rosette_sketch(int limbs, double share, double turns, double reach, double bend) {
  std::vector<LayeredPart> parts;
  const double width = share * turns * 2 * std::numbers::pi * 130 / limbs;
  for (int i = 0; i < limbs; ++i) {
    const double angle = 2 * std::numbers::pi * turns * (i + 0.37) / limbs;
    const Vec2 outward(std::cos(angle), std::sin(angle));
    std::vector<Vec2> through;
    for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      through.emplace_back((60 + (reach - 60) * t) * outward + bend * std::sin(5.6 * t) * t * left_of(outward));
    }
    parts.push_back({limb_outline(through, std::vector<double>(5, width / 2)), i});
  }
  parts.push_back({circle_outline({0, 0}, 130), limbs});
  return layered_sketch(std::move(parts));
}

}  // namespace croquis::test
