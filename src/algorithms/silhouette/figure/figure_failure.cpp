// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/figure/figure_failure.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "algorithms/silhouette/figure/matching.h"
#include "algorithms/silhouette/strokes/drawing_findings.h"

namespace croquis::silhouette {
namespace {

// With more ends than this each removal is judged by the end's own candidates instead of a search.
constexpr std::size_t most_ends_to_search = 99;
constexpr std::size_t states_per_removal = 2000;

const HiddenEnd& end_of(const FigureContext& context, const PartLines& part, Index position) {
  return context.junctions.ends[part.ends[position]];
}

Index stroke_of(const FigureContext& context, const HiddenEnd& end) {
  return context.lines[end.line].end_stroke(end.at_start);
}

std::vector<Subject> all_strokes(const FigureContext& context, const PartLines& part) {
  std::set<Index> strokes;
  for (const Index line : part.lines) {
    strokes.insert(context.lines[line].strokes.begin(), context.lines[line].strokes.end());
  }
  std::vector<Subject> subjects;
  for (const Index stroke : strokes) subjects.push_back(stroke_subject(context.drawing, stroke));
  return subjects;
}

/// What joining all ends but one costs.
double cost_without(const PartLines& part, Index removed) {
  std::vector<MatchingEdge> edges;
  for (const CompletionCandidate& candidate : part.candidates) {
    if (candidate.a == removed || candidate.b == removed) continue;
    edges.push_back({candidate.a - (candidate.a > removed ? 1U : 0U), candidate.b - (candidate.b > removed ? 1U : 0U),
                     candidate.cost});
  }
  MatchingSearch search(static_cast<Index>(part.ends.size() - 1), std::move(edges), states_per_removal);
  return search.next() ? search.last_cost() : std::numeric_limits<double>::infinity();
}

/// The less an end fits any other, the less its removal costs.
double cost_by_candidates(const PartLines& part, Index removed) {
  double cheapest = std::numeric_limits<double>::infinity();
  for (const CompletionCandidate& candidate : part.candidates) {
    if (candidate.a == removed || candidate.b == removed) cheapest = std::min(cheapest, candidate.cost);
  }
  return -cheapest;
}

/// Ends of lines whose other end touches nothing; all ends when there are none of these.
std::vector<Index> suspected_ends(const FigureContext& context, const PartLines& part) {
  std::map<Index, int> hidden_ends;
  for (Index i = 0; i < part.ends.size(); ++i) ++hidden_ends[end_of(context, part, i).line];
  std::vector<Index> suspects;
  std::vector<Index> all;
  for (Index i = 0; i < part.ends.size(); ++i) {
    all.push_back(i);
    if (hidden_ends[end_of(context, part, i).line] == 1) suspects.push_back(i);
  }
  return suspects.empty() ? all : suspects;
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

Findings odd_end(const FigureContext& context, const PartLines& part) {
  if (part.ends.size() % 2 == 0) return {};
  const std::vector<Index> suspects = suspected_ends(context, part);
  Index worst = suspects.front();
  double least = std::numeric_limits<double>::infinity();
  for (const Index i : suspects) {
    const double cost = part.ends.size() <= most_ends_to_search ? cost_without(part, i) : cost_by_candidates(part, i);
    if (cost < least) {
      least = cost;
      worst = i;
    }
  }
  const HiddenEnd& end = end_of(context, part, worst);
  const Index stroke = stroke_of(context, end);
  return {make_error(Category::Geometry, "E_ODD",
                     "An odd number of lines passes behind others, and the end of " +
                         in_quotes(context.drawing, stroke) +
                         " fits no other: extend or close it, or draw what is missing",
                     {stroke_subject(context.drawing, stroke, end.at)})};
}

Findings ends_without_partner(const FigureContext& context, const PartLines& part) {
  std::vector<char> has_partner(part.ends.size(), 0);
  for (const CompletionCandidate& candidate : part.candidates) has_partner[candidate.a] = has_partner[candidate.b] = 1;
  Findings findings;
  for (Index i = 0; i < part.ends.size(); ++i) {
    if (has_partner[i]) continue;
    const HiddenEnd& end = end_of(context, part, i);
    const Index stroke = stroke_of(context, end);
    findings.push_back(make_error(Category::Geometry, "E_NO_PARTNER",
                                  "Nothing to connect the hidden end of " + in_quotes(context.drawing, stroke) +
                                      " to: draw where it comes out again, or close the stroke",
                                  {stroke_subject(context.drawing, stroke, end.at)}));
  }
  return findings;
}

Finding no_pairing(const FigureContext& context, const PartLines& part) {
  return make_error(Category::Geometry, "E_NO_LABELLING",
                    "No solid looks like this: the hidden ends can't all be connected in pairs, so check what passes "
                    "behind what",
                    all_strokes(context, part));
}

Finding no_labelling(const FigureContext& context, const PartLines& part, const Arrangement& arrangement,
                     const Labelling& relaxed) {
  if (relaxed.wrong_arcs.empty()) {
    return make_error(Category::Geometry, "E_NO_LABELLING",
                      "No solid looks like this: the lines that stop at others contradict one another, so check what "
                      "passes behind what",
                      all_strokes(context, part));
  }
  std::string faults;
  std::vector<Subject> subjects;
  for (const Index wrong : relaxed.wrong_arcs) {
    const FigureArc& arc = arrangement.arcs[wrong];
    const CrossedContour& contour = arrangement.contours[arc.contour];
    const Index middle = (arc.begin + arc.count / 2) % static_cast<Index>(contour.vertices.size());
    const Vec2 at = arrangement.points[contour.vertices[middle]];
    subjects.push_back(stroke_subject(context.drawing, contour.stroke[middle], at));
    if (subjects.size() <= 3) faults += (faults.empty() ? "" : ", and ") + fault_of(context, arrangement, arc);
  }
  return make_error(Category::Geometry, "E_NO_LABELLING",
                    "No solid looks like this: " + faults + "; check what passes behind what there",
                    std::move(subjects));
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

Finding search_limit(const FigureContext& context, const PartLines& part, int matchings) {
  return make_error(Category::Limit, "E_LIMIT",
                    "Stopped after trying the " + std::to_string(matchings) +
                        " most likely ways to connect the hidden ends: simplify this part of the drawing",
                    all_strokes(context, part));
}

}  // namespace croquis::silhouette
