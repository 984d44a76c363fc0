// SPDX-License-Identifier: GPL-3.0-or-later
#include "implicit/octree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace croquis::implicit {
namespace {

unsigned octant(const Vec3& point, const Vec3& middle) {
  return (point.x() >= middle.x() ? 1U : 0U) | (point.y() >= middle.y() ? 2U : 0U) |
         (point.z() >= middle.z() ? 4U : 0U);
}

Box child_cube(const Box& cube, unsigned child) {
  Box part = {cube.low, cube.middle()};
  for (int axis = 0; axis < 3; ++axis) {
    if ((child >> axis & 1U) == 0) continue;
    part.low[axis] = part.high[axis];
    part.high[axis] = cube.high[axis];
  }
  return part;
}

std::size_t cells_with_points(std::span<const Vec3> points, const Box& cube, int depth) {
  std::vector<std::uint64_t> keys;
  keys.reserve(points.size());
  const double count = std::ldexp(1.0, depth);
  for (const Vec3& point : points) {
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double place = std::floor((point[axis] - cube.low[axis]) / cube.size()[axis] * count);
      key = key << 21 | static_cast<std::uint64_t>(std::clamp(place, 0.0, count - 1));
    }
    keys.push_back(key);
  }
  std::sort(keys.begin(), keys.end());
  return static_cast<std::size_t>(std::unique(keys.begin(), keys.end()) - keys.begin());
}

int equal_depth(std::span<const Vec3> points, const Box& cube, const OctreeRule& rule) {
  int depth = 0;
  while (depth < rule.max_depth && points.size() > rule.leaf_points * cells_with_points(points, cube, depth)) ++depth;
  return depth;
}

constexpr double growth = 1.15;  // of the cells, per attempt

struct Candidate {
  std::array<std::int32_t, 3> cell;
  double distance;  // squared, to the middle of the box
  Index index;

  auto operator<=>(const Candidate&) const = default;
};

std::vector<Index> one_per_cell(std::span<const Vec3> positions, const std::vector<Index>& candidates, const Box& box,
                                double cell) {
  std::vector<Candidate> sorted;
  sorted.reserve(candidates.size());
  for (const Index i : candidates) {
    const Vec3 place = (positions[i] - box.low) / cell;
    Candidate candidate = {{}, (positions[i] - box.middle()).squaredNorm(), i};
    for (int axis = 0; axis < 3; ++axis)
      candidate.cell[static_cast<std::size_t>(axis)] = static_cast<std::int32_t>(std::floor(place[axis]));
    sorted.push_back(candidate);
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<Index> kept;
  for (std::size_t i = 0; i < sorted.size(); ++i)
    if (i == 0 || sorted[i].cell != sorted[i - 1].cell) kept.push_back(sorted[i].index);
  return kept;
}

}  // namespace

Octree::Octree(std::span<const Vec3> points, const Box& cube, const OctreeRule& rule) : order_(points.size()) {
  std::iota(order_.begin(), order_.end(), Index{0});
  nodes_.push_back({cube, 0, true});
  OctreeRule used = rule;
  if (rule.equal_leaves) {
    used.max_depth = equal_depth(points, cube, rule);
    used.leaf_points = 0;
    used.is_full = {};
  }
  split(points, 0, 0, points.size(), 0, used);
}

void Octree::split(std::span<const Vec3> points, std::size_t node, std::size_t begin, std::size_t end, int depth,
                   const OctreeRule& rule) {
  const Box cube = nodes_[node].cube;
  const std::size_t count = end - begin;
  const bool is_full = count > rule.leaf_points || (count > 0 && rule.is_full && rule.is_full(cube));
  if (!is_full || depth == rule.max_depth) {
    nodes_[node].first = static_cast<Index>(leaves_.size());
    leaves_.push_back({cube, begin, end});
    return;
  }
  std::array<std::vector<Index>, 8> parts;
  for (std::size_t i = begin; i < end; ++i) parts[octant(points[order_[i]], cube.middle())].push_back(order_[i]);
  const std::size_t first = nodes_.size();
  nodes_[node].first = static_cast<Index>(first);
  nodes_[node].is_leaf = false;
  std::size_t next = begin;
  for (unsigned child = 0; child < 8; ++child) {
    nodes_.push_back({child_cube(cube, child), 0, true});
    std::copy(parts[child].begin(), parts[child].end(), order_.begin() + static_cast<std::ptrdiff_t>(next));
    next += parts[child].size();
  }
  next = begin;
  for (unsigned child = 0; child < 8; ++child) {
    split(points, first + child, next, next + parts[child].size(), depth + 1, rule);
    next += parts[child].size();
  }
}

Index Octree::leaf_at(const Vec3& place) const {
  if (!cube().contains(place)) return no_index;
  const Node* node = &nodes_.front();
  while (!node->is_leaf) node = &nodes_[node->first + octant(place, node->cube.middle())];
  return node->first;
}

std::size_t Octree::bytes() const {
  return nodes_.capacity() * sizeof(Node) + leaves_.capacity() * sizeof(Leaf) + order_.capacity() * sizeof(Index);
}

std::vector<Index> thinned(std::span<const Vec3> positions, std::vector<Index> candidates, const Box& box,
                           std::size_t most) {
  std::sort(candidates.begin(), candidates.end());
  const double side = box.size().maxCoeff();
  if (candidates.size() <= most || !(side > 0)) {
    candidates.resize(std::min(candidates.size(), most));
    return candidates;
  }
  // A surface through the whole box meets about (side / cell)^2 cells; begin with finer ones.
  for (double cell = 0.5 * side / std::sqrt(static_cast<double>(most));; cell *= growth) {
    std::vector<Index> kept = one_per_cell(positions, candidates, box, cell);
    if (kept.size() > most) continue;
    std::sort(kept.begin(), kept.end());
    return kept;
  }
}

}  // namespace croquis::implicit
