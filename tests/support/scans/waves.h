// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "croquis/geometry/vector.h"
#include "support/random.h"

namespace croquis::test {

/// A smooth number of a place: waves of random directions, the shorter the lower.
class Waves {
 public:
  Waves(Random& random, double length, int count, double roughness = 0.55) {
    for (int i = 0; i < count; ++i) {
      const Vec3 direction(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
      const double frequency = std::pow(1.7, i);
      waves_.push_back(2 * std::numbers::pi * frequency / length * direction.normalized());
      heights_.push_back(std::pow(roughness, i));
      phases_.push_back(random.between(0, 2 * std::numbers::pi));
    }
  }

  double at(const Vec3& p) const {
    double sum = 0;
    for (std::size_t i = 0; i < waves_.size(); ++i) sum += heights_[i] * std::sin(waves_[i].dot(p) + phases_[i]);
    return sum;
  }

 private:
  std::vector<Vec3> waves_;
  std::vector<double> heights_, phases_;
};

}  // namespace croquis::test
