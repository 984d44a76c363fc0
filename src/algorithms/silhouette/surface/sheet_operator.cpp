// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/surface/sheet_operator.h"

#include <algorithm>
#include <array>

namespace croquis::silhouette {
namespace {

// Triangles flatter than that (height over length) count as that high: what has no area has no stiffness that could be
// worked out.
constexpr double least_height = 1e-3;

/// Twice the area of a triangle that is no flatter than that.
double area_with_height(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return std::max(cross(b - a, c - a), least_height * longest);
}

/// A symmetric matrix of the edges' weights, negative, with the diagonal that makes every row's sum 0.
Eigen::SparseMatrix<double> stiffness_of(const LiftedTriangulation& lifted,
                                         const std::vector<std::array<double, 3>>& weights) {
  const auto count = static_cast<Eigen::Index>(lifted.planar_vertex.size());
  Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(count);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(3 * lifted.triangles.size() + 3 * lifted.planar_vertex.size());
  for (Index t = 0; t < lifted.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index other = lifted.neighbours[t][k];
      if (other < t) continue;  // each edge once; no_index is the largest number
      const Index a = lifted.triangles[t][(k + 1) % 3];
      const Index b = lifted.triangles[t][(k + 2) % 3];
      double weight = weights[t][k];
      if (other != no_index) {
        const std::array<Index, 3>& beyond = lifted.neighbours[other];
        weight += weights[other][beyond[0] == t ? 0 : beyond[1] == t ? 1 : 2];
      }
      entries.emplace_back(a, b, -weight);
      entries.emplace_back(b, a, -weight);
      diagonal[a] += weight;
      diagonal[b] += weight;
    }
  }
  for (Eigen::Index v = 0; v < count; ++v) entries.emplace_back(v, v, diagonal[v]);
  Eigen::SparseMatrix<double> stiffness(count, count);
  stiffness.setFromTriplets(entries.begin(), entries.end());
  return stiffness;
}

}  // namespace

SheetOperator make_sheet_operator(const SheetSampling& sheets, const Eigen::VectorXd& weight) {
  const LiftedTriangulation& lifted = sheets.lifted;
  SheetOperator op;
  op.on_boundary = lifted.on_boundary;
  op.position.reserve(lifted.planar_vertex.size());
  for (const Index point : lifted.planar_vertex) op.position.push_back(sheets.points[point]);
  op.area = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(lifted.planar_vertex.size()));
  std::vector<std::array<double, 3>> weights;
  weights.reserve(lifted.triangles.size());
  for (const auto& corners : lifted.triangles) {
    const auto& [a, b, c] = corners;
    const double mean = weight.size() > 0 ? (weight[a] + weight[b] + weight[c]) / 3 : 1;
    const double twice_area = area_with_height(op.position[a], op.position[b], op.position[c]);
    std::array<double, 3>& own = weights.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2& apex = op.position[corners[k]];
      const Vec2 first = op.position[corners[(k + 1) % 3]] - apex, second = op.position[corners[(k + 2) % 3]] - apex;
      own[k] = first.dot(second) / (2 * twice_area) * mean;  // half the cotangent of the angle
    }
    for (const Index v : corners) op.area[v] += mean * twice_area / 6;
  }
  op.stiffness = stiffness_of(lifted, weights);
  return op;
}

}  // namespace croquis::silhouette
