// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/skeleton/depth.h"

#include <algorithm>
#include <limits>
#include <set>

#include "algorithms/silhouette/skeleton/chord_split.h"
#include "algorithms/silhouette/skeleton/collision_rows.h"
#include "algorithms/silhouette/skeleton/depth_problem.h"
#include "algorithms/silhouette/skeleton/rest_depths.h"

namespace croquis::silhouette {
namespace {

/// Shortfalls below this part of L disappear in the sheets' own gap; more is worth a warning.
constexpr double noticeable = 0.01;

/// A row left out of a lazy solve holds if it falls short by no more than this part of L: the solver's own accuracy.
constexpr double holds = 1e-7;

/// Adds what a part's solve left open to that of its objects.
void add_uncertainty(const LeastSquaresSolution& solution, const DepthPart& part, const Skeleton& skeleton,
                     std::vector<double>& uncertainty) {
  const bool found = solution.converged && !solution.singular_objective;
  for (std::size_t n = 0; n < part.nodes.size(); ++n) {
    const Index object = skeleton.nodes[part.nodes[n]].object;
    if (object >= uncertainty.size()) uncertainty.resize(object + 1, 0);
    const double own =
        found ? solution.remaining_step.segment<3>(static_cast<Eigen::Index>(3 * n)).lpNorm<Eigen::Infinity>()
              : std::numeric_limits<double>::infinity();
    uncertainty[object] = std::max(uncertainty[object], own);
  }
}

/// One part with the rows that its solver has been given so far.
class PartSolver {
 public:
  PartSolver(const Skeleton& skeleton, const std::vector<CollisionRow>& rows, const DepthPart& part,
             const DepthSettings& settings)
      : skeleton_(skeleton),
        rows_(rows),
        part_(part),
        problem_(depth_problem(skeleton, part, settings, skeleton.rest)),
        active_(part.rows.size(), part.rows.size() <= settings.lazy_rows) {
    if (part.rows.size() > settings.lazy_rows) activate_most_demanding();
  }

  /// The optimum over all rows, by adding the violated ones until there is none.
  LeastSquaresSolution solve(Progress& progress, DepthResult& result) {
    LeastSquaresSolution solution;
    int rounds = 0;
    do {
      std::vector<CollisionRow> given;
      for (std::size_t q = 0; q < active_.size(); ++q) {
        if (active_[q]) given.push_back(row(q));
      }
      set_collision_rows(skeleton_, part_, given, problem_);
      solution = solve_least_squares(problem_, {}, progress);
      result.iterations = std::max(result.iterations, solution.iterations);
      result.factorisations += solution.factorisations;
      ++rounds;
    } while (activate_violated(solution));
    result.rounds = std::max(result.rounds, rounds);
    result.rows_used += static_cast<std::size_t>(std::count(active_.begin(), active_.end(), true));
    result.residual = std::max({result.residual, solution.primal_residual, solution.dual_residual});
    add_uncertainty(solution, part_, skeleton_, result.uncertainty);
    return solution;
  }

 private:
  const CollisionRow& row(std::size_t q) const { return rows_[part_.rows[q]]; }

  /// For each node the row with the largest bound.
  void activate_most_demanding() {
    std::vector<std::size_t> best(skeleton_.nodes.size(), active_.size());
    for (std::size_t q = 0; q < active_.size(); ++q) {
      for (const Index node : {row(q).upper, row(q).lower}) {
        if (best[node] == active_.size() || row(q).bound > row(best[node]).bound) best[node] = q;
      }
    }
    for (const std::size_t q : best) {
      if (q < active_.size()) active_[q] = true;
    }
  }

  bool activate_violated(const LeastSquaresSolution& solution) {
    bool added = false;
    for (std::size_t q = 0; q < active_.size(); ++q) {
      if (active_[q] || row(q).bound / skeleton_.scale - gap(solution, row(q)) <= holds) continue;
      active_[q] = true;
      added = true;
    }
    return added;
  }

