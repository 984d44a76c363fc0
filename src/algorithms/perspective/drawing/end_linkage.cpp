// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/perspective/drawing/end_linkage.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <unordered_map>

#include "croquis/geometry/disjoint_sets.h"

namespace croquis {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();
constexpr std::size_t largest_matrix = 250;  // ends on one spot, which no drawing has; more are linked in portions

std::uint64_t cell_key(const Vec2& place, double size, int dx, int dy) {
  constexpr double farthest_cell = 1e15;  // so that far places, which share cells then, are numbers of cells at all
  const auto x =
      static_cast<std::int64_t>(std::floor(std::clamp(place.x() / size, -farthest_cell, farthest_cell))) + dx;
  const auto y =
      static_cast<std::int64_t>(std::floor(std::clamp(place.y() / size, -farthest_cell, farthest_cell))) + dy;
  return static_cast<std::uint64_t>(x) * 0x9e3779b97f4a7c15U ^ static_cast<std::uint64_t>(y);
}

/// What can't be joined by any sequence of joins lies in different parts: two clusters whose mean distance is below the
/// limit have a pair of points nearer than that.
std::vector<std::vector<Index>> parts_within(const std::vector<LinkagePoint>& points, double limit) {
  DisjointSets sets(points.size());
  std::unordered_map<std::uint64_t, std::vector<Index>> cells;
  std::unordered_map<Index, Index> first_of_group;
  for (Index i = 0; i < points.size(); ++i) {
    if (points[i].group != no_index) sets.unite(i, first_of_group.try_emplace(points[i].group, i).first->second);
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        const auto cell = cells.find(cell_key(points[i].place, limit, dx, dy));
        if (cell == cells.end()) continue;
        for (const Index j : cell->second) {
          if ((points[i].place - points[j].place).norm() < limit) sets.unite(i, j);
        }
      }
    }
    cells[cell_key(points[i].place, limit, 0, 0)].push_back(i);
  }
  std::map<Index, std::vector<Index>> parts;
  for (Index i = 0; i < points.size(); ++i) parts[sets.root(i)].push_back(i);
  std::vector<std::vector<Index>> result;
  for (auto& [first, part] : parts) {
    for (std::size_t begin = 0; begin < part.size(); begin += largest_matrix) {
      const auto from = part.begin() + static_cast<std::ptrdiff_t>(begin);
      const auto left = static_cast<std::ptrdiff_t>(std::min(largest_matrix, part.size() - begin));
      result.emplace_back(from, from + left);
    }
  }
  return result;
}

/// Clusters of one part, in a matrix of mean distances. Lance and Williams' update: the mean distance of a union is the
/// mean of both by their sizes, and stays infinite where one was.
class LinkageMatrix {
 public:
  LinkageMatrix(const std::vector<LinkagePoint>& points, const std::vector<Index>& part)
      : count_(part.size()),
        distances_(count_ * count_, never),
        sizes_(count_, 1),
        nearest_(count_, 0),
        cluster_(count_) {
    std::iota(cluster_.begin(), cluster_.end(), std::size_t{0});
    for (std::size_t i = 0; i < count_; ++i) {
      for (std::size_t j = 0; j < count_; ++j) {
        if (i != j) distances_[i * count_ + j] = first_distance(points[part[i]], points[part[j]]);
      }
    }
    join_groups(points, part);
    for (std::size_t i = 0; i < count_; ++i) find_nearest(i);
  }

  void join_below(double limit) {
    while (true) {
      std::size_t best = count_;
      for (std::size_t i = 0; i < count_; ++i) {
        if (sizes_[i] > 0 && (best == count_ || nearest_distance(i) < nearest_distance(best))) best = i;
      }
      if (best == count_ || !(nearest_distance(best) < limit)) return;
      const std::size_t other = nearest_[best];
      join(std::min(best, other), std::max(best, other));
      for (std::size_t i = 0; i < count_; ++i) {
        const bool stale = i == std::min(best, other) || nearest_[i] == best || nearest_[i] == other;
        if (sizes_[i] > 0 && stale) find_nearest(i);
      }
    }
  }

  /// The first member of the cluster of a member.
  std::size_t cluster_of(std::size_t member) const { return cluster_[member]; }

 private:
  static double first_distance(const LinkagePoint& a, const LinkagePoint& b) {
    if (a.group != no_index && b.group != no_index && a.group != b.group) return never;
    if (a.owner == b.owner && (a.group == no_index || a.group != b.group)) return never;
    return (a.place - b.place).norm();
  }

  double& distance(std::size_t i, std::size_t j) { return distances_[i * count_ + j]; }
  double nearest_distance(std::size_t i) const { return distances_[i * count_ + nearest_[i]]; }

  void find_nearest(std::size_t i) {
    nearest_[i] = i;  // at distance never
    for (std::size_t j = 0; j < count_; ++j) {
      if (sizes_[j] > 0 && distance(i, j) < nearest_distance(i)) nearest_[i] = j;
    }
  }

  void join_groups(const std::vector<LinkagePoint>& points, const std::vector<Index>& part) {
    std::map<Index, std::size_t> first;
    for (std::size_t i = 0; i < count_; ++i) {
      if (points[part[i]].group == no_index) continue;
      const auto [place, is_first] = first.try_emplace(points[part[i]].group, i);
      if (!is_first) join(place->second, i);
    }
  }

  void join(std::size_t a, std::size_t b) {
    const auto size_a = static_cast<double>(sizes_[a]), size_b = static_cast<double>(sizes_[b]);
    for (std::size_t i = 0; i < count_; ++i) {
      if (i == a || i == b) continue;
      const double mean = (size_a * distance(i, a) + size_b * distance(i, b)) / (size_a + size_b);
      distance(i, a) = distance(a, i) = mean;
    }
    sizes_[a] += sizes_[b];
    sizes_[b] = 0;
    std::ranges::replace(cluster_, b, a);
  }

  std::size_t count_;
  std::vector<double> distances_;
  std::vector<std::size_t> sizes_;    // 0 for clusters that went into others
  std::vector<std::size_t> nearest_;  // the cluster itself when there is none
  std::vector<std::size_t> cluster_;
};

}  // namespace

std::vector<Index> link_nearest(const std::vector<LinkagePoint>& points, double given_limit) {
  const double limit = std::max(given_limit, std::numeric_limits<double>::min());
  std::vector<Index> first(points.size());
  for (const std::vector<Index>& part : parts_within(points, limit)) {
    LinkageMatrix matrix(points, part);
    matrix.join_below(limit);
    for (std::size_t i = 0; i < part.size(); ++i) first[part[i]] = part[matrix.cluster_of(i)];
  }
  std::vector<Index> numbers(points.size(), no_index);
  Index count = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (numbers[first[i]] == no_index) numbers[first[i]] = count++;
    numbers[i] = numbers[first[i]];
  }
  return numbers;
}

}  // namespace croquis
