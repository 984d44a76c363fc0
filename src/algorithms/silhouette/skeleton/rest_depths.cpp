// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/skeleton/rest_depths.h"

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/strong_components.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <tuple>
#include <utility>

#include "croquis/solver/least_squares.h"
#include "croquis/solver/sparse_rows.h"

namespace croquis::silhouette {

OverlapCycles overlap_cycles(const std::vector<std::vector<Index>>& below) {
  boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS> graph(below.size());
  for (std::size_t object = 0; object < below.size(); ++object) {
    for (const Index lower : below[object]) boost::add_edge(object, lower, graph);
  }
  OverlapCycles cycles;
  cycles.cycle.resize(below.size());
  const auto cycle = boost::make_iterator_property_map(cycles.cycle.begin(), get(boost::vertex_index, graph));
  cycles.count = boost::strong_components(graph, cycle);
  return cycles;
}

namespace {

/// In L: so much more than rows demand that none of them presses on a flat object.
constexpr double rest_clearance = 1e-4;

/// Weights against that of two objects' difference.
constexpr double plane_weight = 1;  // of the whole figure, times the weight of distance; settles where all of it lies
constexpr double like_weight = 10;

// How unlike parts may be that count as alike: radius and area of the larger one by the smaller one's.
constexpr double like_radius = 1.4;
constexpr double like_area = 2;

/// In the thinner one's radius: joined parts that are farther apart than they need, or reach, are no longer taken to
/// meet.
constexpr double pushed_away = 0.1;

struct ObjectSize {
  double radius = 0;
  double area = 0;
};

std::vector<ObjectSize> object_sizes(const Skeleton& skeleton) {
  std::vector<ObjectSize> sizes;
  for (const double radius : object_radii(skeleton)) sizes.push_back({radius, std::numbers::pi * radius * radius});
  for (const auto& [i, k] : skeleton.edges) {
    const SkeletonNode& a = skeleton.nodes[i];
    const SkeletonNode& b = skeleton.nodes[k];
    sizes[a.object].area += (a.position - b.position).norm() * (a.radius + b.radius);
  }
  return sizes;
}

/// A part that lies before or behind a body.
struct BodyPart {
  Index part = 0;
  int side = 1;       ///< 1 before, -1 behind
  ObjectBound bound;  ///< distance from the body
  bool joined = false;
};

using BodyParts = std::vector<BodyPart>;

/// Parts of one body that are about as wide and as large as each other, and held in the same way; groups of one part
/// are left out.
std::vector<BodyParts> like_groups(BodyParts parts, const std::vector<ObjectSize>& sizes) {
  std::ranges::sort(parts, {}, [&](const BodyPart& one) {
    return std::tuple(sizes[one.part].radius, sizes[one.part].area, one.part);
  });
  const auto alike = [&](const BodyPart& a, const BodyPart& b) {
    const auto [small, large] = std::minmax(sizes[a.part].area, sizes[b.part].area);
    return a.joined == b.joined && sizes[b.part].radius <= like_radius * sizes[a.part].radius &&
           large <= like_area * small;
  };
  std::vector<BodyParts> groups;
  for (const BodyPart& part : parts) {
    const auto group = std::find_if(groups.begin(), groups.end(),
                                    [&](const BodyParts& members) { return alike(members.front(), part); });
    (group == groups.end() ? groups.emplace_back() : *group).push_back(part);
  }
  std::erase_if(groups, [](const BodyParts& group) { return group.size() < 2; });
  return groups;
}

/// One height per cycle, in L.
class RestProblem {
 public:
  RestProblem(const Skeleton& skeleton, const ObjectBounds& bounds, const DepthSettings& settings)
      : scale_(skeleton.scale), sizes_(object_sizes(skeleton)), bounds_(bounds), settings_(settings) {
    below_.resize(sizes_.size());
    for (const auto& [pair, bound] : bounds_) below_[pair.first].push_back(pair.second);
  }

