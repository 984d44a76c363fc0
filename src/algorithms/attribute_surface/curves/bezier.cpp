// SPDX-License-Identifier: GPL-3.0-or-later
#include "bezier.h"

namespace croquis {
namespace {

Vec3 any_degree(std::span<const Vec3> control, double t) {
  const std::size_t degree = control.size() - 1;
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

}  // namespace

Vec3 bezier_at(std::span<const Vec3> control, double t) {
  const double u = 1 - t;
  switch (control.size()) {
    case 1: return control[0];
    case 2: return u * control[0] + t * control[1];
    case 3: return (u * u) * control[0] + (2 * u * t) * control[1] + (t * t) * control[2];
    case 4:
      return (u * u * u) * control[0] + (3 * u * u * t) * control[1] + (3 * u * t * t) * control[2] +
             (t * t * t) * control[3];
    default: return any_degree(control, t);
  }
}

std::vector<Vec3> bezier_derivative(std::span<const Vec3> control) {
  std::vector<Vec3> result;
  for (std::size_t i = 0; i + 1 < control.size(); ++i) {
    result.push_back(static_cast<double>(control.size() - 1) * (control[i + 1] - control[i]));
  }
  return result;
}

}  // namespace croquis
