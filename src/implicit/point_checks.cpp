// SPDX-License-Identifier: GPL-3.0-or-later
#include "implicit/point_checks.h"

#include <cmath>
#include <cstddef>

#include "croquis/base/error.h"
#include "croquis/base/limits.h"

namespace croquis::implicit {
namespace {

void require_count(std::size_t count, std::size_t points, const std::string& what) {
  if (count == 0 || count == points) return;
  throw Error(make_error(Category::Internal, "E_COUNT",
                         "There are " + std::to_string(points) + " points but " + std::to_string(count) + " " + what +
                             ": give one for every point, or none."));
}

void require_usable(std::span<const Vec3> vectors, const std::string& what) {
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    if (are_usable_numbers(vectors[i])) continue;
    throw Error(
        make_error(Category::Malformed, "E_NOT_FINITE",
                   "The " + what + " of point " + std::to_string(i) + " " + unusable_words + ": correct or remove it.",
                   {numbered_subject(SubjectKind::Point, i)}));
  }
}

}  // namespace

void require_points(std::span<const Vec3> positions, std::span<const Vec3> normals) {
  if (positions.empty()) {
    throw Error(
        make_error(Category::Geometry, "E_NO_POINTS", "There is no point to fit a surface to: give at least one."));
  }
  require_count(normals.size(), positions.size(), "normals");
  require_usable(positions, "position");
  require_usable(normals, "normal");
}

void require_constraints(const Constraints& constraints) {
  require_points(constraints.positions, constraints.gradients);
  require_count(constraints.values.size(), constraints.positions.size(), "values");
  require_count(constraints.softness.size(), constraints.positions.size(), "factors of softness");
  for (const double factor : constraints.softness)
    require_parameter(std::isfinite(factor) && factor >= 0, "softness", "it can't be negative");
  for (std::size_t i = 0; i < constraints.values.size(); ++i) {
    if (is_usable_number(constraints.values[i])) continue;
    throw Error(make_error(Category::Malformed, "E_NOT_FINITE",
                           "The value of point " + std::to_string(i) + " " + unusable_words + ": correct or remove it.",
                           {numbered_subject(SubjectKind::Point, i)}));
  }
}

void require_parameter(bool holds, const std::string& name, const std::string& rule) {
  if (holds) return;
  throw Error(make_error(Category::Usage, "E_PARAMETER", "Parameter '" + name + "' can't be used: " + rule + ".",
                         {{SubjectKind::Parameter, name, {}, {}, {}}}));
}

}  // namespace croquis::implicit
