// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "croquis/geometry/vector.h"

namespace croquis::silhouette {

/// A place in the immersed region: a planar triangle of the figure and the layer there (0 in front).
struct SheetPlace {
  Index triangle = no_index;
  Index layer = 0;

  friend bool operator==(const SheetPlace&, const SheetPlace&) = default;
};

/// The stretch of a node's chord inside one panel.
struct ChordPart {
  Vec2 middle = Vec2::Zero();
  double length = 0;
};

/// A node of the chordal axis.
struct SkeletonNode {
  Vec2 position = Vec2::Zero();
  double radius = 0;
  double z = 0;                  ///< set by the depth solve
  Vec2 gradient = Vec2::Zero();  ///< of the carrying surface: its normal is (-g, 1); set by the depth solve
  std::array<Vec2, 2> chord;     ///< the chord's two ends on the contours
  SheetPlace place;              ///< where the node itself lies
  /// One place for every panel (face, layer) that its chord passes through; at the end of a branch, and for a blob of
  /// one node, also the chords of the cap or blob that it stands for.
  std::vector<SheetPlace> crossed;
  std::vector<ChordPart> parts;  ///< as crossed; the longest stretch where a panel is crossed twice
  Index object = 0;
};

/// The chordal axis of one labelled figure.
struct Skeleton {
  std::vector<SkeletonNode> nodes;
  std::vector<std::array<Index, 2>> edges;
  double scale = 0;  ///< L: median radius of the nodes
  /// Per object the height that it was pulled to, see rest_depths; set by the depth solve, empty before it.
  std::vector<double> rest;
  /// Radius along the contours, from all chords before decimation: per contour and position the radius of the chord
  /// (or cap) that the contour vertex belongs to. NaN where no chord ends.
  std::vector<std::vector<double>> contour_radius;

  /// Per node the nodes that its edges lead to.
  std::vector<std::vector<Index>> neighbours() const {
    std::vector<std::vector<Index>> around(nodes.size());
    for (const auto& [a, b] : edges) {
      around[a].push_back(b);
      around[b].push_back(a);
    }
    return around;
  }
};

/// The mean of both middle ones where their number is even; 0 for none.
inline double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

/// Per object the median radius of its skeleton's nodes, up to the last one that has nodes; 0 for one without.
inline std::vector<double> object_radii(const Skeleton& skeleton) {
  std::vector<std::vector<double>> radii;
  for (const SkeletonNode& node : skeleton.nodes) {
    if (node.object >= radii.size()) radii.resize(node.object + 1);
    radii[node.object].push_back(node.radius);
  }
  std::vector<double> medians;
  for (std::vector<double>& own : radii) medians.push_back(median(std::move(own)));
  return medians;
}

/// Per object, how hard it is to move: its median radius / L, the factor of its rows and thus the root of its
/// energies'. Where parts press on one another, the thin one gives way and the wide one keeps its shape.
inline std::vector<double> row_stiffness(const Skeleton& skeleton) {
  std::vector<double> stiffness = object_radii(skeleton);
  for (double& factor : stiffness) factor = factor > 0 ? factor / skeleton.scale : 1;
  return stiffness;
}

}  // namespace croquis::silhouette
