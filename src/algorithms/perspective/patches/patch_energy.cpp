// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/perspective/patches/patch_energy.h"

#include <cstddef>

namespace croquis {
namespace {

constexpr double step = 1e-3;

PatchWeights slope_weights(double u, double v, bool along_u) {
  const GregoryWeights weights = gregory_weights(u, v);
  return Eigen::Map<const PatchWeights>((along_u ? weights.du : weights.dv).data());
}

Eigen::Matrix<double, 20, 20> make_variation_energy() {
  constexpr int cells = 12;
  Eigen::Matrix<double, 20, 20> energy = Eigen::Matrix<double, 20, 20>::Zero();
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      const double u = (i + 0.5) / cells, v = (j + 0.5) / cells;
      for (const bool slope_u : {true, false}) {
        for (const bool along_u : {true, false}) {
          const double du = along_u ? step : 0, dv = along_u ? 0 : step;
          const PatchWeights third = (slope_weights(u + du, v + dv, slope_u) - 2 * slope_weights(u, v, slope_u) +
                                      slope_weights(u - du, v - dv, slope_u)) /
                                     (step * step);
          energy += (slope_u == along_u ? 1 : 3) * third * third.transpose();
        }
      }
    }
  }
  return energy / (cells * cells);
}

}  // namespace

PatchPoints points_of(const GregoryPatch& patch) {
  PatchPoints points;
  for (std::size_t i = 0; i < 20; ++i) {
    points.row(static_cast<Eigen::Index>(i)) = i < 12 ? patch.boundary[i] : patch.inner[i - 12];
  }
  return points;
}

const Eigen::Matrix<double, 20, 20>& variation_energy() {
  static const Eigen::Matrix<double, 20, 20> energy = make_variation_energy();
  return energy;
}

PatchWeights second_derivative(double u, double v, bool along_u) {
  const double inwards = (along_u ? u : v) < 0.5 ? step : -step;
  const double du = along_u ? inwards : 0, dv = along_u ? 0 : inwards;
  return (4 * slope_weights(u + du, v + dv, along_u) - 3 * slope_weights(u, v, along_u) -
          slope_weights(u + 2 * du, v + 2 * dv, along_u)) /
         (2 * inwards);
}

}  // namespace croquis
