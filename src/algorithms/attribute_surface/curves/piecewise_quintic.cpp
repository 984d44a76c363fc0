// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/attribute_surface/curves/piecewise_quintic.h"

#include <numbers>

#include <Eigen/LU>

namespace croquis {
namespace {

std::array<double, 6> make_places() {
  std::array<double, 6> result{};
  for (std::size_t k = 0; k < 6; ++k) result[k] = 0.5 - 0.5 * std::cos(std::numbers::pi * static_cast<double>(k) / 5);
  result[0] = 0;
  result[5] = 1;
  return result;
}

Eigen::Matrix<double, 6, 6> make_matrix() {
  Eigen::Matrix<double, 6, 6> powers;
  for (int row = 0; row < 6; ++row) {
    for (int column = 0; column < 6; ++column) {
      powers(row, column) = std::pow(quintic_places()[static_cast<std::size_t>(row)], column);
    }
  }
  return powers.inverse();
}

}  // namespace

const std::array<double, 6>& quintic_places() {
  static const std::array<double, 6> places = make_places();
  return places;
}

const Eigen::Matrix<double, 6, 6>& quintic_from_values() {
  static const Eigen::Matrix<double, 6, 6> matrix = make_matrix();
  return matrix;
}

QuinticPiece quintic_between(const QuinticEnd& a, const QuinticEnd& b) {
  const Vec3 rise = b.value - a.value - a.slope - 0.5 * a.bend;
  const Vec3 turn = b.slope - a.slope - a.bend;
  const Vec3 bend = 0.5 * (b.bend - a.bend);
  QuinticPiece piece = QuinticPiece::Zero();
  piece.topRows<3>() << a.value, a.slope, 0.5 * a.bend, 10 * rise - 4 * turn + bend, -15 * rise + 7 * turn - 2 * bend,
      6 * rise - 3 * turn + bend;
  return piece;
}

}  // namespace croquis
