// SPDX-License-Identifier: GPL-3.0-or-later
#include "implicit/unit_centres.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "croquis/implicit/box_weight.h"
#include "implicit/point_checks.h"

namespace croquis::implicit {
namespace {

// Of the box: two equal rows would make the system singular.
constexpr double duplicate_distance = 1e-9;

/// The first of every group of points at one place, ascending.
std::vector<std::size_t> distinct(const std::vector<Vec3>& points, double tolerance) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return points[a].x() != points[b].x() ? points[a].x() < points[b].x() : a < b;
  });
  std::vector<char> dropped(points.size(), 0);
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t j = i + 1; j < order.size() && points[order[j]].x() - points[order[i]].x() <= tolerance; ++j) {
      if ((points[order[i]] - points[order[j]]).norm() <= tolerance) dropped[std::max(order[i], order[j])] = 1;
    }
  }
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (dropped[i] == 0) kept.push_back(i);
  return kept;
}

/// Quadratic, which is nothing beside the solve.
double mean_nearest_distance(const std::vector<Vec3>& points) {
  if (points.size() < 2) return 0;
  std::vector<double> nearest(points.size(), std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      const double squared = (points[i] - points[j]).squaredNorm();
      nearest[i] = std::min(nearest[i], squared);
      nearest[j] = std::min(nearest[j], squared);
    }
  }
  double sum = 0;
  for (const double squared : nearest) sum += std::sqrt(squared);
  return sum / static_cast<double>(points.size());
}

}  // namespace

UnitCentres unit_centres(const Constraints& constraints, const FitOptions& options) {
  require_constraints(constraints);
  for (const double number : {options.value_smoothing, options.gradient_smoothing, options.spacing})
    require_parameter(std::isfinite(number) && number >= 0, "smoothing", "smoothing and spacing can't be negative");
  UnitCentres centres;
  const Box box = bounds(constraints.positions);
  centres.middle = box.middle();
  const double longest = box.size().maxCoeff();
  if (longest > 0) centres.size = longest;
  std::vector<Vec3> scaled;
  for (const Vec3& position : constraints.positions) scaled.push_back((position - centres.middle) / centres.size);

  for (const std::size_t i : distinct(scaled, duplicate_distance)) {
    centres.positions.push_back(scaled[i]);
    centres.values.push_back(constraints.values.empty() ? 0 : constraints.values[i] / centres.size);
    const bool directed = takes_gradients(options.kernel) && !constraints.gradients.empty();
    centres.gradients.push_back(directed ? constraints.gradients[i] : Vec3(Vec3::Zero()));
    centres.softness.push_back(constraints.softness.empty() ? 1 : constraints.softness[i]);
  }
  centres.merged = scaled.size() - centres.positions.size();
  centres.spacing = options.spacing > 0 ? options.spacing / centres.size : mean_nearest_distance(centres.positions);
  return centres;
}

}  // namespace croquis::implicit
