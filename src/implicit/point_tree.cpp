// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/implicit/point_tree.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <utility>

#include "croquis/base/parallel.h"

namespace croquis::implicit {
namespace {

constexpr std::size_t leaf_size = 8;
constexpr std::size_t range_size = 8192;  // points that one thread orders by itself

using Found = std::pair<double, Index>;  // squared distance, index: the order of results

/// The best so far, at most `wanted`, the worst on top.
class Nearest {
 public:
  explicit Nearest(std::size_t wanted) : wanted_(wanted) { heap_.reserve(wanted + 1); }

  /// Anything farther can't be among them.
  double reach() const {
    return heap_.size() < wanted_ ? std::numeric_limits<double>::infinity() : heap_.front().first;
  }

  void offer(const Found& found) {
    if (heap_.size() == wanted_ && !(found < heap_.front())) return;
    heap_.push_back(found);
    std::push_heap(heap_.begin(), heap_.end());
    if (heap_.size() <= wanted_) return;
    std::pop_heap(heap_.begin(), heap_.end());
    heap_.pop_back();
  }

  std::vector<Index> sorted() {
    std::sort_heap(heap_.begin(), heap_.end());
    std::vector<Index> indices;
    for (const Found& found : heap_) indices.push_back(found.second);
    return indices;
  }

 private:
  std::size_t wanted_;
  std::vector<Found> heap_;
};

class NearestOne {
 public:
  double reach() const { return found_.first; }
  void offer(const Found& found) { found_ = std::min(found_, found); }
  Index index() const { return found_.second; }

 private:
  Found found_ = {std::numeric_limits<double>::infinity(), no_index};
};

struct TreeView {
  std::span<const Vec3> points;
  std::span<const Index> indices;
  std::span<const unsigned char> axes;
};

template <typename Answer>
void search(const TreeView& tree, std::size_t begin, std::size_t end, const Vec3& place, Answer& nearest) {
  if (end - begin <= leaf_size) {
    for (std::size_t i = begin; i < end; ++i) nearest.offer({(tree.points[i] - place).squaredNorm(), tree.indices[i]});
    return;
  }
  const std::size_t middle = (begin + end) / 2;
  const int axis = tree.axes[middle];
  const double side = place[axis] - tree.points[middle][axis];
  nearest.offer({(tree.points[middle] - place).squaredNorm(), tree.indices[middle]});
  if (side < 0) {
    search(tree, begin, middle, place, nearest);
    if (side * side <= nearest.reach()) search(tree, middle + 1, end, place, nearest);
  } else {
    search(tree, middle + 1, end, place, nearest);
    if (side * side <= nearest.reach()) search(tree, begin, middle, place, nearest);
  }
}

/// Visits the points in the box until `visit` returns false.
/// @return false when it did
template <typename Visit>
bool visit_inside(const TreeView& tree, std::size_t begin, std::size_t end, const Box& box, Visit& visit) {
  if (end - begin <= leaf_size) {
    for (std::size_t i = begin; i < end; ++i)
      if (box.contains(tree.points[i]) && !visit(tree.indices[i])) return false;
    return true;
  }
  const std::size_t middle = (begin + end) / 2;
  const int axis = tree.axes[middle];
  const double split = tree.points[middle][axis];
  if (box.contains(tree.points[middle]) && !visit(tree.indices[middle])) return false;
  if (box.low[axis] <= split && !visit_inside(tree, begin, middle, box, visit)) return false;
  return box.high[axis] < split || visit_inside(tree, middle + 1, end, box, visit);
}

}  // namespace

PointTree::PointTree(std::span<const Vec3> points, int threads, Progress& progress)
    : points_(points.begin(), points.end()), indices_(points.size()), axes_(points.size(), 0) {
  std::iota(indices_.begin(), indices_.end(), Index{0});
  build(threads, progress);
  std::vector<Vec3> ordered;
  ordered.reserve(points_.size());
  for (const Index i : indices_) ordered.push_back(points_[i]);
  points_ = std::move(ordered);
}

PointTree::PointTree(std::span<const Vec3> points, int threads) {
  Progress silent;
  *this = PointTree(points, threads, silent);
}

/// Level by level while ranges are large, all of a level at the same time; then each range to its end.
void PointTree::build(int threads, Progress& progress) {
  using Range = std::array<std::size_t, 2>;
  std::vector<Range> ranges = {{0, points_.size()}};
  while (ranges.front()[1] - ranges.front()[0] > range_size) {
    std::vector<Range> halves(2 * ranges.size());
    Progress splitting = progress.step("order points", 0.1);
    for_each_part(ranges.size(), 1, threads, splitting, [&](std::size_t r, std::size_t) {
      const std::size_t middle = split(ranges[r][0], ranges[r][1]);
      halves[2 * r] = {ranges[r][0], middle};
      halves[2 * r + 1] = {middle + 1, ranges[r][1]};
    });
    ranges = std::move(halves);
  }
  Progress finishing = progress.step("order points", 0.3);
  for_each_part(ranges.size(), 1, threads, finishing,
                [&](std::size_t r, std::size_t) { build_range(ranges[r][0], ranges[r][1]); });
}

void PointTree::build_range(std::size_t begin, std::size_t end) {
  if (end - begin <= leaf_size) return;
  const std::size_t middle = split(begin, end);
  build_range(begin, middle);
  build_range(middle + 1, end);
}

/// Puts the node of the range into its middle, lower points before it.
std::size_t PointTree::split(std::size_t begin, std::size_t end) {
  Box box = {points_[indices_[begin]], points_[indices_[begin]]};
  for (std::size_t i = begin; i < end; ++i) {
    box.low = box.low.cwiseMin(points_[indices_[i]]);
    box.high = box.high.cwiseMax(points_[indices_[i]]);
  }
  int axis = 0;
  box.size().maxCoeff(&axis);
  const std::size_t middle = (begin + end) / 2;
  const auto at = [&](std::size_t i) { return indices_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(middle), at(end), [&](Index a, Index b) {
    return points_[a][axis] != points_[b][axis] ? points_[a][axis] < points_[b][axis] : a < b;
  });
  axes_[middle] = static_cast<unsigned char>(axis);
  return middle;
}

Index PointTree::nearest(const Vec3& place) const {
  NearestOne nearest;
  search({points_, indices_, axes_}, 0, points_.size(), place, nearest);
  return nearest.index();
}

std::vector<Index> PointTree::nearest(const Vec3& place, std::size_t count) const {
  Nearest nearest(std::min(count, points_.size()));
  if (count > 0) search({points_, indices_, axes_}, 0, points_.size(), place, nearest);
  return nearest.sorted();
}

std::vector<Index> PointTree::inside(const Box& box) const {
  std::vector<Index> found;
  const auto take = [&](Index point) {
    found.push_back(point);
    return true;
  };
  visit_inside({points_, indices_, axes_}, 0, points_.size(), box, take);
  std::sort(found.begin(), found.end());
  return found;
}

bool PointTree::holds_more_than(std::size_t most, const Box& box) const {
  std::size_t left = most;
  const auto count = [&](Index) { return left-- > 0; };
  return !visit_inside({points_, indices_, axes_}, 0, points_.size(), box, count);
}

std::size_t PointTree::bytes() const {
  return points_.capacity() * sizeof(Vec3) + indices_.capacity() * sizeof(Index) + axes_.capacity();
}

}  // namespace croquis::implicit
