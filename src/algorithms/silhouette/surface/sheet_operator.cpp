// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/surface/sheet_operator.h"

namespace croquis::silhouette {
namespace {

void add_triangle(const std::array<Index, 3>& corners, const std::vector<Vec2>& position,
                  std::vector<Eigen::Triplet<double>>& entries, Eigen::VectorXd& area) {
  const double twice_area =
      cross(position[corners[1]] - position[corners[0]], position[corners[2]] - position[corners[0]]);
  for (std::size_t k = 0; k < 3; ++k) {
    const Index apex = corners[k];
    const Index a = corners[(k + 1) % 3];
    const Index b = corners[(k + 2) % 3];
    const double weight = 0.5 * (position[a] - position[apex]).dot(position[b] - position[apex]) / twice_area;
    entries.emplace_back(a, b, -weight);
    entries.emplace_back(b, a, -weight);
    entries.emplace_back(a, a, weight);
    entries.emplace_back(b, b, weight);
    area[apex] += twice_area / 6;
  }
}

}  // namespace

SheetOperator make_sheet_operator(const SheetSampling& sheets) {
  const LiftedTriangulation& lifted = sheets.lifted;
  SheetOperator op;
  const auto count = static_cast<Eigen::Index>(lifted.planar_vertex.size());
  op.on_boundary = lifted.on_boundary;
  op.position.reserve(lifted.planar_vertex.size());
  for (const Index point : lifted.planar_vertex) op.position.push_back(sheets.points[point]);
  op.area = Eigen::VectorXd::Zero(count);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(12 * lifted.triangles.size());
  for (const auto& corners : lifted.triangles) add_triangle(corners, op.position, entries, op.area);
  op.stiffness.resize(count, count);
  op.stiffness.setFromTriplets(entries.begin(), entries.end());
  return op;
}

}  // namespace croquis::silhouette
