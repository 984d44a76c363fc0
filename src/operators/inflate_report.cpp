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
    StrandOverlap strands{overlap.at, figure.objects[overlap.upper].name, figure.objects[overlap.lower].name, {}};
    for (const Index k : overlap.crossings) strands.crossings.push_back(figure.points[figure.crossings[k].vertex]);
    result.overlaps.push_back(std::move(strands));
  }
  for (const silhouette::AttachSuggestion& joint : attach_suggestions(figure)) {
    result.suggested.push_back({figure.objects[joint.a].name, figure.objects[joint.b].name, joint.at, joint.hold});
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

Report object_list(const InflateResult& result) {
  Report list = Report::array();
  for (const InflatedObject& object : result.objects) {
    Report entry;
    entry.set("name", object.name)
        .set("strokes", Report::list(object.strokes))
        .set("euler_region", object.euler_region)
        .set("euler_mesh", object.euler_mesh)
        .set("thickness", object.thickness);
    list.push(std::move(entry));
  }
  return list;
}

/// In the sketch's own frame, y down.
Report place(const Vec2& at) { return Report::list(std::vector<double>{at.x(), -at.y()}); }

std::string word_of(silhouette::Hold hold) {
  if (hold == silhouette::Hold::Joined) return "joined";
  return hold == silhouette::Hold::Resting ? "resting" : "apart";
}

Report overlap_list(const InflateResult& result) {
  Report list = Report::array();
  for (std::size_t index = 0; index < result.overlaps.size(); ++index) {
    const StrandOverlap& overlap = result.overlaps[index];
    Report crossings = Report::array();
    for (const Vec2& corner : overlap.crossings) crossings.push(place(corner));
    Report entry;
    entry.set("index", index)
        .set("at", place(overlap.at))
        .set("upper", overlap.upper)
        .set("lower", overlap.lower)
        .set("crossings", std::move(crossings));
    list.push(std::move(entry));
  }
  return list;
}

Report joint_list(const InflateResult& result) {
  Report list = Report::array();
  for (const SuggestedJoint& joint : result.suggested) {
    Report entry;
    entry.set("a", joint.a).set("b", joint.b).set("at", place(joint.at)).set("hold", word_of(joint.hold));
    list.push(std::move(entry));
  }
  return list;
}

Report shell_list(const InflateResult& result) {
  Report list = Report::array();
  for (const InflatedShell& shell : result.shells) {
    Report entry;
    list.push(std::move(entry.set("objects", Report::list(shell.objects)).set("euler_mesh", shell.euler_mesh)));
  }
  return list;
}

Report attached_list(const InflateResult& result) {
  Report list = Report::array();
  for (const silhouette::SolidAttachment& pair : result.attached) {
    Report entry;
    entry.set("a", pair.a).set("b", pair.b).set("kappa", pair.kappa).set("hold", word_of(pair.hold));
    list.push(std::move(entry.set("blend", pair.blend)));
  }
  return list;
}

Report nested_list(const InflateResult& result) {
  Report list = Report::array();
  for (const NestedStroke& nested : result.nested) {
    Report entry;
    entry.set("stroke", nested.stroke)
        .set("around", nested.around)
        .set("kind", nested.hole ? "hole" : "part")
        .set("chosen", nested.chosen)
        .set("at", place(nested.at));
    list.push(std::move(entry));
  }
  return list;
}

Report kind_map(const InflateResult& result) {
  Report::Object members;
  for (const auto& [stroke, kind] : result.kinds) members.emplace_back(stroke, silhouette::to_string(kind));
  return Report::of_members(std::move(members));
}

Report view_crossing_list(const InflateResult& result) {
  Report list = Report::array();
  for (const StrokesInView& pair : result.crossings_in_view) {
    Report entry;
    entry.set("front", pair.front).set("behind", pair.behind).set("chosen", pair.chosen).set("at", place(pair.at));
    list.push(std::move(entry));
  }
  return list;
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

std::size_t bytes_of(const std::vector<std::string>& names) {
  std::size_t bytes = names.capacity() * sizeof(std::string);
  for (const std::string& name : names) bytes += name.capacity();
  return bytes;
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
  add_solid(drawing, labelled, solid, result);
  return result;
}

Report to_report(const InflateResult& result) {
  const std::vector<std::size_t> depths = depth_histogram(result.arcs);
  Report solver;
  solver.set("iterations", result.diagnostics.solver_iterations).set("residual", result.diagnostics.solver_residual);
  Report details;
  details.set("strokes", result.strokes)
      .set("kinds", kind_map(result))
      .set("used", result.used)
      .set("objects", object_list(result))
      .set("contours", result.contours)
      .set("completions", result.completions)
      .set("contours_completed", result.contours_completed)
      .set("crossings", result.crossings)
      .set("arcs", result.arcs.size())
      .set("hidden_arcs", static_cast<std::size_t>(std::ranges::count(result.arcs, false, &ArcLabel::visible)))
      .set("depth_histogram", Report::list(depths))
      .set("panels", result.panels)
      .set("components", result.components)
      .set("max_depth", depths.empty() ? std::size_t{0} : depths.size() - 1)
      .set("skeleton_vertices", result.diagnostics.skeleton_vertices)
      .set("collision_constraints", result.diagnostics.collision_constraints)
      .set("overlaps", overlap_list(result))
      .set("shells", shell_list(result))
      .set("attached", attached_list(result))
      .set("attach_suggestions", joint_list(result))
      .set("nested", nested_list(result))
      .set("crossings_in_view", view_crossing_list(result))
      .set("silhouette_iou", result.diagnostics.silhouette_iou)
      .set("min_gap", result.diagnostics.minimum_gap)
      .set("depth_ratio", result.diagnostics.depth_ratio)
      .set("solver", std::move(solver));
  if (result.carved) details.set("carved", *result.carved);
  return details;
}

std::size_t byte_size(const InflateResult& result) {
  std::size_t bytes =
      sizeof(InflateResult) + result.arcs.capacity() * sizeof(ArcLabel) +
      result.objects.capacity() * sizeof(InflatedObject) + result.overlaps.capacity() * sizeof(StrandOverlap) +
      result.shells.capacity() * sizeof(InflatedShell) +
      result.attached.capacity() * sizeof(silhouette::SolidAttachment) +
      result.suggested.capacity() * sizeof(SuggestedJoint) + result.nested.capacity() * sizeof(NestedStroke) +
      result.crossings_in_view.capacity() * sizeof(StrokesInView) +
      result.kinds.capacity() * sizeof(result.kinds.front());
  for (const ArcLabel& arc : result.arcs) bytes += arc.object.capacity();
  for (const InflatedObject& object : result.objects) bytes += object.name.capacity() + bytes_of(object.strokes);
  for (const StrandOverlap& overlap : result.overlaps) bytes += overlap.crossings.capacity() * sizeof(Vec2);
  for (const InflatedShell& shell : result.shells) bytes += bytes_of(shell.objects);
  return bytes;
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
