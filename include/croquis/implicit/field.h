// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>

#include "croquis/geometry/vector.h"

/// Surfaces as the zero set of a function of space: fields from points and normals, and their polygons.
///
/// Everywhere in this module a field is negative inside, positive outside, and zero on the surface; near the surface it
/// is about the signed distance.
namespace croquis::implicit {

/// Values, and gradients where wanted, of a scalar function at many points at once, so that its loops vectorise.
///
/// Points and values have the same size; gradients have it too, or none: then they aren't wanted. NaN as value: the
/// function is not defined there. Called from several threads at once; the answer for a point depends on that point
/// alone.
using Field = std::function<void(std::span<const Vec3> points, std::span<double> values, std::span<Vec3> gradients)>;

/// A field from a function of one point that returns the value; its gradients by central differences.
/// @param function thread-safe, double(const Vec3&)
/// @param step     of the differences, model units
template <typename Function>
Field field_of(Function function, double step) {
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

}  // namespace croquis::implicit
