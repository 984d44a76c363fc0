// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/attribute_surface/curves/arc_lengths.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "algorithms/attribute_surface/curves/bezier.h"

namespace croquis {
namespace {

// Gauss-Legendre quadrature of 8 points on -1..1, half of them (Abramowitz and Stegun, table 25.4).
constexpr std::array<double, 4> gauss_places{0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                             0.9602898564975363};
constexpr std::array<double, 4> gauss_weights{0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                              0.1012285362903763};

/// Parts are halved until halving changes them by less than this part of the curve.
constexpr double quadrature_tolerance = 1e-14;
constexpr int deepest_halving = 24;

}  // namespace

ArcLengths::ArcLengths(const std::vector<Vec3>& control) : derivative_(bezier_derivative(control)) {
  for (std::size_t i = 0; i + 1 < control.size(); ++i) scale_ += (control[i + 1] - control[i]).norm();
  ends_.push_back(0);
  sums_.push_back(0);
  add_parts(0, 0.5, quadrature(0, 0.5), 1);
  add_parts(0.5, 1, quadrature(0.5, 1), 1);
}

double ArcLengths::speed(double t) const { return bezier_at(derivative_, t).norm(); }

double ArcLengths::quadrature(double from, double to) const {
  const double middle = 0.5 * (from + to);
  const double half = 0.5 * (to - from);
  double sum = 0;
  for (std::size_t i = 0; i < gauss_places.size(); ++i) {
    sum += gauss_weights[i] * (speed(middle - half * gauss_places[i]) + speed(middle + half * gauss_places[i]));
  }
  return half * sum;
}

void ArcLengths::add_parts(double from, double to, double length, int depth) {
  const double middle = 0.5 * (from + to);
  const double first = quadrature(from, middle);
  const double second = quadrature(middle, to);
  if (depth < deepest_halving && std::abs(first + second - length) > quadrature_tolerance * scale_) {
    add_parts(from, middle, first, depth + 1);
    add_parts(middle, to, second, depth + 1);
    return;
  }
  ends_.push_back(middle);
  sums_.push_back(sums_.back() + first);
  ends_.push_back(to);
  sums_.push_back(sums_.back() + second);
}

double ArcLengths::to(double t) const {
  const auto next = std::ranges::upper_bound(ends_, t);
  const auto part = static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, next - ends_.begin()) - 1);
  if (part + 1 >= ends_.size()) return whole();
  return t <= ends_[part] ? sums_[part] : sums_[part] + quadrature(ends_[part], t);
}

double ArcLengths::parameter(double length) const {
  const auto next = std::ranges::upper_bound(sums_, length);
  if (next == sums_.begin()) return 0;
  if (next == sums_.end()) return 1;
  const auto part = static_cast<std::size_t>(next - sums_.begin()) - 1;
  const double share = (length - sums_[part]) / (sums_[part + 1] - sums_[part]);
  return parameter(length, ends_[part] + (ends_[part + 1] - ends_[part]) * share);
}

double ArcLengths::parameter(double length, double guess) const {
  const auto next = std::ranges::upper_bound(sums_, length);
  if (next == sums_.begin()) return 0;
  if (next == sums_.end()) return 1;
  const auto part = static_cast<std::size_t>(next - sums_.begin()) - 1;
  double low = ends_[part];
  double high = ends_[part + 1];
  double t = std::clamp(guess, low, high);
  // Newton's steps, and halves of the bracket where the curve hardly moves.
  for (int i = 0; i < 60; ++i) {
    const double excess = sums_[part] + quadrature(ends_[part], t) - length;
    if (std::abs(excess) <= 4e-16 * scale_) break;
    (excess > 0 ? high : low) = t;
    const double v = speed(t);
    double better = v > 0 ? t - excess / v : high;
    const bool inside = better > low - 1e-12 && better < high + 1e-12;  // of a part whose end is sought, about there
    better = inside ? std::clamp(better, low, high) : 0.5 * (low + high);
    const double step = std::abs(better - t);
    t = better;
    if (step <= 1e-9) break;  // the next one would be about its square
  }
  return t;
}

}  // namespace croquis
