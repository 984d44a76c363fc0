// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <iterator>
#include <optional>

#include "croquis/geometry/disjoint_sets.h"
#include "croquis/geometry/polyline.h"
#include "io/tracing/tracing.h"

namespace croquis::tracing {
namespace {

/// Whether the mask is as connected without the pixel as with it (Yokoi's number is 1), which isn't the end of a line.
bool can_go(const Mask& mask, const Pixel& pixel) {
  std::array<int, 8> set;
  int count = 0;
  for (int d = 0; d < 8; ++d) {
    const Pixel p = neighbour(pixel, d);
    set[static_cast<std::size_t>(d)] = mask.at_or_empty(p.x, p.y);
    count += set[static_cast<std::size_t>(d)];
  }
  if (count < 2) return false;
  int connected = 0;
  for (std::size_t d = 0; d < 8; d += 2) {
    if (set[d] == 0 && (set[d + 1] != 0 || set[(d + 2) % 8] != 0)) ++connected;
  }
  return connected == 1;
}

/// Removes from each side in turn what lies on the border there: all at once, lines of two pixels would be eaten up
/// from their ends. @return whether anything went
bool remove_borders(Mask& mask, const std::vector<Pixel>& pixels) {
  bool has_changed = false;
  for (const int side : {6, 2, 4, 0}) {
    std::vector<Pixel> border;
    std::ranges::copy_if(pixels, std::back_inserter(border), [&](const Pixel& pixel) {
      const Pixel beside = neighbour(pixel, side);
      return mask.at(pixel.x, pixel.y) != 0 && mask.at_or_empty(beside.x, beside.y) == 0;
    });
    for (const Pixel& pixel : border) {
      if (!can_go(mask, pixel)) continue;
      mask.at(pixel.x, pixel.y) = 0;
      has_changed = true;
    }
  }
  return has_changed;
}

}  // namespace

PixelGrid<int> distances_to_outside(const Mask& mask) {
  PixelGrid<int> distances(mask.width, mask.height);
  const auto pass = [&](int x, int y, std::size_t first) {
    int& nearest = distances.at(x, y);
    if (mask.at(x, y) == 0) return;
    if (first == 4) nearest = pixel_step * (mask.width + mask.height);
    for (std::size_t d = first; d < first + 4; ++d) {
      const Pixel p = neighbour({x, y}, static_cast<int>(d));
      nearest = std::min(nearest, distances.at_or_empty(p.x, p.y) + pixel_step + static_cast<int>(d % 2));
    }
  };
  for (int y = 0; y < mask.height; ++y) {
    for (int x = 0; x < mask.width; ++x) pass(x, y, 4);
  }
  for (int y = mask.height - 1; y >= 0; --y) {
    for (int x = mask.width - 1; x >= 0; --x) pass(x, y, 0);
  }
  return distances;
}

Mask thinned(const Mask& mask, const PixelGrid<int>& distances) {
  std::vector<std::vector<Pixel>> layers;
  for (int y = 0; y < mask.height; ++y) {
    for (int x = 0; x < mask.width; ++x) {
      const auto layer = static_cast<std::size_t>(distances.at(x, y));
      if (layer == 0) continue;
      if (layer >= layers.size()) layers.resize(layer + 1);
      layers[layer].push_back({x, y});
    }
  }
  Mask result = mask;
  for (const std::vector<Pixel>& layer : layers) {
    // What goes may let others of its layer go.
    while (remove_borders(result, layer)) {
    }
  }
  return result;
}

namespace {

constexpr double spur_length = 1.6;  // half widths of the line that it leaves
constexpr double link_length = 2;    // half widths of the wider node
constexpr double slanting_link = 9;  // the same where two lines cross at a small angle
constexpr double least_ahead = 0.6;  // cosine between such a link and the lines that it joins
constexpr double spare_pixels = 2;   // by which either may be longer

Vec2 place_of(const Pixel& pixel) { return {pixel.x, pixel.y}; }

/// Follows the pixels of a thin mask.
class SkeletonWalk {
 public:
  SkeletonWalk(const Mask& thin, const PixelGrid<int>& distances)
      : thin_(thin), distances_(distances), node_(thin.width, thin.height, no_index), seen_(thin.width, thin.height) {}

