// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/attribute_surface/curves/bezier.h"

namespace croquis {

Vec3 bezier_of_any_degree(std::span<const Vec3> control, double t) {
  const std::size_t degree = control.size() - 1;
  if (degree == 0) return control[0];
  double power = 1;
  double binomial = 1;
  Vec3 sum = control[0] * (1 - t);
  for (std::size_t i = 1; i < degree; ++i) {
    power *= t;
    binomial *= static_cast<double>(degree - i + 1) / static_cast<double>(i);
    sum = (sum + power * binomial * control[i]) * (1 - t);
  }
  return sum + power * t * control[degree];
}

std::vector<Vec3> bezier_derivative(std::span<const Vec3> control) {
  std::vector<Vec3> result;
  for (std::size_t i = 0; i + 1 < control.size(); ++i) {
    result.push_back(static_cast<double>(control.size() - 1) * (control[i + 1] - control[i]));
  }
  return result;
}

}  // namespace croquis
