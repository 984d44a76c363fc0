// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace croquis {

/// Where the fits of PiecewiseQuintic read their function in each piece 0..1: the Chebyshev-Lobatto places, so that
/// pieces meet, and a fit is the same from either end.
const std::array<double, 6>& quintic_places();

/// Coefficients of the quintic 1, x … x^5 from its values at quintic_places(), one row per coefficient.
const Eigen::Matrix<double, 6, 6>& quintic_from_values();

/// A smooth function on 0..1 as quintics on even pieces, fitted to a tolerance. It is read without searching: the
/// inverse of an arc length or the turn of normals along a curve cost as little as a polynomial then.
template <int Dimension>
class PiecewiseQuintic {
 public:
  using Value = Eigen::Matrix<double, Dimension, 1>;
  using Piece = Eigen::Matrix<double, Dimension, 6>;

  struct Options {
    double tolerance = 1e-12;      ///< in the function's own units
    std::size_t most_pieces = 64;  ///< of each interval, a power of 2
  };

  struct ValueAndSlope {
    Value value;
    Value slope;
  };

  /// @param function of t in 0..1 to Value, smooth between breaks
  /// @param breaks   ascending, the first 0, the last 1
  template <class Function>
  PiecewiseQuintic(const Function& function, std::span<const double> breaks, const Options& options) {
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
      if (breaks[i + 1] > breaks[i]) add_interval(function, breaks[i], breaks[i + 1], options);
    }
  }

  /// Whether every piece keeps to the tolerance.
  bool kept() const { return kept_; }

  Value at(double t) const {
    const Found found = find(t);
    return value_in(*found.piece, found.x);
  }

  ValueAndSlope evaluate(double t) const {
    const Found found = find(t);
    const Piece& c = *found.piece;
    const double x = found.x;
    const Value slope = c.col(1) + x * (2 * c.col(2) + x * (3 * c.col(3) + x * (4 * c.col(4) + x * (5 * c.col(5)))));
    return {value_in(c, x), found.scale * slope};
  }

  std::size_t byte_size() const {
    return pieces_.capacity() * sizeof(Piece) + intervals_.capacity() * sizeof(Interval);
  }

 private:
  struct Interval {
    double begin = 0;
    double scale = 1;  ///< pieces per unit of t
    std::size_t first = 0;
    std::size_t count = 1;
  };

  struct Found {
    const Piece* piece;
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
      const bool kept = add_pieces(function, interval, options.tolerance);
      if (!kept && interval.count < options.most_pieces) continue;
      kept_ = kept_ && kept;
      break;
    }
    intervals_.push_back(interval);
  }

  template <class Function>
  bool add_pieces(const Function& function, const Interval& interval, double tolerance) {
    bool kept = true;
    const auto place = [&](std::size_t i, double x) {
      return interval.begin + (static_cast<double>(i) + x) / interval.scale;
    };
    for (std::size_t i = 0; i < interval.count; ++i) {
      Piece values;
      for (int k = 0; k < 6; ++k) values.col(k) = function(place(i, quintic_places()[static_cast<std::size_t>(k)]));
      const Piece piece = values * quintic_from_values().transpose();
      pieces_.push_back(piece);
      // The two gaps where such a fit misses most.
      for (const double x : {0.22, 0.5})
        kept = kept && (value_in(piece, x) - function(place(i, x))).norm() <= tolerance;
      if (!kept && interval.count < 64) return false;
    }
    return kept;
  }

  static Value value_in(const Piece& c, double x) {
    return c.col(0) + x * (c.col(1) + x * (c.col(2) + x * (c.col(3) + x * (c.col(4) + x * c.col(5)))));
  }

  std::vector<Interval> intervals_;
  std::vector<Piece> pieces_;
  bool kept_ = true;
};

}  // namespace croquis
