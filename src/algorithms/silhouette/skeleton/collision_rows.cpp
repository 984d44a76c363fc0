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

  auto operator<=>(const PanelNode&) const = default;
  bool same_panel(const PanelNode& other) const { return face == other.face && layer == other.layer; }
};

std::vector<PanelNode> nodes_by_panel(const Skeleton& skeleton, const LabelledFigure& figure) {
  std::vector<PanelNode> entries;
  for (Index n = 0; n < skeleton.nodes.size(); ++n) {
    for (const SheetPlace& place : skeleton.nodes[n].crossed) {
      entries.push_back({figure.faces[place.triangle], place.layer, n});
    }
  }
  std::sort(entries.begin(), entries.end());
  return entries;
}

/// Where a node's part of the contour lies: the ends of its chord, and of a branch's last node the tip beyond it.
std::vector<std::vector<Vec2>> rim_places(const Skeleton& skeleton) {
  std::vector<std::vector<Vec2>> places;
  for (const SkeletonNode& node : skeleton.nodes) places.emplace_back(node.chord.begin(), node.chord.end());
  const std::vector<std::vector<Index>> neighbours = skeleton.neighbours();
  for (Index n = 0; n < places.size(); ++n) {
    if (neighbours[n].size() != 1) continue;
    const SkeletonNode& node = skeleton.nodes[n];
    const Vec2 outward = node.position - skeleton.nodes[neighbours[n].front()].position;
    places[n].push_back(node.position + node.radius * outward.normalized());
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

/// Of a ball of that radius, away from its centre; 0 outside it.
double ball_height(double radius, const Vec2& offset) {
  return std::sqrt(std::max(0.0, radius * radius - offset.squaredNorm()));
}

/// Along z, of the middles of joined parts where two of their nodes lie over one another.
double attached_height(double kappa, const SkeletonNode& a, const SkeletonNode& b, const DepthSettings& settings) {
  const double deep_a = settings.thickness_of(a.object) * a.radius;
  const double deep_b = settings.thickness_of(b.object) * b.radius;
  const double wide = attached_distance(kappa, a.radius, b.radius);
  return attached_distance(kappa, deep_a, deep_b) / wide * ball_height(wide, a.position - b.position);
}

/// @param upper_rim the upper node's places of the contour
CollisionRow row_between(Index upper, Index lower, const Skeleton& skeleton, const LabelledFigure& figure,
                         const DepthSettings& settings, std::span<const Vec2> upper_rim) {
  const SkeletonNode& a = skeleton.nodes[upper];
  const SkeletonNode& b = skeleton.nodes[lower];
  const Vec2 offset = a.position - b.position;
  const auto kappa = settings.attachments.kappa(a.object, b.object);
  if (kappa) {
    double bound = attached_height(*kappa, a, b, settings);
    for (const Vec2& place : upper_rim) {
      bound = std::max(bound, settings.thickness_of(b.object) * ball_height(b.radius, place - b.position));
    }
    return {upper, lower, bound, attached_height(1, a, b, settings)};
  }
  double gap = settings.options.minimum_gap * skeleton.scale;
  if (settings.attachments.resting(a.object, b.object)) gap = std::min(gap, resting_gap(skeleton.scale, figure.unit));
  const auto section = [&](const SkeletonNode& node) -> Section {
    return {node.radius + gap / 2, settings.thickness_of(node.object) * node.radius + gap / 2};
  };
  return {upper, lower, touching_distance(section(a), section(b), offset.norm()), 0};
}

}  // namespace

std::vector<CollisionRow> collision_rows(const Skeleton& skeleton, const LabelledFigure& figure,
                                         const DepthSettings& settings) {
  const bool joined = !settings.attachments.empty();
  const std::vector<PanelNode> entries = nodes_by_panel(skeleton, figure);
  const std::vector<std::vector<Vec2>> rims = rim_places(skeleton);
  std::vector<CollisionRow> rows;
  std::vector<std::span<const PanelNode>> stack;  // panels of this face that lie above
  for (std::size_t begin = 0, end = 0; begin < entries.size(); begin = end) {
    while (end < entries.size() && entries[end].same_panel(entries[begin])) ++end;
    const std::span<const PanelNode> panel(entries.data() + begin, end - begin);
    const PanelNode& here = entries[begin];
    std::erase_if(stack, [&](const auto& above) {
      return above.front().face != here.face || (!joined && above.front().layer + 1 != here.layer);
    });
    for (const auto& above : stack) {
      for (const PanelNode& upper : above) {
        for (const PanelNode& lower : panel) {
          if (upper.node == lower.node) continue;
          const CollisionRow row = row_between(upper.node, lower.node, skeleton, figure, settings, rims[upper.node]);
          if (row.bound > 0) rows.push_back(row);
        }
      }
    }
    stack.push_back(panel);
  }
  const auto ends = [](const CollisionRow& row) { return std::tie(row.upper, row.lower); };
  std::sort(rows.begin(), rows.end(), [&](const auto& a, const auto& b) { return ends(a) < ends(b); });
  const auto same = [&](const auto& a, const auto& b) { return ends(a) == ends(b); };
  rows.erase(std::unique(rows.begin(), rows.end(), same), rows.end());
  return rows;
}

}  // namespace croquis::silhouette
