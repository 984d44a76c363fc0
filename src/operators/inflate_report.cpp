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
struct Totals {
  std::size_t contours = 0;
  std::size_t completions = 0;
  std::size_t contours_completed = 0;
  std::size_t crossings = 0;
  std::size_t arcs = 0;
  std::size_t hidden_arcs = 0;
  int panels = 0;
  std::vector<std::size_t> depth_histogram;
};

void add_arc(const FigureArc& arc, Totals& totals) {
  const auto depth = static_cast<std::size_t>(arc.depth);
  if (totals.depth_histogram.size() <= depth) totals.depth_histogram.resize(depth + 1, 0);
  ++totals.depth_histogram[depth];
  if (!arc.visible) ++totals.hidden_arcs;
}

Totals add_up(const LabelledDrawing& labelled) {
  Totals totals;
  for (const LabelledFigure& figure : labelled.figures) {
    totals.contours += figure.contours.size();
    totals.completions += figure.completions.size();
    totals.crossings += figure.crossings.size();
    totals.arcs += figure.arcs.size();
    totals.panels += figure.panels;
    std::set<Index> completed;
    for (const auto& completion : figure.completions) completed.insert(completion.contour);
    totals.contours_completed += completed.size();
    for (const FigureArc& arc : figure.arcs) add_arc(arc, totals);
  }
  return totals;
}

Report stroke_names(const Drawing& drawing, const std::vector<Index>& strokes) {
  Report names = Report::array();
  for (const Index stroke : strokes) names.push(drawing.strokes[stroke].id);
  return names;
}

Report object_list(const Drawing& drawing, const Solid& solid) {
  Report list = Report::array();
  for (const silhouette::SolidObject& object : solid.objects) {
    Report entry;
    entry.set("name", object.name)
        .set("strokes", stroke_names(drawing, object.strokes))
        .set("euler_region", object.euler_region)
        .set("euler_mesh", object.euler_mesh);
    list.push(std::move(entry));
  }
  return list;
}

/// In the sketch's own frame, y down.
Report place(const Vec2& at) { return Report::list(std::vector<double>{at.x(), -at.y()}); }

Report overlap_list(const LabelledDrawing& labelled) {
  Report list = Report::array();
  std::size_t index = 0;
  for (const LabelledFigure& figure : labelled.figures) {
    for (const silhouette::FigureOverlap& overlap : figure.overlaps) {
      Report crossings = Report::array();
      for (const Index k : overlap.crossings) crossings.push(place(figure.points[figure.crossings[k].vertex]));
      Report entry;
      entry.set("index", index++)
          .set("at", place(overlap.at))
          .set("upper", figure.objects[overlap.upper].name)
          .set("lower", figure.objects[overlap.lower].name)
          .set("crossings", std::move(crossings));
      list.push(std::move(entry));
    }
  }
  return list;
}

Report attach_suggestion_list(const LabelledDrawing& labelled) {
  Report list = Report::array();
  for (const LabelledFigure& figure : labelled.figures) {
    for (const silhouette::AttachSuggestion& suggestion : attach_suggestions(figure)) {
      Report entry;
      entry.set("a", figure.objects[suggestion.a].name)
          .set("b", figure.objects[suggestion.b].name)
          .set("at", place(suggestion.at));
      list.push(std::move(entry));
    }
  }
  return list;
}

Report shell_list(const Solid& solid) {
  Report list = Report::array();
  for (const silhouette::SolidShell& shell : solid.shells) {
    Report names = Report::array();
    for (const Index object : shell.objects) names.push(solid.objects[object].name);
    Report entry;
    entry.set("objects", std::move(names)).set("euler_mesh", shell.euler_mesh);
    list.push(std::move(entry));
  }
  return list;
}

Report attached_list(const Solid& solid) {
  Report list = Report::array();
  for (const silhouette::SolidAttachment& pair : solid.attached) {
    Report entry;
    entry.set("a", pair.a).set("b", pair.b).set("kappa", pair.kappa);
    list.push(std::move(entry));
  }
  return list;
}

std::size_t component_count(const LabelledDrawing& labelled) {
  std::size_t count = 0;
  for (const LabelledFigure& figure : labelled.figures) count += figure.objects.size();
  return count;
}

}  // namespace

Report inflate_details(const Drawing& drawing, const LabelledDrawing& labelled, const Solid& solid) {
  const Totals totals = add_up(labelled);
  Report solver;
  solver.set("iterations", solid.diagnostics.solver_iterations).set("residual", solid.diagnostics.solver_residual);
  Report details;
  details.set("strokes", drawing.strokes.size())
      .set("objects", object_list(drawing, solid))
      .set("contours", totals.contours)
      .set("completions", totals.completions)
      .set("contours_completed", totals.contours_completed)
      .set("crossings", totals.crossings)
      .set("arcs", totals.arcs)
      .set("hidden_arcs", totals.hidden_arcs)
      .set("depth_histogram", Report::list(totals.depth_histogram))
      .set("panels", totals.panels)
      .set("components", component_count(labelled))
      .set("max_depth", totals.depth_histogram.empty() ? std::size_t{0} : totals.depth_histogram.size() - 1)
      .set("skeleton_vertices", solid.diagnostics.skeleton_vertices)
      .set("collision_constraints", solid.diagnostics.collision_constraints)
      .set("overlaps", overlap_list(labelled))
      .set("shells", shell_list(solid))
      .set("attached", attached_list(solid))
      .set("attach_suggestions", attach_suggestion_list(labelled))
      .set("silhouette_iou", solid.diagnostics.silhouette_iou)
      .set("min_gap", solid.diagnostics.minimum_gap)
      .set("solver", std::move(solver));
  return details;
}

Drawing label_drawing(const Drawing& drawing, const LabelledDrawing& labelled) {
  Drawing labels;
  labels.file = drawing.file;
  labels.plane = drawing.plane;
  std::size_t first_contour = 0;
  for (const LabelledFigure& figure : labelled.figures) {
    for (const FigureArc& arc : figure.arcs) {
      const FigureContour& contour = figure.contours[arc.contour];
      Stroke stroke;
      stroke.id = "arc-" + std::to_string(labels.strokes.size());
      stroke.closed = arc.count == contour.vertices.size() && figure.crossings.empty();
      const std::size_t samples = arc.count + (stroke.closed ? 0U : 1U);
      for (std::size_t i = 0; i < samples; ++i) {
        const Index vertex = contour.vertices[(arc.begin + i) % contour.vertices.size()];
        stroke.samples.push_back({figure.points[vertex]});
      }
      stroke.data = {{"contour", std::to_string(first_contour + arc.contour)},
                     {"depth", std::to_string(arc.depth)},
                     {"object", figure.objects[contour.object].name},
                     {"visible", arc.visible ? "true" : "false"}};
      labels.strokes.push_back(std::move(stroke));
    }
    first_contour += figure.contours.size();
  }
  return labels;
}

}  // namespace croquis