  std::vector<double> solve(Progress& progress) {
    std::vector<double> heights(sizes_.size(), 0);
    // Every repetition has fewer cycles.
    do {
      cycles_ = overlap_cycles(below_);
      if (cycles_.count < 2) return std::vector<double>(sizes_.size(), 0);
      find_heights(heights, progress);
    } while (hold_joined(heights));
    return heights;
  }

 private:
  void find_heights(std::vector<double>& heights, Progress& progress) {
    objective_ = {};
    targets_.clear();
    distances_.clear();
    add_plane_rows();
    add_pair_rows();
    add_like_rows();
    LeastSquaresProblem problem;
    problem.objective = objective_.matrix(cycles_.count);
    problem.target = Eigen::Map<const Eigen::VectorXd>(targets_.data(), problem.objective.rows());
    SparseRows gaps;
    problem.inequality_bounds.resize(static_cast<Eigen::Index>(distances_.size()));
    for (const auto& [pair, distance] : distances_) {
      problem.inequality_bounds[gaps.size()] = distance;
      gaps.add({{pair.first, 1}, {pair.second, -1}});
    }
    problem.inequalities = gaps.matrix(cycles_.count);
    const LeastSquaresSolution solution = solve_least_squares(problem, {}, progress);
    for (Index object = 0; object < heights.size(); ++object) {
      heights[object] = solution.x[cycles_.cycle[object]] * scale_;
    }
  }

  /// A limb that something pushes away from its body has to bend: it shares the body's height.
  /// @return whether there was one
  bool hold_joined(const std::vector<double>& heights) {
    bool found = false;
    for (const auto& [pair, bound] : bounds_) {
      const auto& [upper, lower] = pair;
      if (cycles_.cycle[upper] == cycles_.cycle[lower] || !settings_.attachments.kappa(upper, lower)) continue;
      const double allowed = std::max(bound.least, bound.reach);
      const double excess = heights[upper] - heights[lower] - allowed;
      if (excess <= pushed_away * std::min(sizes_[upper].radius, sizes_[lower].radius)) continue;
      below_[lower].push_back(upper);
      found = true;
    }
    return found;
  }

  void add_row(std::initializer_list<SparseRows::Entry> row, double target = 0) {
    objective_.add(row);
    targets_.push_back(target);
  }

  void add_plane_rows() {
    double total = 0;
    for (const ObjectSize& size : sizes_) total += size.area;
    for (Index object = 0; object < sizes_.size(); ++object) {
      const double hold = plane_weight * depth_weights(settings_, object).distance;
      add_row({{cycles_.cycle[object], hold * std::sqrt(sizes_[object].area / total)}});
    }
  }

  void add_pair_rows() {
    for (const auto& [pair, bound] : bounds_) {
      const Index upper = cycles_.cycle[pair.first];
      const Index lower = cycles_.cycle[pair.second];
      if (upper == lower) continue;
      add_row({{upper, 1}, {lower, -1}});
      double& most = distances_[{upper, lower}];
      most = std::max(most, bound.least / scale_ + rest_clearance);
    }
  }

  void add_like_rows() {
    std::map<Index, BodyParts> bodies;
    const auto add = [&](Index body, BodyPart part) {
      part.joined = settings_.attachments.kappa(body, part.part).has_value();
      const bool flat = cycles_.cycle[body] != cycles_.cycle[part.part];
      if (flat && sizes_[body].area > sizes_[part.part].area) bodies[body].push_back(part);
    };
    for (const auto& [pair, bound] : bounds_) {
      add(pair.second, {pair.first, 1, bound});
      add(pair.first, {pair.second, -1, bound});
    }
    for (const auto& [body, parts] : bodies) {
      for (const BodyParts& group : like_groups(parts, sizes_)) add_like_rows(body, group);
    }
  }

