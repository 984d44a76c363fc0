// SPDX-License-Identifier: GPL-3.0-or-later
// The loop of curves around a place of a view.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>
#include <set>
#include <span>
#include <tuple>
#include <utility>

#include "algorithms/attribute_surface/edits/loop_shape.h"
#include "algorithms/attribute_surface/edits/open_loop.h"
#include "croquis/attribute_surface/loop_search.h"

namespace croquis {
namespace {

constexpr double hardly_longer = 1.25;  // × the shortest loop: which of those is meant is decided by what is in front

/// A curve between two places of the graph.
struct LoopEdge {
  Index curve = no_index;
  std::size_t from = 0;
  std::size_t to = 0;
  double length = 0;     ///< model units
  bool crossed = false;  ///< an odd number of times by the ray to the right of the place
};

/// Whether a polyline crosses the half line to the right of a place an odd number of times.
bool crosses_ray(std::span<const Vec2> places, const Vec2& place) {
  bool odd = false;
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const Vec2& a = places[i];
    const Vec2& b = places[i + 1];
    if ((a.y() > place.y()) == (b.y() > place.y())) continue;
    odd ^= a.x() + (place.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()) > place.x();
  }
  return odd;
}

double length_in_space(const AttributeNetwork& network, Index curve) {
  const std::vector<Vec3> places = traced_curve(network, curve, 16);
  double length = 0;
  for (std::size_t i = 1; i < places.size(); ++i) length += (places[i] - places[i - 1]).norm();
  return length;
}

struct LoopCandidate {
  std::vector<Index> curves;
  double length = 0;
  double depth = 0;  ///< of its surface at the place
  std::optional<Index> face;
};

class LoopGraph {
 public:
  LoopGraph(const AttributeNetwork& network, const std::vector<ViewedCurve>& views, const Vec2& place, double tolerance)
      : network_(network), views_(views), place_(place) {
    std::vector<Index> curves;
    for (Index i = 0; i < views.size(); ++i) {
      if (views[i].seen()) curves.push_back(i);
    }
    const CurveEnds ends(network, curves, tolerance);
    std::vector<std::optional<Vec2>> seen(2 * curves.size());
    edges_at_.resize(2 * curves.size());
    for (std::size_t i = 0; i < curves.size(); ++i) {
      LoopEdge edge{curves[i], ends.of(i, false), ends.of(i, true), length_in_space(network, curves[i]), false};
      // Ends at one place are seen at one place, or the ray could slip through between them.
      std::vector<Vec2> places = views[curves[i]].places;
      if (!seen[edge.from]) seen[edge.from] = places.front();
      places.front() = *seen[edge.from];
      if (!seen[edge.to]) seen[edge.to] = places.back();
      places.back() = *seen[edge.to];
      edge.crossed = crosses_ray(places, place);
      edges_at_[edge.from].push_back(edges_.size());
      if (edge.to != edge.from) edges_at_[edge.to].push_back(edges_.size());
      edges_.push_back(edge);
    }
  }

  std::vector<LoopCandidate> candidates(std::size_t most_sides) const {
    std::vector<LoopCandidate> found;
    std::set<std::set<Index>> known;
    for (std::size_t edge = 0; edge < edges_.size(); ++edge) {
      if (!edges_[edge].crossed) continue;
      const std::vector<std::size_t> walk = shortest_through(edge);
      if (walk.empty() || walk.size() > most_sides) continue;
      LoopCandidate candidate;
      for (const std::size_t one : walk) {
        candidate.curves.push_back(edges_[one].curve);
        candidate.length += edges_[one].length;
      }
      if (!known.insert({candidate.curves.begin(), candidate.curves.end()}).second) continue;
      candidate.face = face_with_loop(network_, candidate.curves);
      found.push_back(std::move(candidate));
    }
    return found;
  }

 private:
  /// A place of the graph, and whether an odd number of crossed curves leads to it.
  using State = std::pair<std::size_t, bool>;
  static std::size_t number(const State& state) { return 2 * state.first + (state.second ? 1 : 0); }

