// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/surface/sheet_operator.h"

namespace croquis::silhouette {
namespace {

void add_triangle(const std::array<Index, 3>& corners, const std::vector<Vec2>& position, double weight,
                  std::vector<Eigen::Triplet<double>>& entries, Eigen::VectorXd& area) {
  const double twice_area =
      cross(position[corners[1]] - position[corners[0]], position[corners[2]] - position[corners[0]]);
  for (std::size_t k = 0; k < 3; ++k) {
    const Index apex = corners[k];
    const Index a = corners[(k + 1) % 3];
    const Index b = corners[(k + 2) % 3];
    const double stiffness = weight / 2 * (position[a] - position[apex]).dot(position[b] - position[apex]) / twice_area;
    entries.emplace_back(a, b, -stiffness);
    entries.emplace_back(b, a, -stiffness);
    entries.emplace_back(a, a, stiffness);
    entries.emplace_back(b, b, stiffness);
    area[apex] += weight * twice_area / 6;
  }
}

}  // namespace

SheetOperator make_sheet_operator(const SheetSampling& sheets) {
  return make_sheet_operator(sheets,
                             Eigen::VectorXd::Ones(static_cast<Eigen::Index>(sheets.lifted.planar_vertex.size())));
}

SheetOperator make_sheet_operator(const SheetSampling& sheets, const Eigen::VectorXd& weight) {
  const LiftedTriangulation& lifted = sheets.lifted;
  SheetOperator op;
  const auto count = static_cast<Eigen::Index>(lifted.planar_vertex.size());
  op.on_boundary = lifted.on_boundary;
  op.position.reserve(lifted.planar_vertex.size());
  for (const Index point : lifted.planar_vertex) op.position.push_back(sheets.points[point]);
  op.area = Eigen::VectorXd::Zero(count);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(12 * lifted.triangles.size());
  for (const auto& corners : lifted.triangles) {
    const double mean = (weight[corners[0]] + weight[corners[1]] + weight[corners[2]]) / 3;
    add_triangle(corners, op.position, mean, entries, op.area);
  }
  op.stiffness.resize(count, count);
  op.stiffness.setFromTriplets(entries.begin(), entries.end());
  return op;
}

}  // namespace croquis::silhouette
