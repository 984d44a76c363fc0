// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/figure/figure_search.h"

#include <limits>
#include <set>
#include <utility>

#include "algorithms/silhouette/figure/contour_paths.h"
#include "algorithms/silhouette/figure/figure_failure.h"
#include "algorithms/silhouette/figure/labelled_figure_builder.h"
#include "algorithms/silhouette/figure/matching.h"
#include "algorithms/silhouette/figure/nested_outlines.h"

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
// What lies in the open in one of so many likeliest matchings gets other shapes, so many times.
constexpr int reshaped_matchings = 12;
constexpr int maximum_reshapings = 4;

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
    edges.push_back({candidate.a, candidate.b, candidate.cost});
  }
  return {static_cast<Index>(part.ends.size()), edges, maximum_branches};
}

/// The cheapest matching when all in it are judged: what isn't costs no less than it seems to.
std::optional<Matching> likeliest_matching(const CompletionJudge& judge, PartLines& part) {
  for (;;) {
    std::optional<Matching> chosen = matchings_of(part).next();
    if (!chosen) return std::nullopt;
    bool dearer = false;
    for (const Index candidate : *chosen) dearer = judge.judge(part.candidates[candidate]) || dearer;
    if (!dearer) return chosen;
  }
}

std::vector<ChosenCompletion> in_likeliest_shapes(const Matching& matching) {
  std::vector<ChosenCompletion> chosen;
  for (const Index candidate : matching) chosen.push_back({candidate, 0});
  return chosen;
}

/// Crosses the contours of a matching and finds the faces.
Trial arrange(const FigureContext& context, const PartLines& part, const std::vector<ChosenCompletion>& chosen) {
  Trial trial;
  std::optional<ClosedContours> closed = close_contours(context, part, chosen);
  if (!closed) return trial;
  trial.closed = std::move(*closed);
  for (const double merging : mergings) {
    trial.arrangement = cross_contours(trial.closed.paths, context.order, context.scale.step, merging);
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
/// @param arcs crossed so far
std::optional<LabelledFigure> try_matching(const FigureContext& context, const PartLines& part,
                                           const Matching& matching, int reshapings, std::size_t& arcs) {
  std::vector<ChosenCompletion> chosen = in_likeliest_shapes(matching);
  for (int round = 0;; ++round) {
    Trial trial = arrange(context, part, chosen);
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
    if (round == reshapings || !reshape(trial, part, chosen)) return std::nullopt;
  }
}

}  // namespace

FigureSearch search_figure(const FigureContext& context, const std::vector<Index>& lines, const Progress& progress) {
  CompletionOptions options = context.options.completion;
  const CompletionJudge judge(context.lines, context.junctions);
  PartLines part = part_of(context, lines, options);
  std::optional<Matching> likeliest = likeliest_matching(judge, part);
  if (!likeliest) {
    // Among thin tubes a wide body's completion may seem too costly, though it is the only one there is.
    options.maximum_cost = std::numeric_limits<double>::max();
    part = part_of(context, lines, options);
    likeliest = likeliest_matching(judge, part);
  }
  if (!likeliest) return {std::nullopt, {ends_without_partner(context, part)}};
  FigureSearch result;
  std::size_t arcs = 0;
  result.figure = try_matching(context, part, *likeliest, maximum_reshapings, arcs);
  if (result.figure) return result;
  // It can't be labelled: others may be right, and the search among them needs all costs.
  for (const Index candidate : likely_candidates(part.ends.size(), part.candidates)) {
    judge.judge(part.candidates[candidate]);
  }
  MatchingSearch matchings = matchings_of(part);
  for (int tried = 0; tried < options.maximum_matchings && arcs < maximum_arcs; ++tried) {
    progress.check();
    const std::optional<Matching> matching = matchings.next();
    if (!matching) break;
    if (*matching == *likeliest) continue;
    const int reshapings = tried < reshaped_matchings ? maximum_reshapings : 0;
    result.figure = try_matching(context, part, *matching, reshapings, arcs);
    if (result.figure) return result;
  }
  const Trial trial = arrange(context, part, in_likeliest_shapes(*likeliest));
  result.findings.push_back(no_labelling(context, part, trial.arrangement, trial.faces));
  return result;
}

}  // namespace croquis::silhouette
