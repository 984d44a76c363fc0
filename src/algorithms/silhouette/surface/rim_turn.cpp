// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/surface/rim_turn.h"

#include <cmath>
#include <vector>

namespace croquis::silhouette {
namespace {

constexpr double turn_reach = 0.8;  // of the radius, to either side; weights fall off linearly

/// The boundary's loops, and what they do at each vertex.
struct RimLoops {
  std::vector<Index> next, previous;  ///< per lifted vertex; no_index inside
  std::vector<double> radius;
  std::vector<double> turn;    ///< angle, positive to the left: around the surface
  std::vector<double> length;  ///< half of the two edges there
};

RimLoops rim_loops(const SheetSampling& sheets) {
  const LiftedTriangulation& lifted = sheets.lifted;
  const std::size_t count = lifted.planar_vertex.size();
  RimLoops loops{std::vector<Index>(count, no_index), std::vector<Index>(count, no_index),
                 std::vector<double>(count, 0.0), std::vector<double>(count, 0.0), std::vector<double>(count, 0.0)};
  for (Index t = 0; t < lifted.triangles.size(); ++t) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      if (lifted.neighbours[t][corner] != no_index) continue;
      const Index begin = lifted.triangles[t][(corner + 1) % 3];
      const Index end = lifted.triangles[t][(corner + 2) % 3];
      loops.next[begin] = end;
      loops.previous[end] = begin;
      loops.radius[begin] = sheets.pieces[sheets.planar.constraints[lifted.planar_triangle[t]][corner]].radius;
    }
  }
  const auto place = [&](Index v) { return sheets.points[lifted.planar_vertex[v]]; };
  for (Index v = 0; v < count; ++v) {
    if (loops.next[v] == no_index) continue;
    const Vec2 before = place(v) - place(loops.previous[v]);
    const Vec2 after = place(loops.next[v]) - place(v);
    loops.turn[v] = std::atan2(cross(before, after), before.dot(after));
    loops.length[v] = (before.norm() + after.norm()) / 2;
  }
  return loops;
}

/// Turning per length around a vertex.
double mean_curvature(const SheetSampling& sheets, const RimLoops& loops, Index vertex) {
  const auto place = [&](Index v) { return sheets.points[sheets.lifted.planar_vertex[v]]; };
  const double far = turn_reach * loops.radius[vertex];
  double turn = loops.turn[vertex];
  double length = loops.length[vertex];
  for (const std::vector<Index>* onward : {&loops.next, &loops.previous}) {
    double distance = 0;
    for (Index v = vertex;;) {
      const Index other = (*onward)[v];
      distance += (place(other) - place(v)).norm();
      if (distance >= far || other == vertex) break;
      turn += (1 - distance / far) * loops.turn[other];
      length += (1 - distance / far) * loops.length[other];
      v = other;
    }
  }
  return turn / length;
}

}  // namespace

Eigen::VectorXd rim_turn(const SheetSampling& sheets) {
  const RimLoops loops = rim_loops(sheets);
  Eigen::VectorXd turns = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(loops.next.size()));
  for (Index v = 0; v < loops.next.size(); ++v) {
    if (loops.next[v] != no_index) turns[v] = mean_curvature(sheets, loops, v) * loops.radius[v];
  }
  return turns;
}

}  // namespace croquis::silhouette
