// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/figure/labelled_figure_builder.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <string>
#include <utility>

#include "algorithms/silhouette/figure/paneling.h"

namespace croquis::silhouette {
namespace {

void add_contours(const ClosedContours& closed, const Arrangement& arrangement, const Labelling& labelling,
                  LabelledFigure& figure) {
  for (Index c = 0; c < arrangement.contours.size(); ++c) {
    const CrossedContour& crossed = arrangement.contours[c];
    FigureContour contour;
    contour.vertices = crossed.vertices;
    contour.drawn = crossed.drawn;
    contour.strokes = closed.paths[c].strokes;
    contour.side = labelling.side[c];
    figure.contours.push_back(std::move(contour));
  }
  figure.arcs = arrangement.arcs;
  for (Index e = 0; e < figure.arcs.size(); ++e) {
    FigureArc& arc = figure.arcs[e];
    arc.depth = labelling.depth[e];
    if (!arc.visible || arc.depth == 0) continue;
    arc.visible = false;  // drawn, but covered by what was drawn over it
    std::vector<std::uint8_t>& drawn = figure.contours[arc.contour].drawn;
    for (Index k = 0; k < arc.count; ++k) drawn[(arc.begin + k) % drawn.size()] = 0;
  }
}

void add_crossings(const Arrangement& arrangement, const Labelling& labelling, LabelledFigure& figure) {
  for (Index k = 0; k < arrangement.crossings.size(); ++k) {
    const ContourCrossing& crossing = arrangement.crossings[k];
    FigureCrossing made{crossing.vertex, crossing.contour_a, crossing.position_a, crossing.contour_b,
                        crossing.position_b};
    if (!labelling.a_is_over[k]) {
      std::swap(made.over_contour, made.under_contour);
      std::swap(made.over_position, made.under_position);
    }
    figure.crossings.push_back(made);
  }
}

/// Components that a group of strokes was forced into are one object; the others are an object each.
std::vector<Index> object_of_component(const Drawing& drawing, const std::vector<std::vector<Index>>& strokes,
                                       std::vector<std::string>& names) {
  std::vector<Index> by_first_stroke(strokes.size());
  std::iota(by_first_stroke.begin(), by_first_stroke.end(), Index{0});
  std::sort(by_first_stroke.begin(), by_first_stroke.end(),
            [&](Index a, Index b) { return strokes[a].front() < strokes[b].front(); });
  std::vector<Index> object(strokes.size(), 0);
  std::map<std::string, Index> of_group;
  for (const Index component : by_first_stroke) {
    std::string group;
    for (const Index stroke : strokes[component]) {
      if (group.empty()) group = drawing.strokes[stroke].object;
    }
    const auto next = static_cast<Index>(names.size());
    object[component] = group.empty() ? next : of_group.try_emplace(group, next).first->second;
    if (object[component] == next)
      names.push_back(group.empty() ? drawing.strokes[strokes[component].front()].id : group);
  }
  return object;
}

void add_objects(const Drawing& drawing, const ClosedContours& closed, const Paneling& paneling,
                 LabelledFigure& figure) {
  std::vector<std::vector<Index>> strokes(paneling.component_count);
  for (Index c = 0; c < figure.contours.size(); ++c) {
    std::vector<Index>& list = strokes[paneling.component_of_contour[c]];
    list.insert(list.end(), figure.contours[c].strokes.begin(), figure.contours[c].strokes.end());
  }
  for (std::vector<Index>& list : strokes) std::sort(list.begin(), list.end());
  std::vector<std::string> names;
  const std::vector<Index> object = object_of_component(drawing, strokes, names);
  figure.objects.resize(names.size());
  for (Index i = 0; i < names.size(); ++i) figure.objects[i].name = names[i];
  for (Index c = 0; c < figure.contours.size(); ++c) {
    FigureContour& contour = figure.contours[c];
    contour.object = object[paneling.component_of_contour[c]];
    FigureObject& owner = figure.objects[contour.object];
    owner.contours.push_back(c);
    owner.strokes.insert(owner.strokes.end(), contour.strokes.begin(), contour.strokes.end());
    owner.euler_region += contour.side * turning_number(closed.paths[c].points);
  }
  for (FigureObject& owner : figure.objects) std::sort(owner.strokes.begin(), owner.strokes.end());
  for (const PanelOverlap& overlap : paneling.overlaps) {
    figure.overlaps.push_back(
        {overlap.at, object[overlap.upper_component], object[overlap.lower_component], overlap.crossings});
  }
}

}  // namespace

std::optional<LabelledFigure> build_figure(const FigureContext& context, const ClosedContours& contours,
                                           const Arrangement& arrangement, Faces faces, const Labelling& labelling) {
  LabelledFigure figure;
  figure.unit = context.scale.unit;
  figure.step = context.scale.step;
  figure.points = arrangement.points;
  figure.segments = arrangement.segments;
  figure.segment_arc = arrangement.segment_arc;
  figure.completions = contours.completions;
  figure.raw_contours = contours.raw;
  add_contours(contours, arrangement, labelling, figure);
  add_crossings(arrangement, labelling, figure);

  const std::vector<int> layers = face_layers(faces, labelling.side);
  figure.panels = std::accumulate(layers.begin(), layers.end(), 0);
  const Paneling paneling = glue_panels(arrangement, faces, layers, labelling.depth);
  if (!paneling.sound) return std::nullopt;
  add_objects(context.drawing, contours, paneling, figure);
  for (const Index face : faces.of_triangle) figure.layers.push_back(layers[face]);
  figure.faces = std::move(faces.of_triangle);
  figure.triangulation = std::move(faces.triangulation);
  return figure;
}

}  // namespace croquis::silhouette
