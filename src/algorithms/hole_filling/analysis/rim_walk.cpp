// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "algorithms/hole_filling/analysis/analysis_steps.h"
#include "algorithms/hole_filling/analysis/sorted_lists.h"
#include "algorithms/hole_filling/triangulation/cancel_check.h"
#include "croquis/geometry/vector.h"

namespace croquis::hole_filling {
namespace {

/// One of several fans of triangles that meet in a vertex alone.
struct Fan {
  Vec3 first;   ///< from the vertex along the rim edge that leaves it: the fan lies to its left
  Vec3 last;    ///< from the vertex along the rim edge that arrives, backwards: the fan lies to its right
  Vec3 normal;  ///< of the fan, any length
};

/// Fans turned further than this from their mean normal (60 degrees) aren't seen as lying in one surface.
constexpr double least_fan_agreement = 0.5;

/// Where fans begin and end, as angles counter-clockwise from the first one's beginning.
struct FanExtent {
  double begin, end;
  std::size_t fan;
};

double turn_between(const Vec3& from, const Vec3& to, const Vec3& axis) {
  const double angle = std::atan2(axis.dot(from.cross(to)), from.dot(to) - from.dot(axis) * to.dot(axis));
  return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

/// For each fan the next one counter-clockwise, whose `first` bounds the same gap as its `last`; nothing when the
/// fans don't lie around the vertex one after another, seen along their mean normal.
std::vector<std::size_t> fan_across_gap(std::span<const Fan> fans) {
  Vec3 axis = Vec3::Zero();
  for (const Fan& fan : fans) axis += fan.normal.normalized();
  axis.normalize();
  std::vector<FanExtent> around;
  for (std::size_t i = 0; i < fans.size(); ++i) {
    if (!(fans[i].normal.normalized().dot(axis) > least_fan_agreement)) return {};
    const double begin = i == 0 ? 0 : turn_between(fans[0].first, fans[i].first, axis);
    around.push_back({begin, begin + turn_between(fans[i].first, fans[i].last, axis), i});
  }
  std::sort(around.begin(), around.end(), [](const FanExtent& a, const FanExtent& b) { return a.begin < b.begin; });
  std::vector<std::size_t> across(fans.size());
  for (std::size_t i = 0; i < around.size(); ++i) {
    const bool is_last = i + 1 == around.size();
    const double limit = is_last ? 2 * std::numbers::pi : around[i + 1].begin;
    if (!(around[i].end < limit)) return {};
    across[around[i].fan] = around[is_last ? 0 : i + 1].fan;
  }
  return across;
}

/// One end of a rim edge: 2 × place in rim_corners, + 1 for the target.
using End = Index;

class RimWalk {
 public:
  RimWalk(const PolyMesh& mesh, HoleAnalysis& analysis, Progress& progress)
      : analysis_(analysis),
        view_(analysis.view),
        positions_(mesh.positions),
        cancel_(progress),
        partner_(2 * view_.rim_corners.size(), no_index),
        visited_(view_.rim_corners.size(), 0),
        place_(mesh.vertex_count(), no_index) {}

  void run() {
    link_around_vertices();
    link_across_gaps();
    link_dead_ends();
    for (End end = 0; end < partner_.size(); ++end) {
      if (partner_[end] != no_index || visited_[end / 2] != 0) continue;
      ++analysis_.open_rims;
      walk_from(end);
    }
    for (Index edge = 0; edge < visited_.size(); ++edge) {
      if (visited_[edge] == 0) walk_from(2 * edge);
    }
  }

 private:
  struct Step {
    Index vertex, corner;
    bool forward;
  };

  Index corner(End end) const { return view_.rim_corners[end / 2]; }
  Index vertex(End end) const { return end % 2 == 0 ? view_.origin(corner(end)) : view_.target(corner(end)); }

  /// The end that one arrives at by turning around the end's vertex through its triangles, or no_index at a
  /// non-manifold edge.
  End turn(End end) {
    const Index pivot = vertex(end);
    Index edge = view_.other_edge_at(corner(end), pivot);
    while (view_.has_opposite(edge)) {
      cancel_.step();
      edge = view_.other_edge_at(view_.opposite[edge], pivot);
    }
    if (view_.opposite[edge] == nonmanifold_edge) return no_index;
    return 2 * place_in(view_.rim_corners, edge) + (view_.origin(edge) == pivot ? 0 : 1);
  }

  void link_around_vertices() {
    for (End end = 0; end < partner_.size(); ++end) {
      if (partner_[end] != no_index) continue;
      const End other = turn(end);
      if (other == no_index) continue;
      partner_[end] = other;
      partner_[other] = end;
    }
  }

  /// Vertices with several fans: each fan's last rim edge goes on with the first one of the fan across the gap.
  void link_across_gaps() {
    std::vector<std::pair<Index, End>> arrivals;  // vertex, end
    for (End end = 1; end < partner_.size(); end += 2) {
      const End other = partner_[end];
      if (other != no_index && other % 2 == 0) arrivals.emplace_back(vertex(end), end);
    }
    std::sort(arrivals.begin(), arrivals.end());
    for (auto begin = arrivals.begin(); begin != arrivals.end();) {
      const auto end = std::find_if(begin, arrivals.end(), [&](const auto& a) { return a.first != begin->first; });
      if (end - begin > 1) link_fans({begin, end});
      begin = end;
    }
  }

  void link_fans(std::span<const std::pair<Index, End>> arrivals) {
    std::vector<Fan> fans;
    std::vector<End> leaving;
    for (const auto& [at, end] : arrivals) {
      leaving.push_back(partner_[end]);
      const Vec3& tip = positions_[at];
      fans.push_back({positions_[view_.target(corner(partner_[end]))] - tip,
                      positions_[view_.origin(corner(end))] - tip, fan_normal(end)});
    }
    const std::vector<std::size_t> across = fan_across_gap(fans);
    for (std::size_t i = 0; i < across.size(); ++i) {
      partner_[arrivals[i].second] = leaving[across[i]];
      partner_[leaving[across[i]]] = arrivals[i].second;
    }
  }

  /// Sum of the normals, weighted by area, of the triangles that `turn` goes through.
  Vec3 fan_normal(End end) const {
    const Index pivot = vertex(end);
    Vec3 sum = Vec3::Zero();
    for (Index edge = corner(end);;) {
      sum += view_.normal(edge / 3, positions_);
      edge = view_.other_edge_at(edge, pivot);
      if (!view_.has_opposite(edge)) return sum;
      edge = view_.opposite[edge];
    }
  }

  /// Rims that end at non-manifold edges go on with another one that does so at the same vertex.
  void link_dead_ends() {
    std::vector<std::tuple<Index, Index, End>> dead;  // (vertex, arriving or leaving, end)
    for (End end = 0; end < partner_.size(); ++end) {
      if (partner_[end] == no_index) dead.emplace_back(vertex(end), 1 - end % 2, end);
    }
    std::sort(dead.begin(), dead.end());
    for (auto begin = dead.begin(); begin != dead.end();) {
      const Index at = std::get<0>(*begin);
      const auto end = std::find_if(begin, dead.end(), [&](const auto& d) { return std::get<0>(d) != at; });
      auto leaving = std::find_if(begin, end, [](const auto& d) { return std::get<1>(d) == 1; });
      for (auto arriving = begin; leaving != end && std::get<1>(*arriving) == 0; ++arriving, ++leaving) {
        partner_[std::get<2>(*arriving)] = std::get<2>(*leaving);
        partner_[std::get<2>(*leaving)] = std::get<2>(*arriving);
      }
      begin = end;
    }
  }

  /// Walks from the near end of an edge until an edge comes again, which closes the cycle, or the chain ends, which
  /// leaves a remainder that is none.
  void walk_from(End near) {
    while (near != no_index && visited_[near / 2] == 0) {
      visited_[near / 2] = 1;
      push({vertex(near), corner(near), near % 2 == 0});
      near = partner_[near ^ 1U];
    }
    if (near == no_index) {
      for (const Step& step : stack_) place_[step.vertex] = no_index;
      stack_.clear();
    } else if (!stack_.empty()) {
      emit_from(0);
    }
  }

  void push(const Step& step) {
    if (place_[step.vertex] != no_index) emit_from(place_[step.vertex]);
    place_[step.vertex] = static_cast<Index>(stack_.size());
    stack_.push_back(step);
  }

  void emit_from(std::size_t first) {
    Hole hole;
    std::size_t backward = 0;
    for (std::size_t i = first; i < stack_.size(); ++i) {
      hole.corners.push_back(stack_[i].corner);
      hole.vertices.push_back(stack_[i].vertex);
      if (!stack_[i].forward) ++backward;
      place_[stack_[i].vertex] = no_index;
    }
    stack_.resize(first);
    hole.ambiguous = backward > 0;
    if (hole.corners.size() >= 3) analysis_.holes.push_back(std::move(hole));
  }

  HoleAnalysis& analysis_;
  const SurfaceView& view_;
  std::span<const Vec3> positions_;
  CancelCheck cancel_;
  std::vector<End> partner_;           ///< #2R
  std::vector<std::uint8_t> visited_;  ///< per rim edge
  std::vector<Index> place_;           ///< per vertex, in stack_
  std::vector<Step> stack_;
};

}  // namespace

void walk_rims(const PolyMesh& mesh, HoleAnalysis& analysis, Progress& progress) {
  RimWalk(mesh, analysis, progress).run();
}

}  // namespace croquis::hole_filling