  void add_like_rows(Index body, const BodyParts& group) {
    double distance = 0;
    for (const BodyPart& part : group) distance = std::max(distance, part.bound.least / scale_ + rest_clearance);
    for (const BodyPart& part : group) {
      double own = distance;
      // Limbs that grow out of a body have to reach it, each by itself.
      if (part.joined) own = std::min(own, std::max(part.bound.least, part.bound.reach) / scale_);
      add_row({{cycles_.cycle[part.part], part.side * like_weight}, {cycles_.cycle[body], -part.side * like_weight}},
              like_weight * own);
    }
  }

  double scale_;
  std::vector<ObjectSize> sizes_;
  const ObjectBounds& bounds_;
  const DepthSettings& settings_;
  std::map<std::pair<Index, Index>, double> distances_;  ///< by cycles, in L
  std::vector<std::vector<Index>> below_;                ///< per object
  OverlapCycles cycles_;
  SparseRows objective_;
  std::vector<double> targets_;
};

}  // namespace

ObjectBounds object_bounds(const Skeleton& skeleton, std::span<const CollisionRow> rows) {
  ObjectBounds bounds;
  for (const CollisionRow& row : rows) {
    const std::pair pair(skeleton.nodes[row.upper].object, skeleton.nodes[row.lower].object);
    if (pair.first != pair.second) bounds[pair].widen({row.bound, row.reach});
  }
  return bounds;
}

std::vector<double> rest_depths(const Skeleton& skeleton, const ObjectBounds& bounds, const DepthSettings& settings,
                                Progress& progress) {
  return RestProblem(skeleton, bounds, settings).solve(progress);
}

namespace {

/// The most that the depths along one chain of objects, each over the next, add up to.
double longest_chain(const std::vector<std::vector<Index>>& below, const std::vector<double>& depths) {
  const OverlapCycles cycles = overlap_cycles(below);
  std::vector<Index> from_below(depths.size());
  std::iota(from_below.begin(), from_below.end(), Index{0});
  std::ranges::stable_sort(from_below, {}, [&](Index object) { return cycles.cycle[object]; });
  std::vector<double> own(cycles.count, 0), most_below(cycles.count, 0);
  double longest = 0;
  for (const Index object : from_below) {
    const Index cycle = cycles.cycle[object];
    own[cycle] += depths[object];
    for (const Index lower : below[object]) {
      const Index next = cycles.cycle[lower];
      if (next != cycle) most_below[cycle] = std::max(most_below[cycle], own[next] + most_below[next]);
    }
    longest = std::max(longest, own[cycle] + most_below[cycle]);
  }
  return longest;
}

}  // namespace

double explained_depth(const LabelledFigure& figure, const Skeleton& skeleton, double gap,
                       const std::vector<double>& thickness) {
  std::vector<double> widths(figure.objects.size(), 0), depths;
  for (const SkeletonNode& node : skeleton.nodes) widths[node.object] = std::max(widths[node.object], 2 * node.radius);
  for (Index object = 0; object < widths.size(); ++object) {
    if (object < thickness.size()) widths[object] *= thickness[object];
    depths.push_back(widths[object] + gap);
  }
  std::vector<std::vector<Index>> below(depths.size());
  for (const FigureOverlap& overlap : figure.overlaps) {
    if (overlap.upper == overlap.lower) {
      depths[overlap.upper] += widths[overlap.upper] + gap;
    } else {
      below[overlap.upper].push_back(overlap.lower);
    }
  }
  return longest_chain(below, depths);
}

std::vector<Index> objects_too_deep(std::vector<DepthRange> ranges, double most) {
  const auto reach = [](const DepthRange& range) { return std::max(std::abs(range.low), std::abs(range.high)); };
  std::vector<Index> refused;
  while (!ranges.empty()) {
    const double low = std::ranges::min_element(ranges, {}, &DepthRange::low)->low;
    const double high = std::ranges::max_element(ranges, {}, &DepthRange::high)->high;
    if (high - low <= most) break;
    const auto farthest = std::ranges::max_element(ranges, {}, reach);
    refused.push_back(farthest->object);
    ranges.erase(farthest);
  }
  std::ranges::sort(refused);
  return refused;
}

}  // namespace croquis::silhouette
