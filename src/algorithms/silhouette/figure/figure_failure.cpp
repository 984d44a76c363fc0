// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/figure/figure_failure.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "algorithms/silhouette/figure/matching.h"
#include "algorithms/silhouette/strokes/drawing_findings.h"

namespace croquis::silhouette {
namespace {

// What leaving out an end costs, far above all completions.
constexpr double cost_left_out = 1e4;
constexpr int branches_for_failure = 200;
constexpr std::size_t most_told = 3;

/// Strokes and how they are called.
struct NamedStrokes {
  std::vector<Subject> subjects;
  std::string names;

  void add(const Drawing& drawing, Index stroke, const Vec2& at) {
    subjects.push_back(stroke_subject(drawing, stroke, at));
    names += (names.empty() ? "" : ", ") + in_quotes(drawing, stroke);
  }
};

std::vector<Subject> all_strokes(const FigureContext& context, const PartLines& part) {
  std::set<Index> strokes;
  for (const Index line : part.lines) {
    strokes.insert(context.lines[line].strokes.begin(), context.lines[line].strokes.end());
  }
  std::vector<Subject> subjects;
  for (const Index stroke : strokes) subjects.push_back(stroke_subject(context.drawing, stroke));
  return subjects;
}

/// E_TOUCH.
Finding contours_touch(const FigureContext& context, const PartLines& part, const Vec2& at) {
  std::set<Index> strokes;
  for (const Index line : part.lines) {
    const CleanLine& clean = context.lines[line];
    for (std::size_t i = 0; i < clean.points.size(); ++i) {
      if ((clean.points[i] - at).norm() <= context.scale.step) strokes.insert(clean.stroke[i]);
    }
  }
  NamedStrokes touching;
  for (const Index stroke : strokes) touching.add(context.drawing, stroke, at);
  if (strokes.empty()) touching = {all_strokes(context, part), "hidden lines"};
  return make_error(Category::Geometry, "E_TOUCH",
                    "Contours meet in one point or overlap (" + touching.names + "): move one of them a little",
                    std::move(touching.subjects));
}

}  // namespace

Finding ends_without_partner(const FigureContext& context, const PartLines& part) {
  std::vector<MatchingEdge> edges;
  for (Index end = 0; end < part.ends.size(); ++end) edges.push_back({end, end, cost_left_out});
  for (const CompletionCandidate& candidate : part.candidates) {
    edges.push_back({candidate.a, candidate.b, std::min(candidate.cost, cost_left_out)});
  }
  const std::vector<Index> none;
  NamedStrokes left_out;
  MatchingSearch search(static_cast<Index>(part.ends.size()), edges, branches_for_failure);
  for (const Index edge : search.next().value_or(none)) {
    if (edge >= part.ends.size()) continue;
    const HiddenEnd& end = context.junctions.ends[part.ends[edge]];
    left_out.add(context.drawing, context.lines[end.line].end_stroke(end.at_start), end.at);
  }
  if (left_out.subjects.empty()) {
    return no_solid("the hidden ends can't all be connected in pairs", all_strokes(context, part));
  }
  return no_solid("nothing comes out again that the hidden end of " + left_out.names + " could be connected to",
                  std::move(left_out.subjects));
}

Finding no_labelling(const FigureContext& context, const PartLines& part, const Arrangement& arrangement,
                     const Faces& faces) {
  if (!faces.conflicts.empty()) return contours_touch(context, part, faces.conflicts.front());
  Labelling blamed;
  if (!faces.winding.empty()) blamed = label_arrangement(arrangement, faces, LabellingRules::Blame);
  std::vector<std::string> faults;
  std::vector<Subject> subjects;
  const auto blame = [&](Index segment) {
    const Index stroke = arrangement.origins[segment].stroke;
    const Vec2& at = arrangement.points[arrangement.segments[segment].front()];
    subjects.push_back(stroke_subject(context.drawing, stroke, at));
    return in_quotes(context.drawing, stroke);
  };
  for (const Index wrong : blamed.wrong_arcs) {
    const FigureArc& arc = arrangement.arcs[wrong];
    const std::string stroke = blame(arrangement.middle_segment(arc));
    faults.push_back(arc.visible ? "the drawn part of " + stroke + " would be covered"
                                 : "the hidden part of " + stroke + " would lie in the open");
  }
  for (const Index wrong : blamed.wrong_crossings) {
    const auto& [a, b] = arrangement.crossings[wrong].strands;
    const std::string first = blame(arrangement.first_segment[a.contour] + a.position);
    const std::string second = blame(arrangement.first_segment[b.contour] + b.position);
    faults.push_back(first + " and " + second + " contradict one another");
  }
  for (const Index wrong : blamed.wrong_faces) {
    for (Index e = 0; e < arrangement.arcs.size(); ++e) {
      const FigureArc& arc = arrangement.arcs[e];
      if (faces.beside_arc[e][blamed.side[arc.contour] > 0 ? 1 : 0] != wrong) continue;
      faults.push_back(blame(arrangement.middle_segment(arc)) + " would be the edge of nothing");
    }
  }
  if (faults.empty()) {
    return no_solid("the lines that stop at others contradict one another", all_strokes(context, part));
  }
  std::string told = faults.front();
  for (std::size_t i = 1; i < faults.size() && i < most_told; ++i) told += ", and " + faults[i];
  return no_solid(told, std::move(subjects));
}

}  // namespace croquis::silhouette