  Skeleton run() {
    for_each_pixel([&](const Pixel& p) {
      if (degree(p) > 2 && node_.at(p.x, p.y) == no_index) add_node(p);
    });
    for_each_pixel([&](const Pixel& p) {
      if (is_open(p) && open_neighbours(p) < 2) add_branch(p, false);
    });
    for_each_pixel([&](const Pixel& p) {
      if (is_open(p)) add_branch(p, true);
    });
    return std::move(skeleton_);
  }

 private:
  template <typename Action>
  void for_each_pixel(const Action& action) const {
    for (int y = 0; y < thin_.height; ++y) {
      for (int x = 0; x < thin_.width; ++x) {
        if (thin_.at(x, y) != 0) action(Pixel{x, y});
      }
    }
  }

  int degree(const Pixel& pixel) const {
    int count = 0;
    for (int d = 0; d < 8; ++d) {
      const Pixel p = neighbour(pixel, d);
      count += thin_.at_or_empty(p.x, p.y);
    }
    return count;
  }

  /// Whether the pixel belongs to a branch that isn't followed yet.
  bool is_open(const Pixel& p) const {
    return thin_.at_or_empty(p.x, p.y) != 0 && node_.at(p.x, p.y) == no_index && seen_.at(p.x, p.y) == 0;
  }

  int open_neighbours(const Pixel& pixel) const {
    int count = 0;
    for (int d = 0; d < 8; ++d) count += is_open(neighbour(pixel, d)) ? 1 : 0;
    return count;
  }

  /// Pixels with more than two neighbours that touch are one node.
  void add_node(const Pixel& first) {
    const auto number = static_cast<Index>(skeleton_.nodes.size());
    SkeletonNode node;
    std::vector<Pixel> pixels{first};
    node_.at(first.x, first.y) = number;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      const Pixel pixel = pixels[i];
      node.place += place_of(pixel);
      const double half_width = static_cast<double>(distances_.at(pixel.x, pixel.y)) / pixel_step;
      node.half_width = std::max(node.half_width, half_width);
      for (int d = 0; d < 8; ++d) {
        const Pixel p = neighbour(pixel, d);
        if (thin_.at_or_empty(p.x, p.y) == 0 || node_.at(p.x, p.y) != no_index || degree(p) < 3) continue;
        node_.at(p.x, p.y) = number;
        pixels.push_back(p);
      }
    }
    node.place /= static_cast<double>(pixels.size());
    skeleton_.nodes.push_back(node);
  }

  void add_branch(const Pixel& first, bool closed) {
    Branch branch;
    std::vector<Pixel> pixels;
    for (std::optional<Pixel> next = first; next;) {
      const Pixel pixel = *next;
      pixels.push_back(pixel);
      seen_.at(pixel.x, pixel.y) = 1;
      next.reset();
      for (int d = 0; d < 8 && !next; ++d) {
        if (is_open(neighbour(pixel, d))) next = neighbour(pixel, d);
      }
    }
    std::ranges::transform(pixels, std::back_inserter(branch.points), place_of);
    branch.closed = closed;
    if (!closed) {
      branch.nodes[0] = node_beside(pixels.front(), 0);
      branch.nodes[1] = node_beside(pixels.back(), pixels.size() == 1 ? 1 : 0);
    }
    skeleton_.branches.push_back(std::move(branch));
  }

  /// The node that touches the pixel: the first, or the one after it.
  Index node_beside(const Pixel& pixel, int skipped) const {
    for (int d = 0; d < 8; ++d) {
      const Pixel p = neighbour(pixel, d);
      if (node_.has(p.x, p.y) && node_.at(p.x, p.y) != no_index && skipped-- == 0) return node_.at(p.x, p.y);
    }
    return no_index;
  }