  double gap(const LeastSquaresSolution& solution, const CollisionRow& collision) const {
    return solution.x[column(collision.upper)] - solution.x[column(collision.lower)];
  }

  Eigen::Index column(Index node) const {
    return 3 * (std::lower_bound(part_.nodes.begin(), part_.nodes.end(), node) - part_.nodes.begin());
  }

  const Skeleton& skeleton_;
  const std::vector<CollisionRow>& rows_;
  const DepthPart& part_;
  LeastSquaresProblem problem_;
  std::vector<bool> active_;  ///< per row of the part
};

void take_over(const LeastSquaresSolution& solution, const DepthPart& part, Skeleton& skeleton) {
  for (std::size_t n = 0; n < part.nodes.size(); ++n) {
    const auto column = static_cast<Eigen::Index>(3 * n);
    SkeletonNode& node = skeleton.nodes[part.nodes[n]];
    node.z = solution.x[column] * skeleton.scale;
    node.gradient = solution.x.segment<2>(column + 1);
  }
}

/// Pairs that come too near to each other.
std::vector<DepthCollision> collisions_of(const Skeleton& skeleton, const std::vector<CollisionRow>& rows) {
  std::vector<DepthCollision> collisions;
  for (const CollisionRow& row : rows) {
    const double shortfall = row.bound - (skeleton.nodes[row.upper].z - skeleton.nodes[row.lower].z);
    if (shortfall > noticeable * skeleton.scale) collisions.push_back({row.upper, row.lower, shortfall});
  }
  return collisions;
}

void solve_all(Skeleton& skeleton, const LabelledFigure& figure, const DepthSettings& settings, Progress& progress,
               DepthResult& result) {
  const double gap = settings.options.minimum_gap * skeleton.scale;
  const std::vector<CollisionRow> rows =
      collision_rows(skeleton, figure, gap, settings.attachments, settings.thickness);
  skeleton.rest = rest_depths(skeleton, object_bounds(skeleton, rows), settings, progress);
  const std::vector<DepthPart> parts = depth_parts(skeleton, rows);
  result.rows = rows.size();
  result.rows_used = 0;
  result.uncertainty.clear();
  for (const DepthPart& part : parts) {
    Progress step = progress.step("depth", 1 / static_cast<double>(parts.size()));
    PartSolver solver(skeleton, rows, part, settings);
    take_over(solver.solve(step, result), part, skeleton);
  }
  result.collisions = collisions_of(skeleton, rows);
}

std::vector<Index> nodes_of(const std::vector<DepthCollision>& collisions) {
  std::set<Index> nodes;
  for (const DepthCollision& collision : collisions) {
    nodes.insert(collision.upper);
    nodes.insert(collision.lower);
  }
  return {nodes.begin(), nodes.end()};
}

}  // namespace

DepthWeights depth_weights(const DepthSettings& settings, Index object) {
  constexpr double least = 1e-3;  // less, and an object could float away
  const DepthOptions& options = settings.options;
  DepthWeights weights{options.weight_curvature, options.weight_orientation, options.weight_distance};
  if (object < settings.object_weights.size()) weights = settings.object_weights[object];
  for (double* weight : {&weights.curvature, &weights.orientation, &weights.distance}) {
    *weight = std::clamp(*weight, least, 1.0);
  }
  return weights;
}

DepthResult solve_depth(Skeleton& skeleton, const LabelledFigure& figure, const DepthSettings& settings,
                        Progress& progress) {
  DepthResult result;
  Progress first = progress.step("depth", 0.7);
  solve_all(skeleton, figure, settings, first, result);
  if (!result.collisions.empty()) {
    result.split_chords = split_chords(nodes_of(result.collisions), figure, skeleton);
    Progress second = progress.step("depth", 0.3);
    if (result.split_chords > 0) solve_all(skeleton, figure, settings, second, result);
  }
  progress.report(1);
  return result;
}

}  // namespace croquis::silhouette
