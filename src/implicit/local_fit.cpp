// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/implicit/local_fit.h"

#include <algorithm>
#include <array>

#include "implicit/fit_evaluation.h"
#include "implicit/fit_system.h"
#include "implicit/lanes.h"
#include "implicit/null_space_solver.h"
#include "implicit/unit_centres.h"

namespace croquis::implicit {
namespace {

constexpr std::size_t batch = 64;  // points whose scaled copies are kept at once

std::size_t column_count(Kernel kernel) { return kernel == Kernel::Hermite ? 7 : 4; }

}  // namespace

LocalFit::LocalFit(const Constraints& constraints, const FitOptions& options) : kernel_(options.kernel) {
  const UnitCentres centres = unit_centres(constraints, options);
  FitSystem system = assemble(centres, options);
  const ConstrainedWeights solved = solve_constrained(system.a, system.q, system.h);
  middle_ = centres.middle;
  size_ = centres.size;
  polynomial_.head(solved.coefficients.size()) = solved.coefficients;
  report_.centres = centres.positions.size();
  report_.unknowns = system.first.back();
  report_.merged = centres.merged;
  report_.polynomial_rank = solved.rank;
  report_.rank_revealing = solved.rank_revealing;

  stride_ = whole_lanes(report_.centres);
  columns_.assign(column_count(kernel_) * stride_, 0.0);
  for (std::size_t c = 0; c < report_.centres; ++c) {
    for (std::size_t k = 0; k < 3; ++k) columns_[k * stride_ + c] = centres.positions[c][static_cast<int>(k)];
    for (std::size_t k = 0; k < system.first[c + 1] - system.first[c]; ++k)
      columns_[(3 + k) * stride_ + c] = system.sign * solved.weights[static_cast<Eigen::Index>(system.first[c] + k)];
  }
}

void LocalFit::evaluate(std::span<const Vec3> points, std::span<double> values, std::span<Vec3> gradients) const {
  std::array<Vec3, batch> scaled;
  for (std::size_t begin = 0; begin < points.size(); begin += batch) {
    const std::size_t count = std::min(batch, points.size() - begin);
    for (std::size_t i = 0; i < count; ++i) scaled[i] = (points[begin + i] - middle_) / size_;
    const auto part = gradients.empty() ? gradients : gradients.subspan(begin, count);
    evaluate_columns({kernel_, columns_.data(), stride_}, {scaled.data(), count}, values.subspan(begin, count), part);
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 linear = polynomial_.tail<3>();
      values[begin + i] = size_ * (values[begin + i] + (polynomial_[0] + linear.dot(scaled[i])));
      if (!part.empty()) part[i] += linear;
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
  if (kernel_ != Kernel::Hermite) return weights;
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
