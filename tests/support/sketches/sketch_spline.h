// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/geometry/vector.h"

namespace croquis::test {

/// Interpolating C2 cubic spline with parameter 0..1, natural or periodic.
class Spline {
 public:
  /// Knots at the chord lengths.
  Spline(std::vector<Vec2> points, bool closed);

  /// @param knots rising from 0 to 1, one per point (and 1 last for a closed one)
  Spline(std::vector<Vec2> points, std::vector<double> knots, bool closed);

  Vec2 at(double t) const;  ///< open: the end pieces go on beyond 0 and 1; closed: period 1
  const std::vector<double>& parameters() const { return knots_; }

 private:
  void solve(bool closed);

  std::vector<Vec2> points_;  ///< closed: the first repeated at the end
  std::vector<double> knots_;
  std::vector<Vec2> bend_;  ///< second derivatives
  bool closed_ = false;
};

/// A smooth closed loop through points, sampled about every `spacing`.
std::vector<Vec2> smooth_loop(const std::vector<Vec2>& through, double spacing = 3);

}  // namespace croquis::test
