// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/silhouette/attachment.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "croquis/geometry/polyline.h"

namespace croquis::silhouette {

namespace {

using Pairs = std::set<std::pair<Index, Index>>;

bool covers(const LabelledFigure& figure, Index object, const Vec2& place) {
  int layers = 0;
  for (const Index c : figure.objects[object].contours) {
    layers += figure.contours[c].side * winding_number(contour_points(figure, c), place);
  }
  return layers > 0;
}

double area_of(const LabelledFigure& figure, Index object) {
  double area = 0;
  for (const Index c : figure.objects[object].contours) {
    area += figure.contours[c].side * signed_area(contour_points(figure, c));
  }
  return area;
}

/// Whether another object lies between the two there: an eye doesn't touch the ear behind the head. Two limbs before
/// and behind a larger body are apart where it ends, too.
/// @param areas per object
bool kept_apart(const LabelledFigure& figure, const Pairs& over, const std::vector<double>& areas,
                const FigureOverlap& overlap) {
  const double larger = std::max(areas[overlap.upper], areas[overlap.lower]);
  for (Index between = 0; between < figure.objects.size(); ++between) {
    if (between == overlap.upper || between == overlap.lower) continue;
    const bool ordered = over.contains({overlap.upper, between}) && over.contains({between, overlap.lower});
    if (!ordered) continue;
    if (areas[between] > larger || covers(figure, between, overlap.at)) return true;
  }
  return false;
}

}  // namespace

std::vector<AttachSuggestion> attach_suggestions(const LabelledFigure& figure) {
  std::vector<AttachSuggestion> suggestions;
  Pairs known;
  Pairs over;
  for (const FigureOverlap& overlap : figure.overlaps) over.emplace(overlap.upper, overlap.lower);
  std::vector<double> areas;
  for (Index object = 0; object < figure.objects.size(); ++object) areas.push_back(area_of(figure, object));
  for (const FigureOverlap& overlap : figure.overlaps) {
    const bool tube = figure.objects[overlap.upper].tube || figure.objects[overlap.lower].tube;
    if (overlap.upper == overlap.lower || (overlap.crossings.size() > 2 && !tube)) continue;
    if (!tube && kept_apart(figure, over, areas, overlap)) continue;
    const auto [a, b] = std::minmax(overlap.upper, overlap.lower);
    const bool rests = !tube && (overlap.crossings.empty() || overlap.whole_outlines);
    const Hold hold = rests ? Hold::Resting : Hold::Joined;
    if (known.emplace(a, b).second) suggestions.push_back({a, b, overlap.at, hold, tube});
  }
  return suggestions;
}

}  // namespace croquis::silhouette
