// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/implicit/field.h"

namespace croquis::test {

/// A field from a function of one point that returns the value; its gradients by central differences.
/// @param function thread-safe, double(const Vec3&)
/// @param step     of the differences, model units
template <typename Function>
implicit::Field field_of(Function function, double step) {
  return [function, step](std::span<const Vec3> points, std::span<double> values, std::span<Vec3> gradients) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      values[i] = function(points[i]);
      if (gradients.empty()) continue;
      for (int axis = 0; axis < 3; ++axis) {
        const Vec3 aside = step * Vec3::Unit(axis);
        gradients[i][axis] = (function(Vec3(points[i] + aside)) - function(Vec3(points[i] - aside))) / (2 * step);
      }
    }
  };
}

}  // namespace croquis::test
