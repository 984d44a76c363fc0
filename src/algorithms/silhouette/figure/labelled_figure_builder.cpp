// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <tuple>
#include <utility>

#include "algorithms/silhouette/figure/labelling.h"
#include "croquis/geometry/disjoint_sets.h"

namespace croquis::silhouette {
namespace {

/// An arc seen from the side with more layers.
struct GluingStep {
  Index more = 0;   ///< face
  Index fewer = 0;  ///< face
  Index depth = 0;  ///< the layer that ends

  /// Layer on the other side, for any layer but the one that ends.
  Index across(Index layer) const { return layer < depth ? layer : layer - 1; }
};

/// The stacks of panels and how they are connected.
struct Stacks {
  std::vector<Index> layers;          ///< per face: w
  std::vector<GluingStep> steps;      ///< per arc
  std::vector<Index> first_panel{0};  ///< per face, one more at the end; panel (f, i) is first_panel[f] + i
  std::vector<Index> first_pair{0};   ///< the same for pairs of panels of a face
  std::vector<Index> component;       ///< per panel, numbered by the first contour that bounds them

  Index panel(Index face, Index layer) const { return first_panel[face] + layer; }
  Index pair(Index face, Index above, Index below) const { return first_pair[face] + below * (below - 1) / 2 + above; }

