// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/skeleton/collision_rows.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>

namespace croquis::silhouette {
namespace {

/// A node's chord passes through a panel.
struct PanelNode {
  Index face = 0;
  Index layer = 0;
  Index node = 0;

  bool same_panel(const PanelNode& other) const { return face == other.face && layer == other.layer; }
};

std::vector<PanelNode> nodes_by_panel(const Skeleton& skeleton, const LabelledFigure& figure) {
  std::vector<PanelNode> entries;
  for (Index n = 0; n < skeleton.nodes.size(); ++n) {
    for (const SheetPlace& place : skeleton.nodes[n].crossed) {
      entries.push_back({figure.faces[place.triangle], place.layer, n});
    }
  }
  std::sort(entries.begin(), entries.end(), [](const PanelNode& a, const PanelNode& b) {
    return std::tie(a.face, a.layer, a.node) < std::tie(b.face, b.layer, b.node);
  });
  return entries;
}

/// Where a node's part of the contour lies: the ends of its chord, and of a branch's last node the tip beyond it.
std::vector<std::vector<Vec2>> rim_places(const Skeleton& skeleton) {
  std::vector<std::vector<Vec2>> places(skeleton.nodes.size());
  std::vector<int> degree(skeleton.nodes.size(), 0);
  for (const auto& [i, k] : skeleton.edges) {
    ++degree[i];
    ++degree[k];
  }
  for (Index n = 0; n < places.size(); ++n) {
    const auto& chord = skeleton.nodes[n].chord;
    places[n].assign(chord.begin(), chord.end());
  }
  const auto add_tip = [&](Index end, Index before) {
    const SkeletonNode& node = skeleton.nodes[end];
    const Vec2 outward = node.position - skeleton.nodes[before].position;
    if (degree[end] == 1) places[end].push_back(node.position + node.radius * outward.normalized());
  };
  for (const auto& [i, k] : skeleton.edges) {
    add_tip(i, k);
    add_tip(k, i);
  }
  return places;
}

/// A section of a limb.
struct Section {
  double half_width = 0;
  double half_depth = 0;

  double height(double offset) const {
    const double part = offset / half_width;
    return half_depth * std::sqrt(std::max(0.0, 1 - part * part));
  }
};

/// How far apart in depth two sections touch whose middles are so far apart in the plane; 0 where they never do.
double touching_distance(const Section& a, const Section& b, double offset) {
  const double width = a.half_width + b.half_width;
  if (offset >= width) return 0;
  const double depth = a.half_depth + b.half_depth;
  // Ellipses of one shape touch as circles do.
  if (a.half_depth * b.half_width == b.half_depth * a.half_width) {
    return depth / width * std::sqrt(width * width - offset * offset);
  }
  // The sum of their heights over one place is concave: halving by the golden section, to a millionth.
  constexpr int steps = 30;
  constexpr double golden = 0.618033988749895;
  double low = std::max(-a.half_width, offset - b.half_width);
  double high = std::min(a.half_width, offset + b.half_width);
  const auto sum = [&](double x) { return a.height(x) + b.height(offset - x); };
  for (int step = 0; step < steps; ++step) {
    const double left = high - golden * (high - low);
    const double right = low + golden * (high - low);
    if (sum(left) < sum(right)) {
      low = left;
    } else {
      high = right;
    }
  }
  return sum((low + high) / 2);
}

class RowMaker {
 public:
  RowMaker(const Skeleton& skeleton, double gap, double unit, const Attachments& attachments,
           const std::vector<double>& thickness)
      : skeleton_(skeleton),
        gap_(gap),
        resting_gap_(std::min(gap, resting_gap(skeleton.scale, unit))),
        attachments_(attachments),
        thickness_(thickness) {
    if (!attachments.empty()) rims_ = rim_places(skeleton);
  }

