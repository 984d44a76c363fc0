// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/analysis/component_measures.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Geometry>

#include "algorithms/hole_filling/triangulation/triangle_cost.h"

namespace croquis::hole_filling {
namespace {

/// Scanned things reach out farther than sheets and spheres of the same spread: by so much in the mean of 877 holes of
/// known things.
constexpr double usual_reach = 1.2;

/// Sums over the triangles of a component, by area, about its first corner so that large coordinates cost no digits.
struct Spread {
  bool is_begun = false;
  Vec3 origin = Vec3::Zero();
  double area = 0;
  Vec3 first = Vec3::Zero();  ///< moments of the triangles' centres
  double second = 0;

  void add(const Vec3& a, const Vec3& b, const Vec3& c) {
    if (!is_begun) origin = a;
    is_begun = true;
    const double weight = triangle_area(a, b, c);
    const Vec3 centre = (a + b + c) / 3 - origin;
    area += weight;
    first += weight * centre;
    second += weight * centre.squaredNorm();
  }

  /// The variance of a length evenly covered is a twelfth of its square.
  double size() const {
    if (!(area > 0)) return 0;
    return usual_reach * std::sqrt(12 * std::max(0.0, second / area - (first / area).squaredNorm()));
  }
};

/// Pieces that touch in vertices can have a rim in common: it is that of the largest.
Index largest_component(const HoleAnalysis& analysis, const Hole& hole) {
  const auto component = [&](Index corner) { return analysis.view.component[corner / 3]; };
  const Index corner = *std::max_element(hole.corners.begin(), hole.corners.end(), [&](Index a, Index b) {
    return analysis.component_area[component(a)] < analysis.component_area[component(b)];
  });
  return component(corner);
}

}  // namespace

void measure_components(const PolyMesh& mesh, HoleAnalysis& analysis) {
  const SurfaceView& view = analysis.view;
  const std::vector<Vec3>& positions = mesh.positions;
  std::vector<Spread> spreads(view.component_count);
  std::vector<Eigen::AlignedBox3d> boxes(view.component_count);
  for (std::size_t t = 0; t < view.triangles.size(); ++t) {
    const auto& [a, b, c] = view.triangles[t];
    spreads[view.component[t]].add(positions[a], positions[b], positions[c]);
    for (const Index vertex : {a, b, c}) boxes[view.component[t]].extend(positions[vertex]);
  }
  analysis.component_area.clear();
  analysis.component_diagonal.clear();
  analysis.component_size.clear();
  for (Index component = 0; component < view.component_count; ++component) {
    analysis.component_area.push_back(spreads[component].area);
    analysis.component_diagonal.push_back(boxes[component].diagonal().norm());
    analysis.component_size.push_back(spreads[component].size());
  }
  for (Hole& hole : analysis.holes) hole.component = largest_component(analysis, hole);
}

}  // namespace croquis::hole_filling