  /// Calls visit(above, below) for every two layers of a face.
  template <typename Visit>
  void pairs_of(Index face, Visit visit) const {
    for (Index below = 1; below < layers[face]; ++below) {
      for (Index above = 0; above < below; ++above) visit(above, below);
    }
  }
};

Stacks stacks_of(const Arrangement& arrangement, const Labelling& labelling) {
  Stacks stacks;
  for (const std::vector<int>& winding : arrangement.winding) {
    const std::vector<int>& side = labelling.side;
    const auto layers = static_cast<Index>(std::inner_product(winding.begin(), winding.end(), side.begin(), 0));
    stacks.layers.push_back(layers);
    stacks.first_panel.push_back(stacks.first_panel.back() + layers);
    stacks.first_pair.push_back(stacks.first_pair.back() + (layers == 0 ? 0 : layers * (layers - 1) / 2));
  }
  for (Index arc = 0; arc < labelling.depth.size(); ++arc) {
    auto [more, fewer] = arrangement.beside_arc[arc];
    if (stacks.layers[more] < stacks.layers[fewer]) std::swap(more, fewer);
    stacks.steps.push_back({more, fewer, static_cast<Index>(labelling.depth[arc])});
  }
  return stacks;
}

/// Glues the panels. Returns the component of every contour; none when one would bound two of them.
std::optional<std::vector<Index>> glue_panels(const Arrangement& arrangement, Stacks& stacks) {
  DisjointSets sets(stacks.first_panel.back());
  for (const GluingStep& step : stacks.steps) {
    for (Index i = 0; i < stacks.layers[step.more]; ++i) {
      if (i != step.depth) sets.unite(stacks.panel(step.more, i), stacks.panel(step.fewer, step.across(i)));
    }
  }
  std::map<Index, Index> number;
  std::vector<Index> of_contour(arrangement.contours.size(), no_index);
  for (Index arc = 0; arc < stacks.steps.size(); ++arc) {
    const Index root = sets.root(stacks.panel(stacks.steps[arc].more, stacks.steps[arc].depth));
    const Index component = number.try_emplace(root, static_cast<Index>(number.size())).first->second;
    Index& known = of_contour[arrangement.arcs[arc].contour];
    if (known != no_index && known != component) return std::nullopt;
    known = component;
  }
  for (Index p = 0; p < stacks.first_panel.back(); ++p) stacks.component.push_back(number.at(sets.root(p)));
  return of_contour;
}

/// Of the two arcs of a strand at a crossing, the one inside the other one's surface.
const GluingStep& covered_step(const Stacks& stacks, const ContourCrossing::Strand& strand) {
  const GluingStep& before = stacks.steps[strand.before];
  const GluingStep& after = stacks.steps[strand.after];
  return stacks.layers[before.more] > stacks.layers[after.more] ? before : after;
}

/// One overlap of components for each connected region of pairs of panels, placed in the largest triangle it covers.
std::vector<FigureOverlap> find_overlaps(const Arrangement& arrangement, const Stacks& stacks) {
  DisjointSets sets(stacks.first_pair.back());
  for (const GluingStep& step : stacks.steps) {
    stacks.pairs_of(step.more, [&](Index above, Index below) {
      if (above == step.depth || below == step.depth) return;
      sets.unite(stacks.pair(step.more, above, below), stacks.pair(step.fewer, step.across(above), step.across(below)));
    });
  }
  std::map<Index, std::pair<double, FigureOverlap>> regions;  // with the area of the triangle
  for (Index t = 0; t < arrangement.faces.size(); ++t) {
    const Index f = arrangement.faces[t];
    const std::array<Index, 3>& corners = arrangement.triangulation.triangles[t];
    const Vec2& a = arrangement.points[corners[0]];
    const Vec2& b = arrangement.points[corners[1]];
    const Vec2& c = arrangement.points[corners[2]];
    const double area = cross(b - a, c - a);
    stacks.pairs_of(f, [&](Index above, Index below) {
      auto& [largest, overlap] = regions[sets.root(stacks.pair(f, above, below))];
      if (area <= largest) return;
      largest = area;
      overlap.at = (a + b + c) / 3;
      overlap.upper = stacks.component[stacks.panel(f, above)];
      overlap.lower = stacks.component[stacks.panel(f, below)];
    });
  }
  // The sheets that end at a crossing lie above one another in one of the four faces around it: that pair of panels has
  // a corner there.
  for (Index k = 0; k < arrangement.contour_crossings.size(); ++k) {
    const GluingStep& a = covered_step(stacks, arrangement.contour_crossings[k].strands[0]);
    const GluingStep& b = covered_step(stacks, arrangement.contour_crossings[k].strands[1]);
    const auto [above, below] = std::minmax(a.depth, b.depth);
    FigureOverlap& overlap = regions.at(sets.root(stacks.pair(a.more, above, below))).second;
    overlap.crossings.push_back(k);
    overlap.tube_crossing = arrangement.contour_crossings[k].passing;
  }
  std::vector<FigureOverlap> overlaps;
  for (auto& [root, region] : regions) overlaps.push_back(std::move(region.second));
  std::ranges::sort(overlaps, {}, [](const FigureOverlap& overlap) {
    return std::tuple(overlap.upper, overlap.lower, overlap.at.x(), overlap.at.y());
  });
  return overlaps;
}

void add_labels(const Labelling& labelling, Arrangement& figure) {
  for (Index c = 0; c < figure.contours.size(); ++c) figure.contours[c].side = labelling.side[c];
  for (Index e = 0; e < figure.arcs.size(); ++e) {
    FigureArc& arc = figure.arcs[e];
    arc.depth = labelling.depth[e];
    if (!arc.visible || arc.depth == 0) continue;
    arc.visible = false;  // drawn, but covered by what was drawn over it
    std::vector<std::uint8_t>& drawn = figure.contours[arc.contour].drawn;
    for (Index k = 0; k < arc.count; ++k) drawn[(arc.begin + k) % drawn.size()] = 0;
  }
  for (Index k = 0; k < figure.contour_crossings.size(); ++k) {
    const auto& strands = figure.contour_crossings[k].strands;
    const ContourCrossing::Strand& over = strands[labelling.is_swapped[k]];
    const ContourCrossing::Strand& under = strands[1 - labelling.is_swapped[k]];
    const bool seen = figure.contour_crossings[k].over != no_index;
    figure.crossings.push_back({k, over.contour, over.position, under.contour, under.position, seen});
  }
}

/// Adds an object for every component, by their first strokes; those that a group of strokes was forced into are one.
/// @param strokes per component, ascending
/// @return the object of each
std::vector<Index> name_objects(const Drawing& drawing, const std::vector<std::vector<Index>>& strokes,
                                std::vector<FigureObject>& objects) {
  std::vector<Index> by_first_stroke(strokes.size());
  std::iota(by_first_stroke.begin(), by_first_stroke.end(), Index{0});
  std::ranges::sort(by_first_stroke, {}, [&](Index component) { return strokes[component].front(); });
  std::vector<Index> object(strokes.size());
  std::map<std::string, Index> of_group;
  for (const Index component : by_first_stroke) {
    const std::string group = object_of_strokes(drawing, strokes[component]);
    const auto next = static_cast<Index>(objects.size());
    object[component] = group.empty() ? next : of_group.try_emplace(group, next).first->second;
    if (object[component] != next) continue;
    objects.emplace_back().name = group.empty() ? drawing.strokes[strokes[component].front()].id : group;
  }
  return object;
}

/// @param component per contour
void add_objects(const Drawing& drawing, const std::vector<Index>& component, Arrangement& figure) {
  std::vector<std::vector<Index>> strokes(*std::ranges::max_element(component) + 1);
  for (Index c = 0; c < figure.contours.size(); ++c) {
    std::vector<Index>& own = strokes[component[c]];
    own.insert(own.end(), figure.contours[c].strokes.begin(), figure.contours[c].strokes.end());
  }
  for (std::vector<Index>& own : strokes) std::ranges::sort(own);
  const std::vector<Index> object = name_objects(drawing, strokes, figure.objects);
  for (Index c = 0; c < figure.contours.size(); ++c) {
    FigureContour& contour = figure.contours[c];
    contour.object = object[component[c]];
    FigureObject& owner = figure.objects[contour.object];
    owner.strokes.insert(owner.strokes.end(), contour.strokes.begin(), contour.strokes.end());
    owner.contours.push_back(c);
    const double turns = turning_of(figure.paths[c].points, true) / (2 * std::numbers::pi);
    owner.euler_region += contour.side * static_cast<int>(std::lround(turns));
  }
  for (FigureObject& owner : figure.objects) std::ranges::sort(owner.strokes);
  for (FigureOverlap& overlap : figure.overlaps) {
    overlap.upper = object[overlap.upper];
    overlap.lower = object[overlap.lower];
  }
}

}  // namespace

std::optional<LabelledFigure> build_figure(const FigureContext& context, Arrangement arrangement,
                                           const Labelling& labelling) {
  Stacks stacks = stacks_of(arrangement, labelling);
  const std::optional<std::vector<Index>> component = glue_panels(arrangement, stacks);
  if (!component) return std::nullopt;
  arrangement.unit = context.scale.unit;
  arrangement.step = context.scale.step;
  for (ContourPath& path : arrangement.paths) arrangement.raw_contours.push_back(std::move(path.raw));
  add_labels(labelling, arrangement);
  arrangement.panels = static_cast<int>(stacks.first_panel.back());
  arrangement.overlaps = find_overlaps(arrangement, stacks);
  add_objects(context.drawing, *component, arrangement);
  for (const Index face : arrangement.faces) arrangement.layers.push_back(static_cast<int>(stacks.layers[face]));
  return LabelledFigure(std::move(arrangement));
}

}  // namespace croquis::silhouette
