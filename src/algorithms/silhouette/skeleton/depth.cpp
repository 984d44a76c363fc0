// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/skeleton/depth.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "algorithms/silhouette/skeleton/collision_rows.h"
#include "algorithms/silhouette/skeleton/depth_problem.h"
#include "algorithms/silhouette/skeleton/rest_depths.h"
#include "algorithms/silhouette/strokes/drawing_findings.h"
#include "croquis/geometry/disjoint_sets.h"

namespace croquis::silhouette {
namespace {

/// Shortfalls below this part of L disappear in the sheets' own gap; more is worth a warning.
constexpr double noticeable = 0.01;

/// A row left out of a lazy solve holds if it falls short by no more than this part of L: the solver's own accuracy.
constexpr double holds = 1e-7;

/// Stretches of chords shorter than this, or nearer to the node, in L: a joining edge would have no useful direction.
constexpr double least_stretch = 1e-3;

/// For each node the row with the largest bound.
/// @return per row of the part
std::vector<bool> most_demanding_rows(const Skeleton& skeleton, const std::vector<CollisionRow>& rows,
                                      const DepthPart& part) {
  std::vector<std::size_t> best(skeleton.nodes.size(), part.rows.size());
  for (std::size_t q = 0; q < part.rows.size(); ++q) {
    const CollisionRow& row = rows[part.rows[q]];
    for (const Index node : {row.upper, row.lower}) {
      if (best[node] == part.rows.size() || row.bound > rows[part.rows[best[node]]].bound) best[node] = q;
    }
  }
  std::vector<bool> demanding(part.rows.size(), false);
  for (const std::size_t q : best) {
    if (q < demanding.size()) demanding[q] = true;
  }
  return demanding;
}

/// The optimum of a part over all of its rows. Of many, the violated ones are added until there is none.
LeastSquaresSolution solve_part(const Skeleton& skeleton, const std::vector<CollisionRow>& rows, const DepthPart& part,
                                const DepthSettings& settings, Progress& progress, DepthResult& result) {
  LeastSquaresProblem problem = depth_problem(skeleton, part, settings);
  std::vector<bool> given(part.rows.size(), true);
  if (part.rows.size() > settings.lazy_rows) given = most_demanding_rows(skeleton, rows, part);
  LeastSquaresSolution solution;
  const auto height = [&](Index node) { return solution.x[3 * static_cast<Eigen::Index>(part.local(node))]; };
  bool violated = true;
  for (int round = 1; violated; ++round) {
    std::vector<CollisionRow> chosen;
    for (std::size_t q = 0; q < given.size(); ++q) {
      if (given[q]) chosen.push_back(rows[part.rows[q]]);
    }
    set_collision_rows(skeleton, part, chosen, problem);
    solution = solve_least_squares(problem, {}, progress);
    result.rounds = std::max(result.rounds, round);
    result.iterations = std::max(result.iterations, solution.iterations);
    result.factorisations += solution.factorisations;
    violated = false;
    for (std::size_t q = 0; q < given.size(); ++q) {
      const CollisionRow& row = rows[part.rows[q]];
      const double distance = height(row.upper) - height(row.lower);
      if (given[q] || row.bound / skeleton.scale - distance <= holds) continue;
      given[q] = true;
      violated = true;
    }
  }
  result.rows_used += static_cast<std::size_t>(std::count(given.begin(), given.end(), true));
  result.residual = std::max({result.residual, solution.primal_residual, solution.dual_residual});
  return solution;
}

/// Gives a part's nodes their heights, and their objects what the solve left open.
void take_over(const LeastSquaresSolution& solution, const DepthPart& part, Skeleton& skeleton,
               std::vector<double>& uncertainty) {
  const bool found = solution.converged && !solution.singular_objective;
  for (std::size_t n = 0; n < part.nodes.size(); ++n) {
    const auto column = static_cast<Eigen::Index>(3 * n);
    SkeletonNode& node = skeleton.nodes[part.nodes[n]];
    node.z = solution.x[column] * skeleton.scale;
    node.gradient = solution.x.segment<2>(column + 1);
    const double own = found ? solution.remaining_step.segment<3>(column).lpNorm<Eigen::Infinity>()
                             : std::numeric_limits<double>::infinity();
    if (node.object >= uncertainty.size()) uncertainty.resize(node.object + 1, 0);
    uncertainty[node.object] = std::max(uncertainty[node.object], own);
  }
}

void solve_all(Skeleton& skeleton, const LabelledFigure& figure, const DepthSettings& settings, Progress& progress,
               DepthResult& result) {
  const std::vector<CollisionRow> rows = collision_rows(skeleton, figure, settings);
  skeleton.rest = rest_depths(skeleton, object_bounds(skeleton, rows), settings, progress);
  const std::vector<DepthPart> parts = depth_parts(skeleton, rows);
  result.rows = rows.size();
  result.rows_used = 0;
  result.uncertainty.clear();
  for (const DepthPart& part : parts) {
    Progress step = progress.step("depth", 1 / static_cast<double>(parts.size()));
    take_over(solve_part(skeleton, rows, part, settings, step, result), part, skeleton, result.uncertainty);
  }
  result.collisions.clear();
  for (const CollisionRow& row : rows) {
    const double shortfall = row.bound - (skeleton.nodes[row.upper].z - skeleton.nodes[row.lower].z);
    if (shortfall > noticeable * skeleton.scale) result.collisions.push_back({row.upper, row.lower, shortfall});
  }
}

/// Height of a node's circle above a place beside its centre. Near the rim of the circle, where it would vanish, a
/// little is left so that a sheet differs from its edge.
double height_over(const SkeletonNode& node, const Vec2& place) {
  constexpr double farthest = 0.95;
  const double aside = std::min((place - node.position).norm() / node.radius, farthest);
  return node.radius * std::sqrt(1 - aside * aside);
}

/// Splits a node's chord at the borders of the panels that it passes through: each panel but the node's own gets a node
/// in the middle of the chord's stretch there, joined to the old one and as thick as the old one's circle is there. A
/// chord that spans places of opposite order may then tilt instead of making rows that contradict each other.
/// @return whether it passed through more than one panel
bool split_chord(Index index, const LabelledFigure& figure, Skeleton& skeleton) {
  const SkeletonNode whole = skeleton.nodes[index];
  SkeletonNode kept = whole;
  kept.crossed.clear();
  kept.parts.clear();
  const double least = least_stretch * skeleton.scale;
  for (std::size_t i = 0; i < whole.crossed.size(); ++i) {
    const SheetPlace& place = whole.crossed[i];
    const ChordPart& part = whole.parts[i];
    const bool own =
        place.layer == whole.place.layer && figure.faces[place.triangle] == figure.faces[whole.place.triangle];
    const bool stays = own || part.length < least || (part.middle - whole.position).norm() < least;
    SkeletonNode& node = stays ? kept : skeleton.nodes.emplace_back();
    node.crossed.push_back(place);
    node.parts.push_back(part);
    if (stays) continue;
    node.position = part.middle;
    node.radius = height_over(whole, part.middle);
    node.chord = whole.chord;
    node.place = place;
    node.object = whole.object;
    skeleton.edges.push_back({index, static_cast<Index>(skeleton.nodes.size() - 1)});
  }
  const bool changed = kept.crossed.size() < whole.crossed.size();
  skeleton.nodes[index] = std::move(kept);
  return changed;
}

/// The stroke of a node's object that has a sample nearest to a place.
Index nearest_stroke(const SkeletonNode& node, const LabelledFigure& figure, const Drawing& drawing, const Vec2& at) {
  Index nearest = no_index;
  double least = std::numeric_limits<double>::infinity();
  for (const Index stroke : figure.objects[node.object].strokes) {
    for (const StrokeSample& sample : drawing.strokes[stroke].samples) {
      const double distance = (sample.position - at).squaredNorm();
      if (distance >= least) continue;
      least = distance;
      nearest = stroke;
    }
  }
  return nearest;
}

/// The worst pair of every place: pairs that share a node, or whose nodes are neighbours, are one place.
std::vector<DepthCollision> worst_by_place(const DepthResult& result, const Skeleton& skeleton) {
  std::vector<bool> involved(skeleton.nodes.size(), false);
  DisjointSets places(skeleton.nodes.size());
  for (const DepthCollision& collision : result.collisions) {
    involved[collision.upper] = involved[collision.lower] = true;
    places.unite(collision.upper, collision.lower);
  }
  for (const auto& [i, k] : skeleton.edges) {
    if (involved[i] && involved[k]) places.unite(i, k);
  }
  std::vector<DepthCollision> worst(skeleton.nodes.size());
  for (const DepthCollision& collision : result.collisions) {
    DepthCollision& place = worst[places.root(collision.upper)];
    if (collision.shortfall > place.shortfall) place = collision;
  }
  std::erase_if(worst, [](const DepthCollision& collision) { return collision.shortfall == 0; });
  return worst;
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
  std::set<Index> nodes;
  for (const DepthCollision& collision : result.collisions) nodes.insert({collision.upper, collision.lower});
  for (const Index node : nodes) {
    if (split_chord(node, figure, skeleton)) ++result.split_chords;
  }
  if (result.split_chords > 0) {
    Progress second = progress.step("depth", 0.3);
    solve_all(skeleton, figure, settings, second, result);
  }
  progress.report(1);
  return result;
}

Findings depth_findings(const DepthResult& result, const Skeleton& skeleton, const LabelledFigure& figure,
                        const Drawing& drawing) {
  Findings findings;
  for (const DepthCollision& collision : worst_by_place(result, skeleton)) {
    std::vector<Subject> subjects;
    for (const Index n : {collision.upper, collision.lower}) {
      const SkeletonNode& node = skeleton.nodes[n];
      std::set<Index> strokes;
      for (const Vec2& end : node.chord) strokes.insert(nearest_stroke(node, figure, drawing, end));
      strokes.erase(no_index);
      for (const Index stroke : strokes) subjects.push_back(stroke_subject(drawing, stroke, node.position));
    }
    findings.push_back(make_warning(Category::Geometry, "W_COLLISION",
                                    "Two parts that lie over one another are nearer than the minimum gap: draw them "
                                    "thinner, further apart, or reduce the minimum gap",
                                    std::move(subjects)));
  }
  return findings;
}

}  // namespace croquis::silhouette
