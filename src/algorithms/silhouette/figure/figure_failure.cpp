// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/figure/figure_failure.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "algorithms/silhouette/figure/integer_program.h"
#include "algorithms/silhouette/strokes/drawing_findings.h"

namespace croquis::silhouette {
namespace {

// What leaving out an end costs, far above all completions.
constexpr double cost_left_out = 1e4;
constexpr int branches_for_failure = 200;

std::vector<Subject> all_strokes(const FigureContext& context, const PartLines& part) {
  std::set<Index> strokes;
  for (const Index line : part.lines) {
    strokes.insert(context.lines[line].strokes.begin(), context.lines[line].strokes.end());
  }
  std::vector<Subject> subjects;
  subjects.reserve(strokes.size());
  for (const Index stroke : strokes) subjects.push_back(stroke_subject(context.drawing, stroke));
  return subjects;
}

/// The piece of contour that an arc is, in words.
std::string fault_of(const FigureContext& context, const Arrangement& arrangement, const FigureArc& arc) {
  const CrossedContour& contour = arrangement.contours[arc.contour];
  const std::string stroke =
      in_quotes(context.drawing, contour.stroke[(arc.begin + arc.count / 2) % contour.stroke.size()]);
  return arc.visible ? "the drawn part of " + stroke + " would be covered"
                     : "the hidden part of " + stroke + " would lie in the open";
}

}  // namespace

Finding ends_without_partner(const FigureContext& context, const PartLines& part) {
  IntegerProgram program;  // the cheapest matching that leaves out as few ends as can be
  std::vector<std::vector<IntegerProgram::Term>> one;
  for (Index end = 0; end < part.ends.size(); ++end) {
    one.push_back({{program.add_variable(0, 1, cost_left_out), 1}});
  }
  for (const CompletionCandidate& candidate : part.candidates) {
    const Index taken = program.add_variable(0, 1, std::min(candidate.cost(), cost_left_out));
    one[candidate.a].push_back({taken, 1});
    one[candidate.b].push_back({taken, 1});
  }
  for (std::vector<IntegerProgram::Term>& row : one) program.add_row(std::move(row), 1, 1);
  const std::vector<int> values = program.solve(branches_for_failure).values;
  std::vector<Subject> subjects;
  std::string names;
  for (Index i = 0; i < part.ends.size() && i < values.size(); ++i) {
    if (values[i] == 0) continue;
    const HiddenEnd& end = context.junctions.ends[part.ends[i]];
    const Index stroke = context.lines[end.line].end_stroke(end.at_start);
    subjects.push_back(stroke_subject(context.drawing, stroke, end.at));
    names += (names.empty() ? "" : ", ") + in_quotes(context.drawing, stroke);
  }
  if (subjects.empty()) return no_solid("the hidden ends can't all be connected in pairs", all_strokes(context, part));
  return no_solid("nothing comes out again that the hidden end of " + names + " could be connected to",
                  std::move(subjects));
}

Finding no_labelling(const FigureContext& context, const PartLines& part, const Arrangement& arrangement,
                     const Faces& faces, const Labelling& relaxed) {
  constexpr int most_told = 3;
  std::vector<std::string> faults;
  std::vector<Subject> subjects;
  const auto blame = [&](Index contour, Index segment) {
    const CrossedContour& crossed = arrangement.contours[contour];
    const auto count = static_cast<Index>(crossed.stroke.size());
    const Index stroke = crossed.stroke[segment % count];
    subjects.push_back(stroke_subject(context.drawing, stroke, arrangement.points[crossed.vertices[segment % count]]));
    return in_quotes(context.drawing, stroke);
  };
  for (const Index wrong : relaxed.wrong_arcs) {
    const FigureArc& arc = arrangement.arcs[wrong];
    blame(arc.contour, arc.begin + arc.count / 2);
    faults.push_back(fault_of(context, arrangement, arc));
  }
  for (const Index wrong : relaxed.wrong_crossings) {
    const ContourCrossing& crossing = arrangement.crossings[wrong];
    const std::string a = blame(crossing.contour_a, crossing.position_a);
    faults.push_back(a + " and " + blame(crossing.contour_b, crossing.position_b) + " contradict one another");
  }
  for (const Index wrong : relaxed.wrong_faces) {
    for (Index e = 0; e < arrangement.arcs.size(); ++e) {
      const FigureArc& arc = arrangement.arcs[e];
      const bool beyond = relaxed.side[arc.contour] > 0 ? faces.right[e] == wrong : faces.left[e] == wrong;
      if (!beyond) continue;
      faults.push_back(blame(arc.contour, arc.begin + arc.count / 2) + " would be the edge of nothing");
    }
  }
  if (faults.empty())
    return no_solid("the lines that stop at others contradict one another", all_strokes(context, part));
  std::string told;
  for (std::size_t i = 0; i < faults.size() && i < most_told; ++i) told += (i > 0 ? ", and " : "") + faults[i];
  return no_solid(told, std::move(subjects));
}

Finding contours_touch(const FigureContext& context, const PartLines& part, const Vec2& at) {
  std::set<Index> strokes;
  const double reach = context.scale.step;
  for (const Index line : part.lines) {
    const CleanLine& clean = context.lines[line];
    for (std::size_t i = 0; i < clean.points.size(); ++i) {
      if ((clean.points[i] - at).norm() <= reach) strokes.insert(clean.stroke[i]);
    }
  }
  std::vector<Subject> subjects;
  std::string names;
  for (const Index stroke : strokes) {
    subjects.push_back(stroke_subject(context.drawing, stroke, at));
    names += (names.empty() ? "" : ", ") + in_quotes(context.drawing, stroke);
  }
  if (subjects.empty()) {
    subjects = all_strokes(context, part);
    names = "hidden lines";
  }
  return make_error(Category::Geometry, "E_TOUCH",
                    "Contours meet in one point or overlap (" + names + "): move one of them a little",
                    std::move(subjects));
}

}  // namespace croquis::silhouette
