// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/silhouette/attachment.h"

#include <algorithm>
#include <set>
#include <utility>

namespace croquis::silhouette {

std::vector<AttachSuggestion> attach_suggestions(const LabelledFigure& figure) {
  std::vector<AttachSuggestion> suggestions;
  std::set<std::pair<Index, Index>> known;
  for (const FigureOverlap& overlap : figure.overlaps) {
    if (overlap.upper == overlap.lower || overlap.crossings.size() > 2) continue;
    const auto [a, b] = std::minmax(overlap.upper, overlap.lower);
    const Hold hold = overlap.crossings.empty() ? Hold::Resting : Hold::Joined;
    if (known.emplace(a, b).second) suggestions.push_back({a, b, overlap.at, hold});
  }
  return suggestions;
}

}  // namespace croquis::silhouette
