// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/patching/harmonic_values.h"

#include <algorithm>
#include <utility>

namespace croquis::hole_filling {

PatchGraph::PatchGraph(const HolePatch& patch, Index vertices_given) {
  std::vector<std::pair<Index, Index>> edges;  // both ways
  for (const auto& t : patch.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (t[i] < vertices_given) rim_.push_back(t[i]);
      edges.emplace_back(t[i], t[(i + 1) % 3]);
      edges.emplace_back(t[(i + 1) % 3], t[i]);
    }
  }
  std::sort(rim_.begin(), rim_.end());
  rim_.erase(std::unique(rim_.begin(), rim_.end()), rim_.end());
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  std::vector<Eigen::Triplet<double>> inner, outer;
  for (const auto& [from, to] : edges) {
    if (from < vertices_given) continue;
    const auto row = static_cast<int>(from - vertices_given);
    inner.emplace_back(row, row, 1.0);
    if (to >= vertices_given) {
      inner.emplace_back(row, static_cast<int>(to - vertices_given), -1.0);
    } else {
      const auto place = std::lower_bound(rim_.begin(), rim_.end(), to) - rim_.begin();
      outer.emplace_back(row, static_cast<int>(place), 1.0);
    }
  }
  const auto count = static_cast<Eigen::Index>(patch.points.size());
  to_rim_.resize(count, static_cast<Eigen::Index>(rim_.size()));
  to_rim_.setFromTriplets(outer.begin(), outer.end());
  if (count == 0) return;
  Eigen::SparseMatrix<double> matrix(count, count);
  matrix.setFromTriplets(inner.begin(), inner.end());
  laplacian_ = std::make_unique<Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>>(matrix);
}

std::vector<double> PatchGraph::harmonic(std::span<const double> known) const {
  if (!laplacian_) return {};
  const Eigen::Map<const Eigen::VectorXd> rim(known.data(), static_cast<Eigen::Index>(known.size()));
  const Eigen::VectorXd values = laplacian_->solve(to_rim_ * rim);
  return {values.begin(), values.end()};
}

}  // namespace croquis::hole_filling
