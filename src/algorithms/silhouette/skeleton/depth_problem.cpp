// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/skeleton/depth_problem.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "algorithms/silhouette/skeleton/depth_rows.h"
#include "croquis/geometry/disjoint_sets.h"

namespace croquis::silhouette {
namespace {

using Triplet = Eigen::Triplet<double>;

/// A sparse matrix that grows row by row.
class RowWriter {
 public:
  int rows() const { return rows_; }
  void begin_row() { ++rows_; }
  void add(Index column, double value) { entries_.emplace_back(rows_ - 1, static_cast<int>(column), value); }

  /// A row over both ends of an edge.
  void add_edge(Index from, Index to, const EdgeRow& row, double factor) {
    begin_row();
    for (Index i = 0; i < 3; ++i) {
      add(3 * from + i, factor * row[i]);
      add(3 * to + i, factor * row[i + 3]);
    }
  }

  Eigen::SparseMatrix<double> matrix(std::size_t nodes) const {
    Eigen::SparseMatrix<double> result(rows_, static_cast<Eigen::Index>(3 * nodes));
    result.setFromTriplets(entries_.begin(), entries_.end());
    return result;
  }

 private:
  int rows_ = 0;
  std::vector<Triplet> entries_;
};

/// What an object's rows are multiplied by.
class RowWeights {
 public:
  RowWeights(const Skeleton& skeleton, const DepthSettings& settings)
      : settings_(settings), stiffness_(settings.equally_stiff ? std::vector<double>{} : row_stiffness(skeleton)) {}

  DepthWeights of(Index object) const {
    DepthWeights weights = depth_weights(settings_, object);
    if (object < stiffness_.size()) {
      for (double* weight : {&weights.curvature, &weights.orientation, &weights.distance}) {
        *weight *= stiffness_[object];
      }
    }
    return weights;
  }

 private:
  const DepthSettings& settings_;
  std::vector<double> stiffness_;  ///< per object
};

Index local(const DepthPart& part, Index node) {
  return static_cast<Index>(std::lower_bound(part.nodes.begin(), part.nodes.end(), node) - part.nodes.begin());
}

/// s_i / L: half the length of the edges at each node; a node without edges stands for a disk of its radius.
std::vector<double> node_lengths(const Skeleton& skeleton, const DepthPart& part) {
  std::vector<double> lengths(part.nodes.size(), 0);
  for (const Index e : part.edges) {
    const auto& [i, k] = skeleton.edges[e];
    const double half = (skeleton.nodes[k].position - skeleton.nodes[i].position).norm() / 2;
    lengths[local(part, i)] += half;
    lengths[local(part, k)] += half;
  }
  for (std::size_t n = 0; n < lengths.size(); ++n) {
    if (lengths[n] == 0) lengths[n] = skeleton.nodes[part.nodes[n]].radius;
    lengths[n] /= skeleton.scale;
  }
  return lengths;
}

}  // namespace

std::vector<DepthPart> depth_parts(const Skeleton& skeleton, std::span<const CollisionRow> rows) {
  DisjointSets sets(skeleton.nodes.size());
  for (const auto& [i, k] : skeleton.edges) sets.unite(i, k);
  for (const CollisionRow& row : rows) sets.unite(row.upper, row.lower);
  std::vector<DepthPart> parts;
  std::vector<Index> part_of(skeleton.nodes.size(), no_index);
  for (Index n = 0; n < skeleton.nodes.size(); ++n) {
    Index& part = part_of[sets.root(n)];
    if (part == no_index) {
      part = static_cast<Index>(parts.size());
      parts.emplace_back();
    }
    parts[part].nodes.push_back(n);
  }
  for (Index e = 0; e < skeleton.edges.size(); ++e) {
    parts[part_of[sets.root(skeleton.edges[e][0])]].edges.push_back(e);
  }
  for (Index q = 0; q < rows.size(); ++q) parts[part_of[sets.root(rows[q].upper)]].rows.push_back(q);
  return parts;
}

LeastSquaresProblem depth_problem(const Skeleton& skeleton, const DepthPart& part, const DepthSettings& settings,
                                  std::span<const double> rest) {
  const RowWeights row_weights(skeleton, settings);
  RowWriter objective;
  RowWriter equalities;
  for (const Index e : part.edges) {
    const auto& [i, k] = skeleton.edges[e];
    const Vec2 along = (skeleton.nodes[k].position - skeleton.nodes[i].position) / skeleton.scale;
    const double weight = row_weights.of(skeleton.nodes[i].object).curvature;
    const Index from = local(part, i);
    const Index to = local(part, k);
    equalities.add_edge(from, to, continuity_row(along), 1);
    for (const EdgeRow& row : curvature_rows(along, 1)) objective.add_edge(from, to, row, weight);
  }
  const std::vector<double> lengths = node_lengths(skeleton, part);
  std::vector<double> target(static_cast<std::size_t>(objective.rows()), 0);
  for (Index n = 0; n < part.nodes.size(); ++n) {
    const Index object = skeleton.nodes[part.nodes[n]].object;
    const DepthWeights weights = row_weights.of(object);
    const double root = std::sqrt(lengths[n]);
    const double height = object < rest.size() ? rest[object] / skeleton.scale : 0;
    target.insert(target.end(), {weights.distance * root * height, 0, 0});
    for (const auto& [unknown, weight] :
         {std::pair{Index{0}, weights.distance}, std::pair{Index{1}, weights.orientation},
          std::pair{Index{2}, weights.orientation}}) {
      objective.begin_row();
      objective.add(3 * n + unknown, weight * root);
    }
  }
  LeastSquaresProblem problem;
  problem.objective = objective.matrix(part.nodes.size());
  problem.target = Eigen::Map<const Eigen::VectorXd>(target.data(), static_cast<Eigen::Index>(target.size()));
  problem.equalities = equalities.matrix(part.nodes.size());
  return problem;
}

void set_collision_rows(const Skeleton& skeleton, const DepthPart& part, std::span<const CollisionRow> rows,
                        LeastSquaresProblem& problem) {
  RowWriter writer;
  problem.inequality_bounds.resize(static_cast<Eigen::Index>(rows.size()));
  for (std::size_t q = 0; q < rows.size(); ++q) {
    writer.begin_row();
    writer.add(3 * local(part, rows[q].upper), 1);
    writer.add(3 * local(part, rows[q].lower), -1);
    problem.inequality_bounds[static_cast<Eigen::Index>(q)] = rows[q].bound / skeleton.scale;
  }
  problem.inequalities = writer.matrix(part.nodes.size());
}

}  // namespace croquis::silhouette
