// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/skeleton/chord_split.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace croquis::silhouette {
namespace {

/// Stretches shorter than this, or nearer to the node, in L: a joining edge would have no useful direction.
constexpr double least_stretch = 1e-3;

/// Height of a node's circle above a place beside its centre. Near the rim of the circle, where it would vanish, a
/// little is left so that a sheet differs from its edge.
double height_over(const SkeletonNode& node, const Vec2& place) {
  constexpr double farthest = 0.95;
  const double aside = std::min((place - node.position).norm() / node.radius, farthest);
  return node.radius * std::sqrt(1 - aside * aside);
}

bool split(Index index, const LabelledFigure& figure, Skeleton& skeleton) {
  SkeletonNode whole = skeleton.nodes[index];
  SkeletonNode kept = whole;
  kept.crossed.clear();
  kept.parts.clear();
  const double least = least_stretch * skeleton.scale;
  const Index own_face = figure.faces[whole.place.triangle];
  for (std::size_t i = 0; i < whole.crossed.size(); ++i) {
    const SheetPlace& place = whole.crossed[i];
    const ChordPart& part = whole.parts[i];
    const bool own = place.layer == whole.place.layer && figure.faces[place.triangle] == own_face;
    if (own || part.length < least || (part.middle - whole.position).norm() < least) {
      kept.crossed.push_back(place);
      kept.parts.push_back(part);
      continue;
    }
    SkeletonNode piece;
    piece.position = part.middle;
    piece.radius = height_over(whole, part.middle);
    piece.chord = whole.chord;
    piece.place = place;
    piece.crossed = {place};
    piece.parts = {part};
    piece.object = whole.object;
    skeleton.edges.push_back({index, static_cast<Index>(skeleton.nodes.size())});
    skeleton.nodes.push_back(std::move(piece));
  }
  const bool changed = kept.crossed.size() < whole.crossed.size();
  skeleton.nodes[index] = std::move(kept);
  return changed;
}

}  // namespace

std::size_t split_chords(std::span<const Index> nodes, const LabelledFigure& figure, Skeleton& skeleton) {
  std::size_t count = 0;
  for (const Index node : nodes) {
    if (split(node, figure, skeleton)) ++count;
  }
  return count;
}

}  // namespace croquis::silhouette
