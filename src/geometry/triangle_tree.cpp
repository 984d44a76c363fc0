// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/geometry/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace croquis {
namespace {

/// Triangles; smaller parts of a tree are built in some milliseconds, without checking the cancel flag.
constexpr std::size_t triangles_per_step = 16384;

/// So that rounding leaves out no foot at the same distance.
constexpr double slack = 1 + 1e-12;

TriangleFoot foot_on_edge(const Vec3& a, const Vec3& b, int edge, const Vec3& place) {
  const Vec3 along = b - a;
  const double squared = along.squaredNorm();
  const double t = squared > 0 ? std::clamp((place - a).dot(along) / squared, 0.0, 1.0) : 0.0;
  TriangleFoot foot;
  foot.point = t == 1 ? b : Vec3(a + t * along);
  foot.distance = (place - foot.point).norm();
  if (t == 0)
    foot.corner = edge;
  else if (t == 1)
    foot.corner = (edge + 1) % 3;
  else
    foot.edge = edge;
  return foot;
}

}  // namespace

TriangleFoot foot_on_triangle(const std::array<Vec3, 3>& triangle, const Vec3& place) {
  const auto& [a, b, c] = triangle;
  const Vec3 normal = (b - a).cross(c - a);
  const double squared = normal.squaredNorm();
  const bool is_over = squared > 0 && normal.dot((b - a).cross(place - a)) > 0 &&
                       normal.dot((c - b).cross(place - b)) > 0 && normal.dot((a - c).cross(place - c)) > 0;
  if (is_over) {
    TriangleFoot foot;
    const Vec3 away = normal.dot(place - a) / squared * normal;
    foot.point = place - away;
    foot.distance = away.norm();
    return foot;
  }
  TriangleFoot best = foot_on_edge(a, b, 0, place);
  for (const TriangleFoot& other : {foot_on_edge(b, c, 1, place), foot_on_edge(c, a, 2, place)}) {
    if (other.distance < best.distance) best = other;
  }
  return best;
}

TriangleTree::TriangleTree(std::vector<std::array<Vec3, 3>> triangles, const Progress& progress)
    : triangles_(std::move(triangles)), order_(triangles_.size()), bounds_(triangles_.size()) {
  std::iota(order_.begin(), order_.end(), Index{0});
  build(0, order_.size(), progress);
}

void TriangleTree::build(std::size_t begin, std::size_t end, const Progress& progress) {
  if (begin == end) return;
  if (end - begin > triangles_per_step) progress.check();
  Eigen::AlignedBox3d bounds;
  for (std::size_t i = begin; i < end; ++i) {
    for (const Vec3& corner : triangles_[order_[i]]) bounds.extend(corner);
  }
  Eigen::Index axis = 0;
  bounds.sizes().maxCoeff(&axis);
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  const auto place = [&](Index t) {
    return std::pair(triangles_[t][0][axis] + triangles_[t][1][axis] + triangles_[t][2][axis], t);
  };
  std::nth_element(at(begin), at(middle), at(end), [&](Index a, Index b) { return place(a) < place(b); });
  bounds_[middle] = bounds;
  build(begin, middle, progress);
  build(middle + 1, end, progress);
}

TriangleFoot TriangleTree::nearest(const Vec3& place, double farthest, const Filter& counts) const {
  TriangleFoot best;
  best.distance = farthest;
  descend(0, order_.size(), place, counts, best);
  return best;
}

void TriangleTree::offer(Index t, const Vec3& place, const Filter& counts, TriangleFoot& best) const {
  const auto& [a, b, c] = triangles_[t];
  const Eigen::AlignedBox3d box(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c));
  if (box.squaredExteriorDistance(place) > slack * best.distance * best.distance) return;  // cheaper than the foot
  TriangleFoot foot = foot_on_triangle(triangles_[t], place);
  if (foot.distance > best.distance || (foot.distance == best.distance && t >= best.triangle)) return;
  if (counts && !counts(t)) return;
  foot.triangle = t;
  best = foot;
}

void TriangleTree::descend(std::size_t begin, std::size_t end, const Vec3& place, const Filter& counts,
                           TriangleFoot& best) const {
  if (begin == end) return;
  const std::size_t middle = begin + (end - begin) / 2;
  if (bounds_[middle].squaredExteriorDistance(place) > best.distance * best.distance) return;
  offer(order_[middle], place, counts, best);
  const auto distance_to = [&](std::size_t from, std::size_t to) {
    return from == to ? 0 : bounds_[from + (to - from) / 2].squaredExteriorDistance(place);
  };
  if (distance_to(middle + 1, end) < distance_to(begin, middle)) {
    descend(middle + 1, end, place, counts, best);
    descend(begin, middle, place, counts, best);
  } else {
    descend(begin, middle, place, counts, best);
    descend(middle + 1, end, place, counts, best);
  }
}

}  // namespace croquis
