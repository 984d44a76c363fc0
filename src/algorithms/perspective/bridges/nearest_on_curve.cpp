// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/perspective/bridges/nearest_on_curve.h"

#include <algorithm>
#include <limits>

namespace croquis {
namespace {

constexpr int curve_samples = 64;  // of a piece: a cubic bends too little to hide a nearer place between two
constexpr int section_steps = 40;  // of golden section: 0.618^40 of an interval
constexpr double golden = 0.6180339887498949;

double nearest_parameter(const RationalCubic& cubic, const Vec3& point, double low, double high) {
  const auto distance = [&](double t) { return (cubic.at(t) - point).squaredNorm(); };
  double left = high - golden * (high - low), right = low + golden * (high - low);
  double at_left = distance(left), at_right = distance(right);
  for (int step = 0; step < section_steps; ++step) {
    if (at_left <= at_right) {
      high = right;
      right = left;
      at_right = at_left;
      left = high - golden * (high - low);
      at_left = distance(left);
    } else {
      low = left;
      left = right;
      at_left = at_right;
      right = low + golden * (high - low);
      at_right = distance(right);
    }
  }
  return (low + high) / 2;
}

}  // namespace

Vec3 nearest_on_curve(const std::vector<RationalCubic>& pieces, const Vec3& point) {
  const RationalCubic* best = &pieces.front();
  int best_sample = 0;
  double least = std::numeric_limits<double>::infinity();
  for (const RationalCubic& piece : pieces) {
    for (int i = 0; i <= curve_samples; ++i) {
      const double distance = (piece.at(static_cast<double>(i) / curve_samples) - point).squaredNorm();
      if (distance >= least) continue;
      least = distance;
      best = &piece;
      best_sample = i;
    }
  }
  const double low = static_cast<double>(std::max(best_sample - 1, 0)) / curve_samples;
  const double high = static_cast<double>(std::min(best_sample + 1, curve_samples)) / curve_samples;
  return best->at(nearest_parameter(*best, point, low, high));
}

}  // namespace croquis
