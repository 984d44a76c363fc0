// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/triangulation/edge_flips.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>

#include "algorithms/hole_filling/triangulation/cancel_check.h"
#include "algorithms/hole_filling/triangulation/edge_pairing.h"
#include "algorithms/hole_filling/triangulation/triangle_cost.h"
#include "croquis/hole_filling/surface_view.h"

namespace croquis::hole_filling {
namespace {

constexpr std::size_t flips_per_triangle = 20;

/// A flip must gain more than rounding, relative to the cost.
constexpr double least_angle_gain = 1e-12;

/// What an impossible triangle or edge counts, so that a flip from two to one of them is a gain.
constexpr double impossible = 1e100;

Index next(Index corner) { return SurfaceView::next(corner); }
Index previous(Index corner) { return SurfaceView::previous(corner); }

class EdgeFlips {
 public:
  EdgeFlips(const RimPolygon& rims, std::vector<std::array<Index, 3>>& triangles, Progress& progress)
      : rims_(rims),
        triangles_(triangles),
        cancel_(progress),
        opposite_(pair_edges(triangles, rims.points.size(), progress).opposite),
        waiting_(opposite_.size(), 1) {
    for (Index corner = 0; corner < opposite_.size(); ++corner) queue_.push_back(corner);
  }

  bool run() {
    std::size_t flips_left = flips_per_triangle * triangles_.size();
    while (!queue_.empty() && flips_left > 0) {
      cancel_.step();
      const Index corner = queue_.front();
      queue_.pop_front();
      waiting_[corner] = 0;
      if (!is_inner(corner) || !gains(corner)) continue;
      flip(corner);
      --flips_left;
    }
    return is_sound();
  }

 private:
  bool is_inner(Index corner) const { return opposite_[corner] < nonmanifold_edge; }
  Index point(Index corner) const { return triangles_[corner / 3][corner % 3]; }

  double cost(Index a, Index b, Index c) const {
    return std::min(impossible, triangle_cost(rims_.points[a], rims_.points[b], rims_.points[c]));
  }
  double edge_cost(Index a, Index b) const { return rims_.is_blocked(a, b) ? impossible : 0; }

  bool gains(Index corner) const {
    const Index a = point(corner), b = point(next(corner)), c = point(previous(corner));
    const Index d = point(previous(opposite_[corner]));
    if (c == d || has_edge(corner, c, d)) return false;
    const double before = cost(a, b, c) + cost(b, a, d) + edge_cost(a, b);
    const double after = cost(a, d, c) + cost(d, b, c) + edge_cost(c, d);
    return after < before * (1 - least_angle_gain);
  }

  /// Whether c and d are joined already on a triangle next to the two: the only place in a strip between two rims.
  bool has_edge(Index corner, Index c, Index d) const {
    for (const Index side : {next(corner), previous(corner)}) {
      if (!is_inner(side)) continue;
      const Index apex = point(previous(opposite_[side]));
      if (apex == d && (point(side) == c || point(next(side)) == c)) return true;
    }
    return false;
  }

  /// Triangles (a,b,c) and (b,a,d) become (a,d,c) and (b,c,d).
  void flip(Index corner) {
    const Index other = opposite_[corner];
    const Index a = point(corner), b = point(next(corner)), c = point(previous(corner));
    const Index d = point(previous(other));
    const std::array<Index, 4> around = {opposite_[next(other)], opposite_[previous(corner)], opposite_[next(corner)],
                                         opposite_[previous(other)]};
    const Index t = corner / 3, u = other / 3;
    triangles_[t] = {a, d, c};
    triangles_[u] = {b, c, d};
    const std::array<Index, 4> places = {3 * t, 3 * t + 2, 3 * u, 3 * u + 2};
    for (std::size_t i = 0; i < 4; ++i) {
      opposite_[places[i]] = around[i];
      if (around[i] < nonmanifold_edge) opposite_[around[i]] = places[i];
      push(places[i]);
    }
    opposite_[3 * t + 1] = 3 * u + 1;
    opposite_[3 * u + 1] = 3 * t + 1;
  }

  void push(Index corner) {
    if (waiting_[corner] != 0) return;
    waiting_[corner] = 1;
    queue_.push_back(corner);
  }

  bool is_sound() const {
    for (Index corner = 0; corner < opposite_.size(); ++corner) {
      if (is_inner(corner) && rims_.is_blocked(point(corner), point(next(corner)))) return false;
    }
    return std::all_of(triangles_.begin(), triangles_.end(),
                       [&](const auto& t) { return cost(t[0], t[1], t[2]) < impossible; });
  }

  const RimPolygon& rims_;
  std::vector<std::array<Index, 3>>& triangles_;
  CancelCheck cancel_;
  std::vector<Index> opposite_;
  std::vector<std::uint8_t> waiting_;
  std::deque<Index> queue_;
};

}  // namespace

bool flip_to_less_area(const RimPolygon& rims, std::vector<std::array<Index, 3>>& triangles, Progress& progress) {
  return EdgeFlips(rims, triangles, progress).run();
}

}  // namespace croquis::hole_filling
