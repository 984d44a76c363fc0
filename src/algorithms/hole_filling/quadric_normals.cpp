// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/quadric_normals.h"

#include <cmath>

#include <Eigen/Dense>

#include "croquis/implicit/point_tree.h"

namespace croquis::hole_filling {
namespace {

constexpr std::size_t neighbour_count = 16;
constexpr Eigen::Index least_neighbours = 7;  // for five unknowns
constexpr double same_way = 0.5;              // cosine between neighbours' normals
constexpr double least_agreement = 0.866;     // cosine between the old normal and the new

/// Slopes of z = a x + b y + c x² + d x y + e y² at 0, weighted by 1 / distance.
/// @param offsets in a frame whose z axis is the normal, scaled to about 1
bool slopes_of(const std::vector<Vec3>& offsets, double& a, double& b) {
  const auto rows = static_cast<Eigen::Index>(offsets.size());
  if (rows < least_neighbours) return false;
  Eigen::MatrixXd matrix(rows, 5);
  Eigen::VectorXd heights(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const Vec3& p = offsets[static_cast<std::size_t>(i)];
    const double weight = 1 / p.norm();
    matrix.row(i) << p.x(), p.y(), p.x() * p.x(), p.x() * p.y(), p.y() * p.y();
    matrix.row(i) *= weight;
    heights[i] = weight * p.z();
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(matrix);
  if (solver.rank() < 5) return false;
  const Eigen::VectorXd quadric = solver.solve(heights);
  a = quadric[0];
  b = quadric[1];
  return true;
}

Vec3 fitted_normal(const Vec3& place, const Vec3& normal, const std::vector<Vec3>& neighbours) {
  const Vec3 x = normal.unitOrthogonal(), y = normal.cross(x);
  double size = 0;
  for (const Vec3& p : neighbours) size = std::max(size, (p - place).norm());
  std::vector<Vec3> offsets;
  for (const Vec3& p : neighbours) {
    const Vec3 away = (p - place) / size;
    offsets.emplace_back(away.dot(x), away.dot(y), away.dot(normal));
  }
  double a = 0, b = 0;
  if (!slopes_of(offsets, a, b)) return normal;
  const Vec3 found = (normal - a * x - b * y).normalized();
  return found.allFinite() && found.dot(normal) > least_agreement ? found : normal;
}

}  // namespace

void fit_rim_normals(std::vector<ReachedVertex>& reached, const std::vector<Vec3>& positions) {
  std::vector<Vec3> places;
  for (const ReachedVertex& r : reached) places.push_back(positions[r.vertex]);
  const implicit::PointTree tree(places);
  std::vector<Vec3> normals;
  for (std::size_t i = 0; i < reached.size() && reached[i].distance == 0; ++i) {
    std::vector<Vec3> neighbours;
    for (const Index j : tree.nearest(places[i], neighbour_count)) {
      if (places[j] != places[i] && reached[j].normal.dot(reached[i].normal) > same_way)
        neighbours.push_back(places[j]);
    }
    normals.push_back(neighbours.empty() ? reached[i].normal : fitted_normal(places[i], reached[i].normal, neighbours));
  }
  for (std::size_t i = 0; i < normals.size(); ++i) reached[i].normal = normals[i];
}

}  // namespace croquis::hole_filling
