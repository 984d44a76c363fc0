// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/skeleton/depth_problem.h"

#include <algorithm>
#include <cmath>

#include "croquis/geometry/disjoint_sets.h"
#include "croquis/solver/sparse_rows.h"

namespace croquis::silhouette {
namespace {

/// factor times the change of the gradient in a direction.
EdgeRow gradient_change(double factor, const Vec2& direction) {
  const Vec2 w = factor * direction;
  return {0, -w.x(), -w.y(), 0, w.x(), w.y()};
}

/// Adds a row over both ends of an edge.
/// @param ends in the part
void add_edge_row(const std::array<Index, 2>& ends, const EdgeRow& row, double factor, SparseRows& rows) {
  std::array<SparseRows::Entry, 6> entries;
  for (Index i = 0; i < 6; ++i) entries[i] = {3 * ends[i / 3] + i % 3, factor * row[i]};
  rows.add(entries);
}

/// What an object's rows are multiplied by.
DepthWeights row_weights(const DepthSettings& settings, const std::vector<double>& stiffness, Index object) {
  const DepthWeights own = depth_weights(settings, object);
  const double factor = object < stiffness.size() ? stiffness[object] : 1;
  return {own.curvature * factor, own.orientation * factor, own.distance * factor};
}

/// s_i / L: half the length of the edges at each node; a node without edges stands for a disk of its radius.
std::vector<double> node_lengths(const Skeleton& skeleton, const DepthPart& part) {
  std::vector<double> lengths(part.nodes.size(), 0);
  for (const Index e : part.edges) {
    const auto& [i, k] = skeleton.edges[e];
    const double half = (skeleton.nodes[k].position - skeleton.nodes[i].position).norm() / 2;
    lengths[part.local(i)] += half;
    lengths[part.local(k)] += half;
  }
  for (std::size_t n = 0; n < lengths.size(); ++n) {
    if (lengths[n] == 0) lengths[n] = skeleton.nodes[part.nodes[n]].radius;
    lengths[n] /= skeleton.scale;
  }
  return lengths;
}

}  // namespace

EdgeRow continuity_row(const Vec2& along) {
  const double l = along.norm();
  const Vec2 t = along / l;
  return {-2 / l, -t.x(), -t.y(), 2 / l, -t.x(), -t.y()};
}

std::array<EdgeRow, 2> curvature_rows(const Vec2& along, double scale, double poisson) {
  const double l = along.norm();
  const Vec2 t = along / l;
  return {gradient_change(std::sqrt(scale / l * (1 - poisson * poisson)), t),
          gradient_change(std::sqrt(scale / l * 2 * (1 - poisson)), left_of(t))};
}

Index DepthPart::local(Index node) const {
  return static_cast<Index>(std::lower_bound(nodes.begin(), nodes.end(), node) - nodes.begin());
}

std::vector<DepthPart> depth_parts(const Skeleton& skeleton, std::span<const CollisionRow> rows) {
  DisjointSets sets(skeleton.nodes.size());
  for (const auto& [i, k] : skeleton.edges) sets.unite(i, k);
  for (const CollisionRow& row : rows) sets.unite(row.upper, row.lower);
  std::vector<Index> part_of;
  std::vector<DepthPart> parts(sets.number(part_of));
  for (Index n = 0; n < skeleton.nodes.size(); ++n) parts[part_of[n]].nodes.push_back(n);
  for (Index e = 0; e < skeleton.edges.size(); ++e) parts[part_of[skeleton.edges[e][0]]].edges.push_back(e);
  for (Index q = 0; q < rows.size(); ++q) parts[part_of[rows[q].upper]].rows.push_back(q);
  return parts;
}

LeastSquaresProblem depth_problem(const Skeleton& skeleton, const DepthPart& part, const DepthSettings& settings) {
  const std::vector<double> stiffness = settings.equally_stiff ? std::vector<double>{} : row_stiffness(skeleton);
  SparseRows objective, equalities;
  for (const Index e : part.edges) {
    const auto& [i, k] = skeleton.edges[e];
    const Vec2 along = (skeleton.nodes[k].position - skeleton.nodes[i].position) / skeleton.scale;
    const double weight = row_weights(settings, stiffness, skeleton.nodes[i].object).curvature;
    const std::array<Index, 2> ends{part.local(i), part.local(k)};
    add_edge_row(ends, continuity_row(along), 1, equalities);
    for (const EdgeRow& row : curvature_rows(along, 1)) add_edge_row(ends, row, weight, objective);
  }
  const std::vector<double> lengths = node_lengths(skeleton, part);
  std::vector<double> target(static_cast<std::size_t>(objective.size()), 0);
  for (Index n = 0; n < part.nodes.size(); ++n) {
    const Index object = skeleton.nodes[part.nodes[n]].object;
    const DepthWeights weights = row_weights(settings, stiffness, object);
    const double root = std::sqrt(lengths[n]);
    const double height = object < skeleton.rest.size() ? skeleton.rest[object] / skeleton.scale : 0;
    target.insert(target.end(), {weights.distance * root * height, 0, 0});
    objective.add({{3 * n, weights.distance * root}});
    objective.add({{3 * n + 1, weights.orientation * root}});
    objective.add({{3 * n + 2, weights.orientation * root}});
  }
  LeastSquaresProblem problem;
  problem.objective = objective.matrix(3 * part.nodes.size());
  problem.target = Eigen::Map<const Eigen::VectorXd>(target.data(), static_cast<Eigen::Index>(target.size()));
  problem.equalities = equalities.matrix(3 * part.nodes.size());
  return problem;
}

void set_collision_rows(const Skeleton& skeleton, const DepthPart& part, std::span<const CollisionRow> rows,
                        LeastSquaresProblem& problem) {
  SparseRows inequalities;
  problem.inequality_bounds.resize(static_cast<Eigen::Index>(rows.size()));
  for (const CollisionRow& row : rows) {
    problem.inequality_bounds[inequalities.size()] = row.bound / skeleton.scale;
    inequalities.add({{3 * part.local(row.upper), 1}, {3 * part.local(row.lower), -1}});
  }
  problem.inequalities = inequalities.matrix(3 * part.nodes.size());
}

}  // namespace croquis::silhouette