  /// The shortest simple walk around the place that uses a crossed edge; empty for none.
  std::vector<std::size_t> shortest_through(std::size_t first) const {
    const LoopEdge& start = edges_[first];
    if (start.from == start.to) return {first};
    constexpr std::size_t none = ~std::size_t{0};
    std::vector<double> length(2 * edges_at_.size(), std::numeric_limits<double>::infinity());
    std::vector<std::size_t> edge_to(length.size(), none);
    using Entry = std::tuple<double, std::size_t, bool>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    length[number({start.to, false})] = 0;
    open.emplace(0.0, start.to, false);
    while (!open.empty()) {
      const auto [so_far, at, odd] = open.top();
      open.pop();
      if (so_far > length[number({at, odd})]) continue;
      if (at == start.from && !odd) break;
      for (const std::size_t edge : edges_at_[at]) {
        if (edge == first) continue;
        const LoopEdge& way = edges_[edge];
        const State next{way.from == at ? way.to : way.from, odd != way.crossed};
        if (so_far + way.length >= length[number(next)]) continue;
        length[number(next)] = so_far + way.length;
        edge_to[number(next)] = edge;
        open.emplace(length[number(next)], next.first, next.second);
      }
    }
    return walk_back(first, edge_to);
  }

  std::vector<std::size_t> walk_back(std::size_t first, const std::vector<std::size_t>& edge_to) const {
    std::vector<std::size_t> walk;
    std::set<std::size_t> visited;
    State at{edges_[first].from, false};
    while (at.first != edges_[first].to || at.second) {
      const std::size_t edge = edge_to[number(at)];
      if (edge >= edges_.size() || !visited.insert(at.first).second) return {};
      walk.push_back(edge);
      const LoopEdge& way = edges_[edge];
      at = {way.from == at.first ? way.to : way.from, at.second != way.crossed};
    }
    walk.push_back(first);
    return walk;
  }

  const AttributeNetwork& network_;
  const std::vector<ViewedCurve>& views_;
  Vec2 place_;
  std::vector<LoopEdge> edges_;
  std::vector<std::vector<std::size_t>> edges_at_;
};

/// A loop as it is seen, with depths.
struct SeenLoop {
  std::vector<Vec2> places;
  std::vector<double> depths;
};

SeenLoop seen_loop(const std::vector<AttributeSide>& sides, const std::vector<ViewedCurve>& views) {
  SeenLoop seen;
  for (const AttributeSide& side : sides) {
    const ViewedCurve& view = views[side.curve];
    const std::size_t count = view.places.size();
    for (std::size_t i = 0; i + 1 < count; ++i) {
      const std::size_t at = side.reversed ? count - 1 - i : i;
      seen.places.push_back(view.places[at]);
      seen.depths.push_back(view.depths[at]);
    }
  }
  return seen;
}

double depth_at(const SeenLoop& seen, const Vec2& place) {
  const std::vector<double> weights = mean_value_weights(seen.places, place);
  return std::inner_product(weights.begin(), weights.end(), seen.depths.begin(), 0.0);
}

bool is_clockwise_in_view(const SeenLoop& seen) {
  double area = 0;
  for (std::size_t i = 0; i < seen.places.size(); ++i)
    area += cross(seen.places[i], seen.places[(i + 1) % seen.places.size()]);
  return area > 0;  // y points down
}

/// The one meant: of loops hardly longer than the shortest those that are no face yet, of these the nearest.
const LoopCandidate& chosen(const std::vector<LoopCandidate>& candidates) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const LoopCandidate& candidate : candidates) shortest = std::min(shortest, candidate.length);
  const auto rank = [&](const LoopCandidate& candidate) {
    const bool longer = candidate.length > hardly_longer * shortest;
    return std::tuple(longer, candidate.face.has_value(), longer ? candidate.length : candidate.depth);
  };
  return *std::ranges::min_element(candidates, {}, rank);
}

}  // namespace

std::optional<LoopAround> find_loop_around(const AttributeNetwork& network, const std::vector<ViewedCurve>& views,
                                           const Vec2& place, const LoopSearchOptions& options) {
  std::vector<LoopCandidate> candidates =
      LoopGraph(network, views, place, options.tolerance).candidates(options.most_sides);
  std::erase_if(candidates, [&](LoopCandidate& candidate) {
    const SortedLoop sorted = sort_loop(network, candidate.curves, options.tolerance);
    if (!sorted.closed()) return true;
    candidate.depth = depth_at(seen_loop(sorted.sides, views), place);
    return false;
  });
  if (candidates.empty()) return std::nullopt;
  const LoopCandidate& best = chosen(candidates);
  LoopAround around{sort_loop(network, best.curves, options.tolerance), best.face};
  const bool free_to_turn = turn_of_neighbours(network, around.loop.sides) == 0;
  if (free_to_turn && is_clockwise_in_view(seen_loop(around.loop.sides, views))) turn_loop_round(around.loop);
  return around;
}

}  // namespace croquis
