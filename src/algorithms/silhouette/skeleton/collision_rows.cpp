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

void add_rows(const Skeleton& skeleton, std::span<const PanelNode> above, std::span<const PanelNode> below, double gap,
              std::vector<CollisionRow>& rows) {
  for (const PanelNode& upper : above) {
    const SkeletonNode& a = skeleton.nodes[upper.node];
    for (const PanelNode& lower : below) {
      if (upper.node == lower.node) continue;
      const SkeletonNode& b = skeleton.nodes[lower.node];
      const double reach = a.radius + b.radius + gap;
      const double squared = reach * reach - (a.position - b.position).squaredNorm();
      if (squared > 0) rows.push_back({upper.node, lower.node, std::sqrt(squared)});
    }
  }
}

}  // namespace

std::vector<CollisionRow> collision_rows(const Skeleton& skeleton, const LabelledFigure& figure, double gap) {
  const std::vector<PanelNode> entries = nodes_by_panel(skeleton, figure);
  std::vector<CollisionRow> rows;
  std::span<const PanelNode> above;
  for (std::size_t begin = 0, end = 0; begin < entries.size(); begin = end) {
    while (end < entries.size() && entries[end].same_panel(entries[begin])) ++end;
    const std::span<const PanelNode> panel(entries.data() + begin, end - begin);
    const PanelNode& here = entries[begin];
    if (!above.empty() && above.front().face == here.face && above.front().layer + 1 == here.layer) {
      add_rows(skeleton, above, panel, gap, rows);
    }
    above = panel;
  }
  const auto ends = [](const CollisionRow& row) { return std::tie(row.upper, row.lower); };
  std::sort(rows.begin(), rows.end(), [&](const auto& a, const auto& b) { return ends(a) < ends(b); });
  const auto same = [&](const auto& a, const auto& b) { return ends(a) == ends(b); };
  rows.erase(std::unique(rows.begin(), rows.end(), same), rows.end());
  return rows;
}

}  // namespace croquis::silhouette
