// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/figure/figure_search.h"

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <string>
#include <utility>

#include "algorithms/silhouette/figure/contour_paths.h"
#include "algorithms/silhouette/figure/labelled_figure_builder.h"
#include "algorithms/silhouette/figure/matching.h"
#include "algorithms/silhouette/figure/nested_outlines.h"
#include "algorithms/silhouette/strokes/drawing_findings.h"

namespace croquis::silhouette {
namespace {

// A bound of the branches of all searches for matchings of a part; drawings of 64 hidden ends need some ten.
constexpr int maximum_branches = 2000;
// A bound of the arcs of all matchings that are crossed, some ten thousandths of a second each: many hidden ends in a
// part that can't be labelled would otherwise take a minute.
constexpr std::size_t maximum_arcs = 10'000;
// Samples nearer to a crossing than this share of their segment give way to it: no slivers beside crossings. Next the
// same when that is too coarse for two lines that run close to one another.
constexpr std::array<double, 2> mergings{0.15, 1e-4};
// What lies in the open gets other shapes, so many times.
constexpr int maximum_reshapings = 4;
// What leaving out an end costs, far above all completions.
constexpr double cost_left_out = 1e4;
constexpr int branches_for_failure = 200;
constexpr std::size_t most_told = 3;

/// Indices of the candidates that are taken.
using Matching = std::vector<Index>;

/// Contours, crossings and faces of one matching.
struct Trial {
  ClosedContours closed;
  Arrangement arrangement;
  Faces faces;  ///< none when the surface would lie on both sides of a contour, or contours touch
};

PartLines part_of(const FigureContext& context, const std::vector<Index>& lines, const CompletionOptions& options) {
  PartLines part;
  part.lines = lines;
  const std::set<Index> included(lines.begin(), lines.end());
  for (Index e = 0; e < context.junctions.ends.size(); ++e) {
    if (included.contains(context.junctions.ends[e].line)) part.ends.push_back(e);
  }
  part.candidates =
      completion_candidates(context.lines, context.junctions, part.ends, context.completion_reference, options);
  return part;
}

MatchingSearch matchings_of(const PartLines& part) {
  std::vector<MatchingEdge> edges;
  for (const CompletionCandidate& candidate : part.candidates) {
    edges.push_back({candidate.a, candidate.b, candidate.cost()});
  }
  return {static_cast<Index>(part.ends.size()), edges, maximum_branches};
}

std::vector<ChosenCompletion> in_likeliest_shapes(const Matching& matching) {
  std::vector<ChosenCompletion> chosen;
  for (const Index candidate : matching) chosen.push_back({candidate, 0});
  return chosen;
}

/// Crosses the contours of a matching and finds the faces.
/// @param refuse what contradicts at crossings alone, before the faces are found: that takes most of the time
Trial arrange(const FigureContext& context, const PartLines& part, const std::vector<ChosenCompletion>& chosen,
              bool refuse) {
  Trial trial;
  std::optional<ClosedContours> closed = close_contours(context, part, chosen);
  if (!closed) return trial;
  trial.closed = std::move(*closed);
  for (const double merging : mergings) {
    trial.arrangement = cross_contours(trial.closed.paths, context.order, context.scale.step, merging);
    if (refuse && label_arrangement(trial.arrangement, {}, LabellingRules::Full).side.empty()) break;
    trial.faces = find_faces(trial.arrangement);
    if (trial.faces.conflicts.empty()) break;
  }
  return trial;
}

/// Which of the chosen completions an arc is a piece of, no_index for none.
Index completion_of(const Arrangement& arrangement, const FigureArc& arc) {
  for (Index k = 0; k < arc.count; ++k) {
    const Index completion = arrangement.origins[arrangement.segment_of(arc, k)].completion;
    if (completion != no_index) return completion;
  }
  return no_index;
}

/// Gives their next shapes to completions that would lie in the open; false when there are none.
bool reshape(const Trial& trial, const PartLines& part, std::vector<ChosenCompletion>& chosen) {
  const Labelling relaxed = label_arrangement(trial.arrangement, trial.faces, LabellingRules::Slack);
  std::set<Index> bare;
  for (const Index wrong : relaxed.wrong_arcs) {
    const FigureArc& arc = trial.arrangement.arcs[wrong];
    if (!arc.visible) bare.insert(completion_of(trial.arrangement, arc));
  }
  bare.erase(no_index);
  bool any = false;
  for (const Index k : bare) {
    const CompletionCandidate& candidate = part.candidates[chosen[k].candidate];
    if (candidate.given != no_index || chosen[k].shape + 1 >= candidate.shapes.size()) continue;
    ++chosen[k].shape;
    any = true;
  }
  return any;
}

/// The matching with its likeliest shapes, then with others for what would lie in the open.
/// @param tried before it; the first one is nearly always right
/// @param arcs  crossed so far
std::optional<LabelledFigure> try_matching(const FigureContext& context, const PartLines& part,
                                           const Matching& matching, int tried, std::size_t& arcs) {
  std::vector<ChosenCompletion> chosen = in_likeliest_shapes(matching);
  for (int round = 0;; ++round) {
    Trial trial = arrange(context, part, chosen, tried > 0 && round == 0);
    arcs += trial.arrangement.arcs.size();
    if (trial.faces.winding.empty()) return std::nullopt;
    std::vector<NestedOutline> nested =
        read_nesting(context.drawing, trial.closed.paths, trial.faces, trial.arrangement);
    const Labelling labelling = label_arrangement(trial.arrangement, trial.faces, LabellingRules::Full);
    if (!labelling.side.empty()) {
      std::optional<LabelledFigure> figure =
          build_figure(context, trial.closed, trial.arrangement, std::move(trial.faces), labelling);
      if (figure) figure->nested = std::move(nested);
      return figure;
    }
    if (round == maximum_reshapings || !reshape(trial, part, chosen)) return std::nullopt;
  }
}

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

/// E_TOUCH, at a place where there are no faces.
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

/// E_NO_LABELLING for lines whose hidden ends can't all be paired, naming those that are left.
Finding ends_without_partner(const FigureContext& context, const PartLines& part) {
  std::vector<MatchingEdge> edges;
  for (Index end = 0; end < part.ends.size(); ++end) edges.push_back({end, end, cost_left_out});
  for (const CompletionCandidate& candidate : part.candidates) {
    edges.push_back({candidate.a, candidate.b, std::min(candidate.cost(), cost_left_out)});
  }
  NamedStrokes left_out;
  MatchingSearch search(static_cast<Index>(part.ends.size()), edges, branches_for_failure);
  for (const Index edge : search.next().value_or(Matching{})) {
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

/// E_NO_LABELLING naming the lines of which a labelling with blame had to break a rule; E_TOUCH where contours meet in
/// a way that nothing resolves.
Finding no_labelling(const FigureContext& context, const PartLines& part, const Trial& trial) {
  const Arrangement& arrangement = trial.arrangement;
  const Faces& faces = trial.faces;
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
    faults.push_back(first);
    faults.back().append(" and ").append(second).append(" contradict one another");
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

}  // namespace

FigureSearch search_figure(const FigureContext& context, const std::vector<Index>& lines, const Progress& progress) {
  CompletionOptions options = context.options.completion;
  PartLines part = part_of(context, lines, options);
  MatchingSearch matchings = matchings_of(part);
  std::optional<Matching> matching = matchings.next();
  if (!matching) {
    // Among thin tubes a wide body's completion may seem too costly, though it is the only one there is.
    options.maximum_cost = std::numeric_limits<double>::max();
    part = part_of(context, lines, options);
    matchings = matchings_of(part);
    matching = matchings.next();
  }
  if (!matching) return {std::nullopt, {ends_without_partner(context, part)}};
  const Matching cheapest = *matching;
  std::size_t arcs = 0;
  for (int tried = 0; matching && tried < options.maximum_matchings && arcs < maximum_arcs; ++tried) {
    progress.check();
    std::optional<LabelledFigure> figure = try_matching(context, part, *matching, tried, arcs);
    if (figure) return {std::move(figure), {}};
    matching = matchings.next();
  }
  return {std::nullopt, {no_labelling(context, part, arrange(context, part, in_likeliest_shapes(cheapest), false))}};
}

}  // namespace croquis::silhouette
