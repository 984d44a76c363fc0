// SPDX-License-Identifier: GPL-3.0-or-later
#include "implicit/fit_system.h"

#include <algorithm>
#include <array>
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

constexpr std::size_t least_for_linear = 4;  // fewer centres without gradients: constants alone

Eigen::Index at(std::size_t i) { return static_cast<Eigen::Index>(i); }

std::vector<std::size_t> number_unknowns(const UnitCentres& centres) {
  std::vector<std::size_t> first = {0};
  for (std::size_t c = 0; c < centres.positions.size(); ++c)
    first.push_back(first.back() + (centres.has_gradient(c) ? 4 : 1));
  return first;
}

/// The block of two centres with gradients, d from the second to the first:
/// [phi, -grad phi'; grad phi, -Hess phi] with phi = r^3, grad phi = 3 r d, Hess phi = 3 (r I + d d'/r).
Eigen::Matrix4d cubic_block(const Vec3& d) {
  Eigen::Matrix4d block = Eigen::Matrix4d::Zero();
  const double squared = d.squaredNorm();
  const double r = std::sqrt(squared);
  if (r == 0) return block;
  block(0, 0) = r * squared;
  block.topRightCorner<1, 3>() = -3 * r * d.transpose();
  block.bottomLeftCorner<3, 1>() = 3 * r * d;
  block.bottomRightCorner<3, 3>() = (-3 / r) * (d * d.transpose());
  block.diagonal().tail<3>().array() -= 3 * r;
  return block;
}

/// The same times -1, r^5's sign: phi = r^5, grad phi = 5 r^3 d, Hess phi = 5 (r^3 I + 3 r d d').
Eigen::Matrix4d quintic_block(const Vec3& d) {
  Eigen::Matrix4d block;
  const double squared = d.squaredNorm();
  const double r = std::sqrt(squared);
  const double cube = r * squared;
  block(0, 0) = -cube * squared;
  block.topRightCorner<1, 3>() = 5 * cube * d.transpose();
  block.bottomLeftCorner<3, 1>() = -5 * cube * d;
  block.bottomRightCorner<3, 3>() = (15 * r) * (d * d.transpose());
  block.diagonal().tail<3>().array() += 5 * cube;
  return block;
}

void fill_hermite(const UnitCentres& centres, Kernel kernel, FitSystem& system) {
  const std::size_t count = centres.positions.size();
  for (std::size_t j = 0; j < count; ++j) {
    const Eigen::Index column = at(system.first[j]);
    const Eigen::Index columns = at(system.first[j + 1]) - column;
    for (std::size_t i = j; i < count; ++i) {
      const Vec3 d = centres.positions[i] - centres.positions[j];
      const Eigen::Index row = at(system.first[i]);
      const Eigen::Index rows = at(system.first[i + 1]) - row;
      if (rows == 1 && columns == 1) {
        system.a(row, column) = system.a(column, row) = system.sign * kernel_value(kernel, d);
        continue;
      }
      const Eigen::Matrix4d block = kernel == Kernel::Hermite ? cubic_block(d) : quintic_block(d);
      if (rows == 4 && columns == 4) {
        system.a.block<4, 4>(row, column) = block;
        system.a.block<4, 4>(column, row) = block.transpose();
      } else {
        system.a.block(row, column, rows, columns) = block.topLeftCorner(rows, columns);
        system.a.block(column, row, columns, rows) = block.topLeftCorner(rows, columns).transpose();
      }
    }
  }
}

void fill_values(const UnitCentres& centres, Kernel kernel, FitSystem& system) {
  const std::size_t count = centres.positions.size();
  for (std::size_t j = 0; j < count; ++j) {
    for (std::size_t i = j; i < count; ++i) {
      const double phi = system.sign * kernel_value(kernel, centres.positions[i] - centres.positions[j]);
      system.a(at(i), at(j)) = phi;
      system.a(at(j), at(i)) = phi;
    }
  }
}

/// Smoothing has the kernel's sign, so that the system times that sign only gains on the diagonal.
void add_smoothing(const UnitCentres& centres, const FitOptions& options, FitSystem& system) {
  const int degree = traits(options.kernel).degree;
  const double on_values = options.value_smoothing * std::pow(centres.spacing, degree);
  const double on_gradients = options.gradient_smoothing * std::pow(centres.spacing, degree - 2);
  for (std::size_t c = 0; c < centres.positions.size(); ++c) {
    for (std::size_t k = system.first[c]; k < system.first[c + 1]; ++k)
      system.a(at(k), at(k)) += centres.softness[c] * (k == system.first[c] ? on_values : on_gradients);
  }
}

/// The quadratic terms x², y², z², xy, yz, zx at a centre, and their gradients.
void fill_quadratic(const Vec3& p, Eigen::Index row, bool has_gradient, Eigen::MatrixXd& q) {
  const auto [x, y, z] = std::array{p.x(), p.y(), p.z()};
  q.row(row).tail(6) << x * x, y * y, z * z, x * y, y * z, z * x;
  if (!has_gradient) return;
  q.row(row + 1).tail(6) << 2 * x, 0, 0, y, 0, z;
  q.row(row + 2).tail(6) << 0, 2 * y, 0, x, z, 0;
  q.row(row + 3).tail(6) << 0, 0, 2 * z, 0, y, x;
}

void fill_sides(const UnitCentres& centres, Kernel kernel, FitSystem& system) {
  const bool linear = system.first.back() > centres.positions.size() || centres.positions.size() >= least_for_linear;
  const bool quadratic = linear && traits(kernel).order == 3;
  system.q = Eigen::MatrixXd::Zero(at(system.first.back()), quadratic ? 10 : linear ? 4 : 1);
  system.h = Eigen::VectorXd::Zero(at(system.first.back()));
  for (std::size_t c = 0; c < centres.positions.size(); ++c) {
    const Eigen::Index row = at(system.first[c]);
    system.q(row, 0) = 1;
    system.h[row] = centres.values[c];
    if (linear) system.q.block<1, 3>(row, 1) = centres.positions[c].transpose();
    if (quadratic) fill_quadratic(centres.positions[c], row, centres.has_gradient(c), system.q);
    if (!centres.has_gradient(c)) continue;
    system.q.block(row + 1, 1, 3, 3).setIdentity();
    system.h.segment(row + 1, 3) = centres.gradients[c];
  }
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

FitSystem assemble(const UnitCentres& centres, const FitOptions& options) {
  FitSystem system;
  system.sign = traits(options.kernel).sign;
  system.first = number_unknowns(centres);
  system.a.resize(at(system.first.back()), at(system.first.back()));
  if (takes_gradients(options.kernel)) {
    fill_hermite(centres, options.kernel, system);
  } else {
    fill_values(centres, options.kernel, system);
  }
  add_smoothing(centres, options, system);
  fill_sides(centres, options.kernel, system);
  return system;
}

}  // namespace croquis::implicit
