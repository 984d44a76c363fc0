// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/figure/figure_search.h"

#include <limits>
#include <utility>

#include "algorithms/silhouette/figure/arrangement.h"
#include "algorithms/silhouette/figure/arrangement_faces.h"
#include "algorithms/silhouette/figure/contour_paths.h"
#include "algorithms/silhouette/figure/figure_failure.h"
#include "algorithms/silhouette/figure/labelled_figure_builder.h"
#include "algorithms/silhouette/figure/labelling.h"
#include "algorithms/silhouette/figure/matching.h"
#include "algorithms/silhouette/figure/nested_outlines.h"

namespace croquis::silhouette {
namespace {

// A bound of the branches of all searches for matchings of a part; drawings of 64 hidden ends need some ten.
constexpr int maximum_branches = 2000;
// A bound of the arcs of all matchings that are crossed, some ten thousandths of a second each: many hidden ends in a
// part that can't be labelled would otherwise take a minute.
constexpr std::size_t maximum_arcs = 10'000;
// Samples nearer to a crossing than this share of their segment give way to it: no slivers beside crossings.
constexpr double merging = 0.15;
// The same when the first is too coarse for two lines that run close to one another.
constexpr double least_merging = 1e-4;
// Handles of completions are changed by this share when three contours meet in a point.
constexpr double perturbation = 0.01;
constexpr int maximum_perturbations = 3;
// What lies in the open in one of so many likeliest matchings gets other shapes, so many times.
constexpr int reshaped_matchings = 12;
constexpr int maximum_reshapings = 4;

/// Contours, crossings and faces of one matching.
struct Trial {
  ClosedContours contours;
  Arrangement arrangement;
  Faces faces;
  std::vector<int> sides;
  bool usable = false;  ///< the surface lies on one side of every contour, and there are faces
  std::vector<Vec2> conflicts;
};

PartLines part_of(const FigureContext& context, const std::vector<Index>& lines, const CompletionOptions& options) {
  PartLines part;
  part.lines = lines;
  std::vector<char> included(context.lines.size(), 0);
  for (const Index line : lines) included[line] = 1;
  for (Index e = 0; e < context.junctions.ends.size(); ++e) {
    if (included[context.junctions.ends[e].line]) part.ends.push_back(e);
  }
  part.candidates =
      completion_candidates(context.lines, context.junctions, part.ends, context.completion_reference, options);
  return part;
}

class Search {
 public:
  Search(const FigureContext& context, const std::vector<Index>& lines, const Progress& progress)
      : context_(context), progress_(progress), part_(part_of(context, lines, context.options.completion)) {}

  FigureSearch run() {
    MatchingSearch matchings = this->matchings();
    std::optional<std::vector<Index>> chosen = matchings.next();
    if (!chosen) {
      // Among thin tubes a wide body's completion may seem too costly, though it is the only one there is.
      CompletionOptions generous = context_.options.completion;
      generous.maximum_cost = std::numeric_limits<double>::max();
      part_ = part_of(context_, part_.lines, generous);
      matchings = this->matchings();
      chosen = matchings.next();
    }
    FigureSearch result;
    const std::vector<Index> cheapest = chosen.value_or(std::vector<Index>{});
    const int most = context_.options.completion.maximum_matchings;
    int tried = 0;
    for (; chosen && tried < most && arcs_ < maximum_arcs; chosen = matchings.next()) {
      progress_.check();
      result.figure = try_matching(*chosen, tried++ < reshaped_matchings ? maximum_reshapings : 0);
      if (result.figure) return result;
    }
    result.findings.push_back(tried == 0 ? ends_without_partner(context_, part_) : explain(cheapest));
    return result;
  }

 private:
  MatchingSearch matchings() const {
    std::vector<MatchingEdge> edges;
    for (const CompletionCandidate& candidate : part_.candidates) {
      edges.push_back({candidate.a, candidate.b, candidate.cost()});
    }
    return {static_cast<Index>(part_.ends.size()), edges, maximum_branches};
  }

  /// The matching with its likeliest shapes, then with others for what would lie in the open.
  std::optional<LabelledFigure> try_matching(const std::vector<Index>& matching, int reshapings) {
    std::vector<ChosenCompletion> chosen = in_likeliest_shapes(matching);
    for (int round = 0;; ++round) {
      Trial trial = arrange(chosen, true);
      if (!trial.usable) return std::nullopt;
      const std::vector<NestedContour> nested =
          nested_contours(context_.drawing, trial.contours.paths, trial.arrangement, trial.faces);
      const std::vector<int> sides = sides_with(nested, trial.contours.paths);
      const Labelling labelling = label_arrangement(trial.arrangement, sides, trial.faces, LabellingRules::Full);
      if (labelling.status == IntegerProgram::Status::Optimal) {
        std::optional<LabelledFigure> figure =
            build_figure(context_, trial.contours, trial.arrangement, std::move(trial.faces), labelling);
        if (figure) figure->nested = nested_outlines(nested, trial.contours.paths);
        return figure;
      }
      if (round == reshapings || !reshape(trial, sides, chosen)) return std::nullopt;
    }
  }

