// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/sketches/sketch_figures.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <vector>

#include "support/random.h"
#include "support/sketches/sketch_layers.h"
#include "support/sketches/sketch_spline.h"
#include "support/sketches/sketch_tubes.h"

namespace croquis::test {
namespace {

constexpr int drawings_tried = 200;

/// An oval round a centre, its radius changed by a few hundredths.
struct Oval {
  Vec2 centre;
  Vec2 half;

  Vec2 at(double radius, double degrees) const {
    const double angle = degrees * std::numbers::pi / 180;
    return centre + radius * half.cwiseProduct(Vec2(std::cos(angle), std::sin(angle)));
  }
};

LayeredPart oval_part(Random& random, const Oval& oval, int priority) {
  std::vector<Vec2> through;
  for (int k = 0; k < 10; ++k) through.push_back(oval.at(random.between(0.94, 1.06), 36 * k));
  return {smooth_loop(through), priority};
}

LayeredPart limb_of(Random& random, const Oval& body, double degrees, int priority) {
  const double thick = body.half.y() * random.between(0.16, 0.3);
  const double bend = random.between(-14, 14);
  const double root = random.between(0.55, 0.8);
  return {tube_outline(limb({body.at(root, degrees), body.at(1.15, degrees + bend / 2), body.at(1.7, degrees + bend)},
                            {thick, 0.9 * thick, 0.8 * thick}, 0)),
          priority};
}

std::vector<LayeredPart> figure_parts(Random& random) {
  const Oval body{{450, 330}, {random.between(150, 220), random.between(100, 140)}};
  std::vector<LayeredPart> parts{oval_part(random, body, 100)};
  const Oval head{body.at(random.between(1.05, 1.25), random.between(120, 150)),
                  random.between(0.45, 0.6) * body.half.y() * Vec2(1.2, 1)};
  parts.push_back(oval_part(random, head, 200));
  const auto limbs = 2 + static_cast<int>(random.below(5));
  for (int k = 0; k < limbs; ++k) {
    const double degrees = 205 + 130.0 * (k + 0.5) / limbs + random.between(-6, 6);
    parts.push_back(limb_of(random, body, degrees, random.below(2) == 0 ? 110 + k : 10 + k));
  }
  parts.push_back(limb_of(random, body, random.between(15, 40), 5));
  return parts;
}

bool clear(const SketchTruth& truth) {
  for (std::size_t i = 0; i < truth.places.size(); ++i) {
    if (truth.places[i].sine < 0.3) return false;
    for (std::size_t k = i + 1; k < truth.places.size(); ++k) {
      if ((truth.places[i].at - truth.places[k].at).norm() < 20) return false;
    }
  }
  return true;
}

}  // namespace

Sketch random_figure_sketch(std::uint64_t seed) {
  Random random(seed);
  for (int drawing = 0; drawing < drawings_tried; ++drawing) {
    try {
      Sketch sketch = layered_sketch(figure_parts(random));
      if (clear(sketch.truth)) return sketch;
    } catch (const std::invalid_argument&) {
      // A part was covered: another figure.
    }
  }
  throw std::logic_error("no clear random figure");
}

Sketch limb_on_blob_sketch(bool limb_in_front) {
  const auto level = [](double) { return 0.0; };
  return layered_sketch({{circle_outline({0, 0}, 150), 1},
                         {tube_outline(bar({60, -60}, {260, -260}, 40, level)), limb_in_front ? 2 : 0}});
}

}  // namespace croquis::test
