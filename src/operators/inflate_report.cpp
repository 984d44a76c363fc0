// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/inflate_report.h"

#include <algorithm>
#include <set>
#include <utility>

#include "croquis/silhouette/attachment.h"

namespace croquis {
namespace {

using silhouette::FigureArc;
using silhouette::FigureContour;
using silhouette::LabelledDrawing;
using silhouette::LabelledFigure;
using silhouette::Solid;

/// Sums over all independent parts of the drawing.
void add_counts(const LabelledFigure& figure, InflateResult& result) {
  result.contours += figure.contours.size();
  result.completions += figure.completions.size();
  result.crossings += figure.crossings.size();
  result.panels += figure.panels;
  result.components += figure.objects.size();
  std::set<Index> completed;
  for (const auto& completion : figure.completions) completed.insert(completion.contour);
  result.contours_completed += completed.size();
}

/// @param first_contour number of contours in the figures before this one
void add_arcs(const LabelledFigure& figure, std::size_t first_contour, std::vector<ArcLabel>& arcs) {
  for (const FigureArc& arc : figure.arcs) {
    const std::string& object = figure.objects[figure.contours[arc.contour].object].name;
    arcs.push_back({first_contour + arc.contour, arc.depth, arc.visible, object});
  }
}

void add_overlaps(const LabelledFigure& figure, InflateResult& result) {
  for (const silhouette::FigureOverlap& overlap : figure.overlaps) {
    StrandOverlap strands{
        result.overlaps.size(), overlap.at, figure.objects[overlap.upper].name, figure.objects[overlap.lower].name, {}};
    for (const Index k : overlap.crossings) strands.crossings.push_back(figure.points[figure.crossings[k].vertex]);
    result.overlaps.push_back(std::move(strands));
  }
  for (const silhouette::AttachSuggestion& joint : attach_suggestions(figure)) {
    result.suggested.push_back({figure.objects[joint.a].name, figure.objects[joint.b].name, joint.at, joint.hold});
  }
}

void add_tube_swaps(const Drawing& drawing, const LabelledDrawing& labelled, InflateResult& result) {
  Index number = 0;
  for (const LabelledFigure& figure : labelled.figures) {
    for (const silhouette::FigureOverlap& overlap : figure.overlaps) {
      const Index index = number++;
      if (overlap.tube_crossing == no_index) continue;
      const silhouette::TubeCrossing& crossing = labelled.tube_crossings[overlap.tube_crossing];
      const Drawing swapped = swap_overlaps(drawing, labelled, {index});
      const std::string &own = drawing.strokes[crossing.stroke].id, &other = drawing.strokes[crossing.other].id;
      result.tube_swaps.push_back({crossing.at, crossing.over ? own : other, crossing.over ? other : own, own,
                                   swapped.strokes[crossing.stroke].data.at(silhouette::over_key)});
    }
  }
}

void add_solid(const Drawing& drawing, const LabelledDrawing& labelled, const Solid& solid, InflateResult& result) {
  for (const silhouette::SolidObject& object : solid.objects) {
    InflatedObject inflated{object.name, {}, object.euler_region, object.euler_mesh, object.thickness};
    for (const Index stroke : object.strokes) inflated.strokes.push_back(drawing.strokes[stroke].id);
    result.objects.push_back(std::move(inflated));
  }
  for (const silhouette::SolidShell& shell : solid.shells) {
    InflatedShell inflated{{}, shell.euler_mesh};
    for (const Index object : shell.objects) inflated.objects.push_back(solid.objects[object].name);
    result.shells.push_back(std::move(inflated));
  }
  for (const silhouette::CrossingInView& pair : labelled.crossings) {
    result.crossings_in_view.push_back(
        {drawing.strokes[pair.front].id, drawing.strokes[pair.behind].id, pair.at, pair.chosen});
  }
  result.attached = solid.attached;
  for (Index s = 0; s < labelled.kinds.size(); ++s) result.kinds.emplace_back(drawing.strokes[s].id, labelled.kinds[s]);
  result.used = solid.used;
  result.carved = solid.carved;
  result.diagnostics = solid.diagnostics;
}

/// How many arcs have 0, 1, 2 … surfaces in front.
std::vector<std::size_t> depth_histogram(const std::vector<ArcLabel>& arcs) {
  std::vector<std::size_t> histogram;
  for (const ArcLabel& arc : arcs) {
    const auto depth = static_cast<std::size_t>(arc.depth);
    if (histogram.size() <= depth) histogram.resize(depth + 1, 0);
    ++histogram[depth];
  }
  return histogram;
}

}  // namespace

InflateResult result_of_inflating(const Drawing& drawing, const LabelledDrawing& labelled, const Solid& solid) {
  InflateResult result;
  result.strokes = drawing.strokes.size();
  for (const LabelledFigure& figure : labelled.figures) {
    add_arcs(figure, result.contours, result.arcs);
    add_counts(figure, result);
    add_overlaps(figure, result);
    for (const auto& [stroke, around, hole, chosen, at] : figure.nested) {
      result.nested.push_back({drawing.strokes[stroke].id, drawing.strokes[around].id, hole, chosen, at});
    }
  }
  add_tube_swaps(drawing, labelled, result);
  add_solid(drawing, labelled, solid, result);
  return result;
}

Report to_report(const InflateResult& result) {
  Report attached = Report::array();
  for (const silhouette::SolidAttachment& pair : result.attached)
    attached.push(to_report(fields(named("a", pair.a), named("b", pair.b), named("kappa", pair.kappa),
                                   named("hold", word_of(pair.hold)), named("blend", pair.blend))));
  const std::vector<std::size_t> depths = depth_histogram(result.arcs);
  const silhouette::SolidDiagnostics& figures = result.diagnostics;
  Report report = to_report(fields(
      named("strokes", result.strokes), named("kinds", result.kinds), named("used", result.used),
      named("objects", result.objects), named("contours", result.contours), named("completions", result.completions),
      named("contours_completed", result.contours_completed), named("crossings", result.crossings),
      named("arcs", result.arcs.size()),
      named("hidden_arcs", std::ranges::count(result.arcs, false, &ArcLabel::visible)),
      named("depth_histogram", depths), named("panels", result.panels), named("components", result.components),
      named("max_depth", depths.empty() ? std::size_t{0} : depths.size() - 1),
      named("skeleton_vertices", figures.skeleton_vertices),
      named("collision_constraints", figures.collision_constraints), named("overlaps", result.overlaps),
      named("shells", result.shells), named("attached", attached), named("attach_suggestions", result.suggested),
      named("nested", result.nested), named("crossings_in_view", result.crossings_in_view),
      named("silhouette_iou", figures.silhouette_iou), named("min_gap", figures.minimum_gap),
      named("depth_ratio", figures.depth_ratio),
      named("solver",
            fields(named("iterations", figures.solver_iterations), named("residual", figures.solver_residual)))));
  if (result.carved) report.set("carved", *result.carved);
  return report;
}

std::size_t byte_size(const InflateResult& result) {
  return sizeof result + heap_size(result.kinds) + heap_size(result.objects) + heap_size(result.arcs) +
         heap_size(result.overlaps) + heap_size(result.tube_swaps) + heap_size(result.shells) +
         heap_size(result.attached) + heap_size(result.suggested) + heap_size(result.nested) +
         heap_size(result.crossings_in_view);
}

Drawing label_drawing(const Drawing& drawing, const LabelledDrawing& labelled, const std::vector<ArcLabel>& arcs) {
  Drawing labels;
  labels.file = drawing.file;
  labels.plane = drawing.plane;
  for (const LabelledFigure& figure : labelled.figures) {
    for (const FigureArc& arc : figure.arcs) {
      const FigureContour& contour = figure.contours[arc.contour];
      const ArcLabel& label = arcs[labels.strokes.size()];
      Stroke stroke;
      stroke.id = "arc-" + std::to_string(labels.strokes.size());
      stroke.closed = arc.count == contour.vertices.size() && figure.crossings.empty();
      const std::size_t samples = arc.count + (stroke.closed ? 0U : 1U);
      for (std::size_t i = 0; i < samples; ++i) {
        const Index vertex = contour.vertices[(arc.begin + i) % contour.vertices.size()];
        stroke.samples.push_back({figure.points[vertex]});
      }
      stroke.data = {{"contour", std::to_string(label.contour)},
                     {"depth", std::to_string(label.depth)},
                     {"object", label.object},
                     {"visible", label.visible ? "true" : "false"}};
      labels.strokes.push_back(std::move(stroke));
    }
  }
  return labels;
}

}  // namespace croquis
