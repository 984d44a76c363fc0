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

class RowMaker {
 public:
  RowMaker(const Skeleton& skeleton, double gap, const Attachments& attachments)
      : skeleton_(skeleton), gap_(gap), attachments_(attachments) {
    if (!attachments.empty()) rims_ = rim_places(skeleton);
  }

  void add_rows(std::span<const PanelNode> above, std::span<const PanelNode> below, std::vector<CollisionRow>& rows) {
    for (const PanelNode& upper : above) {
      for (const PanelNode& lower : below) {
        if (upper.node == lower.node) continue;
        const double bound = least_distance(upper.node, lower.node);
        if (bound > 0) rows.push_back({upper.node, lower.node, bound});
      }
    }
  }

 private:
  /// Along z.
  double least_distance(Index upper, Index lower) const {
    const SkeletonNode& a = skeleton_.nodes[upper];
    const SkeletonNode& b = skeleton_.nodes[lower];
    const auto kappa = attachments_.kappa(a.object, b.object);
    if (!kappa) return height(a.radius + b.radius + gap_, a.position - b.position);
    double bound = height(attached_distance(*kappa, a.radius, b.radius), a.position - b.position);
    for (const Vec2& place : rims_[upper]) bound = std::max(bound, height(b.radius, place - b.position));
    return bound;
  }

  /// Of a ball of that radius, away from its centre; 0 outside it.
  static double height(double radius, const Vec2& offset) {
    return std::sqrt(std::max(0.0, radius * radius - offset.squaredNorm()));
  }

  const Skeleton& skeleton_;
  double gap_;
  const Attachments& attachments_;
  std::vector<std::vector<Vec2>> rims_;  ///< per node; empty without attachments
};

}  // namespace

std::vector<CollisionRow> collision_rows(const Skeleton& skeleton, const LabelledFigure& figure, double gap,
                                         const Attachments& attachments) {
  const std::vector<PanelNode> entries = nodes_by_panel(skeleton, figure);
  RowMaker maker(skeleton, gap, attachments);
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