  const Mask& thin_;
  const PixelGrid<int>& distances_;
  PixelGrid<Index> node_;
  Mask seen_;
  Skeleton skeleton_;
};

/// Whether a branch is a spur: one end is free, the other one at a line whose ink it hardly leaves.
bool is_spur(const Skeleton& skeleton, const Branch& branch, const std::vector<std::vector<Index>>& ends) {
  const auto is_free = [&](std::size_t side) {
    return branch.nodes[side] == no_index || ends[branch.nodes[side]].size() < 2;
  };
  if (branch.closed || is_free(0) == is_free(1)) return false;
  const Index node = branch.nodes[is_free(0) ? 1 : 0];
  const double reach = spur_length * skeleton.nodes[node].half_width + spare_pixels;
  return ends[node].size() > 2 && length(branch.points, false) + 1 < reach;
}

bool remove_spurs(Skeleton& skeleton) {
  const auto ends = ends_at_nodes(skeleton);
  return std::erase_if(skeleton.branches, [&](const Branch& branch) { return is_spur(skeleton, branch, ends); }) > 0;
}

/// Whether two lines that cross at a small angle share a branch: all four go on ahead where it ends.
bool is_slanting_link(const Skeleton& skeleton, const Branch& link, const std::vector<std::vector<Index>>& ends) {
  const Vec2 along = skeleton.nodes[link.nodes[1]].place - skeleton.nodes[link.nodes[0]].place;
  for (const std::size_t side : {0U, 1U}) {
    const Index node = link.nodes[side];
    if (ends[node].size() != 3) return false;
    for (const Index end : ends[node]) {
      const Branch& other = skeleton.branches[end / 2];
      if (&other == &link) continue;
      const std::size_t reach = std::min<std::size_t>(other.points.size() - 1, 10);
      const Vec2 out =
          other.points[end % 2 == 0 ? reach : other.points.size() - 1 - reach] - skeleton.nodes[node].place;
      if ((side == 0 ? -1 : 1) * out.dot(along) < least_ahead * out.norm() * along.norm()) return false;
    }
  }
  return true;
}

/// Whether a branch between two nodes stands for no line of its own.
bool is_link(const Skeleton& skeleton, const Branch& branch, const std::vector<std::vector<Index>>& ends) {
  const auto [a, b] = branch.nodes;
  if (a == no_index || b == no_index) return false;
  const double width = std::max(skeleton.nodes[a].half_width, skeleton.nodes[b].half_width);
  const double own = length(branch.points, false) + 1;
  if (own < link_length * width + spare_pixels) return true;
  return a != b && own < slanting_link * width && is_slanting_link(skeleton, branch, ends);
}

/// Makes one node of those that links join.
void merge_nodes(Skeleton& skeleton) {
  DisjointSets sets(skeleton.nodes.size());
  const auto ends = ends_at_nodes(skeleton);
  std::vector<bool> links;
  for (const Branch& branch : skeleton.branches) links.push_back(is_link(skeleton, branch, ends));
  std::vector<Branch> left;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const Branch& branch = skeleton.branches[i];
    if (links[i])
      sets.unite(branch.nodes[0], branch.nodes[1]);
    else
      left.push_back(branch);
  }
  std::vector<Index> numbers;
  std::vector<SkeletonNode> merged(sets.number(numbers));
  std::vector<double> counts(merged.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    merged[numbers[i]].place += skeleton.nodes[i].place;
    ++counts[numbers[i]];
  }
  for (std::size_t i = 0; i < merged.size(); ++i) merged[i].place /= counts[i];
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    SkeletonNode& node = merged[numbers[i]];
    const double reach = (skeleton.nodes[i].place - node.place).norm() + skeleton.nodes[i].half_width;
    node.half_width = std::max(node.half_width, reach);
  }
  for (Branch& branch : left) {
    for (Index& node : branch.nodes) node = node == no_index ? no_index : numbers[node];
  }
  skeleton = {std::move(merged), std::move(left)};
}

}  // namespace

std::vector<std::vector<Index>> ends_at_nodes(const Skeleton& skeleton) {
  std::vector<std::vector<Index>> ends(skeleton.nodes.size());
  for (std::size_t i = 0; i < skeleton.branches.size(); ++i) {
    for (const std::size_t side : {0U, 1U}) {
      const Index node = skeleton.branches[i].nodes[side];
      if (node != no_index) ends[node].push_back(end_at(i, side));
    }
  }
  return ends;
}

Skeleton skeleton_of(const Mask& thin, const PixelGrid<int>& distances) { return SkeletonWalk(thin, distances).run(); }

Skeleton simplified(Skeleton skeleton) {
  while (remove_spurs(skeleton)) {
  }
  merge_nodes(skeleton);
  while (remove_spurs(skeleton)) {
  }
  return skeleton;
}

}  // namespace croquis::tracing