  void add_rows(std::span<const PanelNode> above, std::span<const PanelNode> below, std::vector<CollisionRow>& rows) {
    for (const PanelNode& upper : above) {
      for (const PanelNode& lower : below) {
        if (upper.node == lower.node) continue;
        const double bound = least_distance(upper.node, lower.node);
        if (bound > 0) rows.push_back({upper.node, lower.node, bound, reach(upper.node, lower.node)});
      }
    }
  }

 private:
  /// Along z.
  double least_distance(Index upper, Index lower) const {
    const SkeletonNode& a = skeleton_.nodes[upper];
    const SkeletonNode& b = skeleton_.nodes[lower];
    const double thick_a = thickness_of(a.object);
    const double thick_b = thickness_of(b.object);
    const Vec2 offset = a.position - b.position;
    const auto kappa = attachments_.kappa(a.object, b.object);
    if (!kappa) {
      const double half_gap = (attachments_.resting(a.object, b.object) ? resting_gap_ : gap_) / 2;
      return touching_distance({a.radius + half_gap, thick_a * a.radius + half_gap},
                               {b.radius + half_gap, thick_b * b.radius + half_gap}, offset.norm());
    }
    double bound = attached_height(*kappa, a, b);
    for (const Vec2& place : rims_[upper]) {
      bound = std::max(bound, thick_b * height(b.radius, place - b.position));
    }
    return bound;
  }

  double reach(Index upper, Index lower) const {
    const SkeletonNode& a = skeleton_.nodes[upper];
    const SkeletonNode& b = skeleton_.nodes[lower];
    return attachments_.kappa(a.object, b.object) ? attached_height(1, a, b) : 0;
  }

  /// Of the middles of joined parts where the nodes lie over one another.
  double attached_height(double kappa, const SkeletonNode& a, const SkeletonNode& b) const {
    const double wide = attached_distance(kappa, a.radius, b.radius);
    const double deep = attached_distance(kappa, thickness_of(a.object) * a.radius, thickness_of(b.object) * b.radius);
    return deep / wide * height(wide, a.position - b.position);
  }

  double thickness_of(Index object) const { return object < thickness_.size() ? thickness_[object] : 1; }

  /// Of a ball of that radius, away from its centre; 0 outside it.
  static double height(double radius, const Vec2& offset) {
    return std::sqrt(std::max(0.0, radius * radius - offset.squaredNorm()));
  }

  const Skeleton& skeleton_;
  double gap_;
  double resting_gap_;
  const Attachments& attachments_;
  const std::vector<double>& thickness_;
  std::vector<std::vector<Vec2>> rims_;  ///< per node; empty without attachments
};

}  // namespace

std::vector<CollisionRow> collision_rows(const Skeleton& skeleton, const LabelledFigure& figure, double gap,
                                         const Attachments& attachments, const std::vector<double>& thickness) {
  const std::vector<PanelNode> entries = nodes_by_panel(skeleton, figure);
  RowMaker maker(skeleton, gap, figure.unit, attachments, thickness);
  std::vector<CollisionRow> rows;
  std::vector<std::span<const PanelNode>> stack;  // panels of this face that lie above
  for (std::size_t begin = 0, end = 0; begin < entries.size(); begin = end) {
    while (end < entries.size() && entries[end].same_panel(entries[begin])) ++end;
    const std::span<const PanelNode> panel(entries.data() + begin, end - begin);
    const PanelNode& here = entries[begin];
    std::erase_if(stack, [&](const auto& above) {
      return above.front().face != here.face || (attachments.empty() && above.front().layer + 1 != here.layer);
    });
    for (const auto& above : stack) maker.add_rows(above, panel, rows);
    stack.push_back(panel);
  }
  const auto ends = [](const CollisionRow& row) { return std::tie(row.upper, row.lower); };
  std::sort(rows.begin(), rows.end(), [&](const auto& a, const auto& b) { return ends(a) < ends(b); });
  const auto same = [&](const auto& a, const auto& b) { return ends(a) == ends(b); };
  rows.erase(std::unique(rows.begin(), rows.end(), same), rows.end());
  return rows;
}

}  // namespace croquis::silhouette
