// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/implicit/local_fit.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "implicit/fit_evaluation.h"
#include "implicit/fit_system.h"
#include "implicit/lanes.h"
#include "implicit/null_space_solver.h"

namespace croquis::implicit {
namespace {

constexpr std::size_t batch = 64;  // points whose scaled copies are kept at once

std::size_t column_count(Kernel kernel) { return takes_gradients(kernel) ? 7 : 4; }

/// Second derivatives of c0 x² + c1 y² + c2 z² + c3 xy + c4 yz + c5 zx.
Eigen::Matrix3d bend_of(const Eigen::Matrix<double, 6, 1>& c) {
  Eigen::Matrix3d bend;
  bend << 2 * c[0], c[3], c[5], c[3], 2 * c[1], c[4], c[5], c[4], 2 * c[2];
  return bend;
}

/// Centres, those with gradients first. @param directed rows that these take, in whole lanes
std::vector<std::size_t> directed_first(const UnitCentres& centres, std::size_t& directed) {
  std::vector<std::size_t> order(centres.positions.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto end =
      std::stable_partition(order.begin(), order.end(), [&](std::size_t c) { return centres.has_gradient(c); });
  directed = whole_lanes(static_cast<std::size_t>(end - order.begin()));
  return order;
}

}  // namespace

LocalFit::LocalFit(const Constraints& constraints, const FitOptions& options) : kernel_(options.kernel) {
  const UnitCentres centres = unit_centres(constraints, options);
  FitSystem system = assemble(centres, options);
  const ConstrainedWeights solved = solve_constrained(system.a, system.q, system.h);
  middle_ = centres.middle;
  size_ = centres.size;
  const Eigen::Index terms = std::min<Eigen::Index>(4, solved.coefficients.size());
  polynomial_.head(terms) = solved.coefficients.head(terms);
  if (solved.coefficients.size() > terms) bend_ = bend_of(solved.coefficients.tail<6>());
  report_.centres = centres.positions.size();
  report_.unknowns = system.first.back();
  report_.merged = centres.merged;
  report_.polynomial_rank = solved.rank;
  report_.rank_revealing = solved.rank_revealing;

  stride_ = whole_lanes(report_.centres);
  columns_.assign(column_count(kernel_) * stride_, 0.0);
  const std::vector<std::size_t> order = directed_first(centres, directed_);
  for (std::size_t row = 0; row < order.size(); ++row) {
    const std::size_t c = order[row];
    for (std::size_t k = 0; k < 3; ++k) columns_[k * stride_ + row] = centres.positions[c][static_cast<int>(k)];
    for (std::size_t k = 0; k < system.first[c + 1] - system.first[c]; ++k)
      columns_[(3 + k) * stride_ + row] = system.sign * solved.weights[static_cast<Eigen::Index>(system.first[c] + k)];
  }
}

void LocalFit::evaluate(std::span<const Vec3> points, std::span<double> values, std::span<Vec3> gradients) const {
  std::array<Vec3, batch> scaled;
  for (std::size_t begin = 0; begin < points.size(); begin += batch) {
    const std::size_t count = std::min(batch, points.size() - begin);
    for (std::size_t i = 0; i < count; ++i) scaled[i] = (points[begin + i] - middle_) / size_;
    const auto part = gradients.empty() ? gradients : gradients.subspan(begin, count);
    evaluate_columns({kernel_, columns_.data(), stride_, directed_}, {scaled.data(), count},
                     values.subspan(begin, count), part);
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 linear = polynomial_.tail<3>(), bend = bend_ * scaled[i];
      values[begin + i] = size_ * (values[begin + i] + (polynomial_[0] + Vec3(linear + 0.5 * bend).dot(scaled[i])));
      if (!part.empty()) part[i] += linear + bend;
    }
  }
}

double LocalFit::value(const Vec3& point) const {
  double value = 0;
  evaluate({&point, 1}, {&value, 1});
  return value;
}

Vec3 LocalFit::gradient(const Vec3& point) const {
  double value = 0;
  Vec3 gradient;
  evaluate({&point, 1}, {&value, 1}, {&gradient, 1});
  return gradient;
}

Field LocalFit::field() const {
  return [this](std::span<const Vec3> points, std::span<double> values, std::span<Vec3> gradients) {
    evaluate(points, values, gradients);
  };
}

std::size_t LocalFit::bytes() const { return sizeof(LocalFit) + columns_.capacity() * sizeof(double); }

std::span<const double> LocalFit::value_weights() const { return {columns_.data() + 3 * stride_, report_.centres}; }

std::vector<Vec3> LocalFit::gradient_weights() const {
  std::vector<Vec3> weights;
  if (!takes_gradients(kernel_)) return weights;
  const double* b = columns_.data() + 4 * stride_;
  for (std::size_t c = 0; c < report_.centres; ++c) weights.emplace_back(b[c], b[stride_ + c], b[2 * stride_ + c]);
  return weights;
}

Eigen::Vector4d LocalFit::polynomial() const {
  const Vec3 linear = polynomial_.tail<3>();
  Eigen::Vector4d model;
  model << size_ * polynomial_[0] - linear.dot(middle_), linear;
  return model;
}

}  // namespace croquis::implicit