  static std::vector<ChosenCompletion> in_likeliest_shapes(const std::vector<Index>& matching) {
    std::vector<ChosenCompletion> chosen;
    chosen.reserve(matching.size());
    for (const Index candidate : matching) chosen.push_back({candidate, 0});
    return chosen;
  }

  /// Gives their next shapes to completions that would lie in the open; false when there are none.
  bool reshape(const Trial& trial, const std::vector<int>& sides, std::vector<ChosenCompletion>& chosen) const {
    const Labelling relaxed = label_arrangement(trial.arrangement, sides, trial.faces, LabellingRules::Slack);
    std::vector<char> changed(chosen.size(), 0);
    bool any = false;
    for (const Index wrong : relaxed.wrong_arcs) {
      const Index k = completion_of(trial, trial.arrangement.arcs[wrong]);
      if (k == no_index || changed[k] || chosen[k].shape + 1 >= part_.candidates[chosen[k].candidate].shapes.size())
        continue;
      if (part_.candidates[chosen[k].candidate].given != no_index) continue;
      changed[k] = 1;
      ++chosen[k].shape;
      any = true;
    }
    return any;
  }

  /// Position among the chosen ones of the completion that an arc is part of.
  static Index completion_of(const Trial& trial, const FigureArc& arc) {
    if (arc.visible) return no_index;
    const CrossedContour& contour = trial.arrangement.contours[arc.contour];
    const auto count = static_cast<Index>(contour.vertices.size());
    const Vec2& middle = trial.arrangement.points[contour.vertices[(arc.begin + arc.count / 2) % count]];
    Index found = no_index;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < trial.contours.completions.size(); ++k) {
      const FigureCompletion& completion = trial.contours.completions[k];
      if (completion.contour != arc.contour) continue;
      for (const Vec2& point : completion.points) {
        const double distance = (point - middle).norm();
        if (distance >= least) continue;
        least = distance;
        found = trial.contours.choices[k];
      }
    }
    return found;
  }

  /// Crosses the contours of a matching and finds the faces; if contours meet in one point, once more with finer
  /// merging, then with changed completions. The strokes stay as they are.
  Trial arrange(const std::vector<ChosenCompletion>& chosen, bool quick_check) {
    Trial trial;
    for (int attempt = 0; attempt < 2 * (1 + maximum_perturbations); ++attempt) {
      const int perturbations = attempt / 2;
      const double stretch = perturbation * perturbations;
      std::optional<ClosedContours> contours =
          close_contours(context_.lines, context_.junctions, part_, chosen, context_.scale.step, stretch);
      if (!contours) return trial;
      trial.contours = std::move(*contours);
      trial.arrangement = cross_contours(trial.contours.paths, context_.order, context_.scale.step,
                                         attempt % 2 == 0 ? merging : least_merging);
      arcs_ += trial.arrangement.arcs.size();
      trial.sides.clear();
      for (const ContourPath& path : trial.contours.paths) trial.sides.push_back(path.side);
      // The first matching is nearly always right; only later ones are worth refusing early.
      if (quick_check && first_done_ && contradicts(trial)) return trial;
      first_done_ = true;
      FacesResult found = find_faces(trial.arrangement);
      trial.conflicts = std::move(found.conflicts);
      trial.faces = std::move(found.faces);
      trial.usable = trial.conflicts.empty();
      if (trial.usable) return trial;
    }
    return trial;
  }

  bool contradicts(const Trial& trial) const {
    return label_arrangement(trial.arrangement, trial.sides, {}, LabellingRules::Local).status ==
           IntegerProgram::Status::Infeasible;
  }

  Finding explain(const std::vector<Index>& cheapest) {
    const Trial trial = arrange(in_likeliest_shapes(cheapest), false);
    if (!trial.conflicts.empty()) return contours_touch(context_, part_, trial.conflicts.front());
    Labelling relaxed;
    if (trial.usable) {
      relaxed = label_arrangement(trial.arrangement, trial.sides, trial.faces, LabellingRules::Blame);
    }
    return no_labelling(context_, part_, trial.arrangement, trial.faces, relaxed);
  }

  const FigureContext& context_;
  const Progress& progress_;
  PartLines part_;
  std::size_t arcs_ = 0;  ///< of all matchings so far
  bool first_done_ = false;
};

}  // namespace

FigureSearch search_figure(const FigureContext& context, const std::vector<Index>& lines, const Progress& progress) {
  return Search(context, lines, progress).run();
}

}  // namespace croquis::silhouette
