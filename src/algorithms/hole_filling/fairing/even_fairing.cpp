// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/fairing/even_fairing.h"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include <Eigen/SparseCholesky>

#include "algorithms/hole_filling/fairing/patch_editing.h"

namespace croquis::hole_filling {
namespace {

using Entries = std::vector<Eigen::Triplet<double>>;

/// Per vertex its neighbours, ascending: those of vertex v from `begin[v]` to `begin[v + 1]`.
struct Neighbours {
  std::vector<Index> begin, vertices;
};

Neighbours neighbours_of(const FairingInput& input, const FairingResult& patch) {
  std::vector<std::pair<Index, Index>> edges;  // in both directions
  for (const auto* triangles : {&input.surroundings, &patch.patch}) {
    for (const auto& [a, b, c] : *triangles)
      edges.insert(edges.end(), {{a, b}, {b, a}, {b, c}, {c, b}, {c, a}, {a, c}});
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  Neighbours result;
  result.begin.assign(input.points.size() + patch.new_points.size() + 1, 0);
  for (const auto& [from, to] : edges) {
    ++result.begin[from + 1];
    result.vertices.push_back(to);
  }
  for (std::size_t v = 1; v < result.begin.size(); ++v) result.begin[v] += result.begin[v - 1];
  return result;
}

/// The normal equations, their lower triangle, a vertex' equation after the other.
class Equations {
 public:
  Equations(const FairingInput& input, const FairingResult& patch)
      : known_(input.points), right_(Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(patch.new_points.size()), 3)) {}

  void add(Index vertex, std::span<const Index> neighbours) {
    Eigen::RowVector3d offset = Eigen::RowVector3d::Zero();  // the known part of the vector to the mean
    row_.clear();
    const auto place = [&](Index v, double weight) {
      if (v < known_.size()) {
        offset += weight * known_[v].transpose();
      } else {
        row_.emplace_back(static_cast<int>(v - known_.size()), weight);
      }
    };
    place(vertex, 1);
    for (const Index v : neighbours) place(v, -1 / static_cast<double>(neighbours.size()));
    for (const auto& [i, weight] : row_) {
      right_.row(i) -= weight * offset;
      for (const auto& [j, other] : row_) {
        if (j <= i) entries_.emplace_back(i, j, weight * other);
      }
    }
  }

  /// Nothing when they are singular.
  std::optional<Eigen::MatrixXd> solve() const {
    Eigen::SparseMatrix<double> matrix(right_.rows(), right_.rows());
    matrix.setFromTriplets(entries_.begin(), entries_.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
    if (solver.info() != Eigen::Success) return std::nullopt;
    Eigen::MatrixXd places = solver.solve(right_);
    if (!places.allFinite()) return std::nullopt;
    return places;
  }

 private:
  const std::vector<Vec3>& known_;
  Entries entries_;
  Eigen::MatrixXd right_;
  std::vector<std::pair<int, double>> row_;
};

}  // namespace

bool fair_evenly(const FairingInput& input, FairingResult& patch) {
  if (patch.new_points.empty()) return true;
  const Neighbours neighbours = neighbours_of(input, patch);
  Equations equations(input, patch);
  for (const Index v : vertices_of(patch.patch)) {
    const Index begin = neighbours.begin[v];
    equations.add(v, std::span(neighbours.vertices).subspan(begin, neighbours.begin[v + 1] - begin));
  }
  const auto places = equations.solve();
  if (!places) return false;
  for (std::size_t i = 0; i < patch.new_points.size(); ++i)
    patch.new_points[i] = places->row(static_cast<Eigen::Index>(i)).transpose();
  return true;
}

}  // namespace croquis::hole_filling
