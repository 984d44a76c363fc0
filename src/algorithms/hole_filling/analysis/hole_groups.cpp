// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/hole_filling/hole_groups.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Geometry>

namespace croquis::hole_filling {
namespace {

using Box = Eigen::AlignedBox3d;

Box grown_box(const PolyMesh& mesh, const Hole& hole) {
  Box box;
  for (const Index vertex : hole.vertices) box.extend(mesh.positions[vertex]);
  // The same in all directions: per axis, parallel flat rims would stay apart however near they are.
  const Vec3 reach = Vec3::Constant(hole.diameter / 2);
  return {box.min() - reach, box.max() + reach};
}

/// A tree over boxes, each node the middle of a range of `order_`; finds which boxes meet one.
class BoxTree {
 public:
  explicit BoxTree(const std::vector<Box>& boxes) : boxes_(boxes), order_(boxes.size()), bounds_(boxes.size()) {
    std::iota(order_.begin(), order_.end(), Index{0});
    build(0, order_.size());
  }

  template <typename Visit>
  void visit(const Box& box, Visit&& found) const {
    descend(0, order_.size(), box, found);
  }

 private:
  Box build(std::size_t begin, std::size_t end) {
    if (begin == end) return {};
    Box bounds;
    for (std::size_t i = begin; i < end; ++i) bounds.extend(boxes_[order_[i]]);
    Eigen::Index axis = 0;
    bounds.sizes().maxCoeff(&axis);
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end), [&](Index a, Index b) {
      return std::pair(boxes_[a].center()[axis], a) < std::pair(boxes_[b].center()[axis], b);
    });
    bounds_[middle] = bounds;
    build(begin, middle);
    build(middle + 1, end);
    return bounds;
  }

  template <typename Visit>
  void descend(std::size_t begin, std::size_t end, const Box& box, Visit& found) const {
    if (begin == end) return;
    const std::size_t middle = begin + (end - begin) / 2;
    if (!bounds_[middle].intersects(box)) return;
    if (boxes_[order_[middle]].intersects(box)) found(order_[middle]);
    descend(begin, middle, box, found);
    descend(middle + 1, end, box, found);
  }

  const std::vector<Box>& boxes_;
  std::vector<Index> order_;
  std::vector<Box> bounds_;  ///< of the range whose middle it is
};

}  // namespace

std::vector<std::vector<Index>> HoleGroups::lists() {
  std::vector<std::vector<Index>> members(count_);
  for (Index hole = 0; hole < count_; ++hole) members[group(hole)].push_back(hole);
  std::erase_if(members, [](const auto& group) { return group.empty(); });
  return members;
}

bool are_compatible(const Hole& a, const Hole& b) {
  return a.rim_normals.axis.dot(b.rim_normals.axis) >= std::cos(greatest_group_angle);
}

std::vector<std::array<Index, 2>> near_pairs(const PolyMesh& mesh, std::span<const Hole> holes) {
  std::vector<Box> boxes;
  boxes.reserve(holes.size());
  for (const Hole& hole : holes) boxes.push_back(grown_box(mesh, hole));
  const BoxTree tree(boxes);
  std::vector<std::array<Index, 2>> pairs;
  for (Index low = 0; low < boxes.size(); ++low) {
    tree.visit(boxes[low], [&](Index high) {
      if (low < high) pairs.push_back({low, high});
    });
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace croquis::hole_filling
