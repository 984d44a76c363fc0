// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "croquis/geometry/vector.h"

namespace croquis {

/// Where the fits of PiecewiseQuintic read their function in each piece 0..1: the Chebyshev-Lobatto places, so that
/// pieces meet, and a fit is the same from either end.
const std::array<double, 6>& quintic_places();

/// Coefficients of the quintic 1, x … x^5 from its values at quintic_places(), one row per coefficient.
const Eigen::Matrix<double, 6, 6>& quintic_from_values();

/// A quintic path: coefficients of 1, x … x^5, x = 0..1 along it. The fourth row is 0: four numbers are computed with
/// as fast as three.
using QuinticPiece = Eigen::Matrix<double, 4, 6>;

inline Vec3 value_in(const QuinticPiece& c, double x) {
  const Eigen::Vector4d value =
      c.col(0) + x * (c.col(1) + x * (c.col(2) + x * (c.col(3) + x * (c.col(4) + x * c.col(5)))));
  return value.head<3>();
}

/// By x.
inline Vec3 slope_in(const QuinticPiece& c, double x) {
  const Eigen::Vector4d slope =
      c.col(1) + x * (2 * c.col(2) + x * (3 * c.col(3) + x * (4 * c.col(4) + x * (5 * c.col(5)))));
  return slope.head<3>();
}

/// What a quintic has to be at one end: its value and its first two derivatives by x.
struct QuinticEnd {
  Vec3 value = Vec3::Zero();
  Vec3 slope = Vec3::Zero();
  Vec3 bend = Vec3::Zero();
};

QuinticPiece quintic_between(const QuinticEnd& a, const QuinticEnd& b);

/// A smooth path of vectors over 0..1 as quintics on even pieces, fitted to a tolerance. It is read without searching:
/// the turn of normals along a curve costs as little as a polynomial then.
class PiecewiseQuintic {
 public:
  struct Options {
    double tolerance = 1e-12;      ///< in the function's own units
    std::size_t most_pieces = 64;  ///< of each interval, a power of 2
  };

  struct ValueAndSlope {
    Vec3 value;
    Vec3 slope;
  };

  /// @param function of t in 0..1 to Vec3, smooth between breaks
  /// @param breaks   ascending, the first 0, the last 1
  template <class Function>
  PiecewiseQuintic(const Function& function, std::span<const double> breaks, const Options& options) {
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
      if (breaks[i + 1] > breaks[i]) add_interval(function, breaks[i], breaks[i + 1], options);
    }
  }

  Vec3 at(double t) const {
    const Found found = find(t);
    return value_in(*found.piece, found.x);
  }

  ValueAndSlope evaluate(double t) const {
    const Found found = find(t);
    return {value_in(*found.piece, found.x), found.scale * slope_in(*found.piece, found.x)};
  }

  std::size_t byte_size() const {
    return pieces_.capacity() * sizeof(QuinticPiece) + intervals_.capacity() * sizeof(Interval);
  }

 private:
  struct Interval {
    double begin = 0;
    double scale = 1;  ///< pieces per unit of t
    std::size_t first = 0;
    std::size_t count = 1;
  };

  struct Found {
    const QuinticPiece* piece;
    double x;  ///< 0..1 in the piece
    double scale;
  };

  Found find(double t) const {
    std::size_t k = 0;
    while (k + 1 < intervals_.size() && t >= intervals_[k + 1].begin) ++k;
    const Interval& interval = intervals_[k];
    const double x = std::max(0.0, (t - interval.begin) * interval.scale);
    const std::size_t piece = std::min(static_cast<std::size_t>(x), interval.count - 1);
    return {&pieces_[interval.first + piece], x - static_cast<double>(piece), interval.scale};
  }

  template <class Function>
  void add_interval(const Function& function, double begin, double end, const Options& options) {
    Interval interval{begin, 1, pieces_.size(), 2};
    for (;; interval.count *= 2) {
      pieces_.resize(interval.first);
      interval.scale = static_cast<double>(interval.count) / (end - begin);
      const bool last = interval.count >= options.most_pieces;
      if (add_pieces(function, interval, last ? std::numeric_limits<double>::infinity() : options.tolerance)) break;
    }
    intervals_.push_back(interval);
  }

  /// @return false as soon as a piece doesn't keep to the tolerance
  template <class Function>
  bool add_pieces(const Function& function, const Interval& interval, double tolerance) {
    const auto value = [&](std::size_t i, double x) -> Vec3 {
      return function(interval.begin + (static_cast<double>(i) + x) / interval.scale);
    };
    Vec3 end = value(0, 0);
    for (std::size_t i = 0; i < interval.count; ++i) {
      Eigen::Matrix<double, 3, 6> values;
      values.col(0) = end;
      for (int k = 1; k < 6; ++k) values.col(k) = value(i, quintic_places()[static_cast<std::size_t>(k)]);
      end = values.col(5);
      pieces_.push_back(QuinticPiece::Zero());
      pieces_.back().topRows<3>() = values * quintic_from_values().transpose();
      // Where such a fit misses most: in the middle.
      if (tolerance < std::numeric_limits<double>::infinity() &&
          (value_in(pieces_.back(), 0.5) - value(i, 0.5)).norm() > tolerance) {
        return false;
      }
    }
    return true;
  }

  std::vector<Interval> intervals_;
  std::vector<QuinticPiece> pieces_;
};

}  // namespace croquis
