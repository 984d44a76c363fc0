// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/hole_filling/quadric_normals.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include <Eigen/Dense>

namespace croquis::hole_filling {
namespace {

constexpr std::size_t neighbour_count = 16;
constexpr Eigen::Index normal_terms = 5;
constexpr Eigen::Index least_neighbours = 7;       // for five unknowns
constexpr double same_way = 0.5;                   // cosine between neighbours' normals
constexpr double least_quadric_agreement = 0.866;  // cosine between the old normal and the new
constexpr std::size_t most_places = 100;           // at which roughness is measured
constexpr std::size_t rough_neighbours = 17;       // the vertex itself among them
constexpr Eigen::Index quadric_terms = 6;
constexpr Eigen::Index least_rough = 10;
constexpr std::size_t usual_neighbour = 2;  // the third nearest: its distance is that of neighbours

/// Equations of a few neighbours: on the stack.
template <Eigen::Index terms>
using Rows = Eigen::Matrix<double, Eigen::Dynamic, terms, 0, rough_neighbours, terms>;
using Heights = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, rough_neighbours, 1>;

/// Slopes of z = a x + b y + c x² + d x y + e y² at 0, weighted by 1 / distance.
/// @param offsets in a frame whose z axis is the normal, scaled to about 1
bool slopes_of(const std::vector<Vec3>& offsets, double& a, double& b) {
  const auto rows = static_cast<Eigen::Index>(offsets.size());
  if (rows < least_neighbours) return false;
  Rows<normal_terms> matrix(rows, normal_terms);
  Heights heights(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const Vec3& p = offsets[static_cast<std::size_t>(i)];
    const double weight = 1 / p.norm();
    matrix.row(i) << p.x(), p.y(), p.x() * p.x(), p.x() * p.y(), p.y() * p.y();
    matrix.row(i) *= weight;
    heights[i] = weight * p.z();
  }
  const Eigen::ColPivHouseholderQR<Rows<normal_terms>> solver(matrix);
  if (solver.rank() < normal_terms) return false;
  const Eigen::Matrix<double, normal_terms, 1> quadric = solver.solve(heights);
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
  return found.allFinite() && found.dot(normal) > least_quadric_agreement ? found : normal;
}

/// Standard deviation of the offsets (the place's own, 0, among them) from their quadric, × the neighbours' distance.
/// @param offsets nearest first
std::optional<double> roughness_at(const std::vector<Vec3>& offsets, const Vec3& normal) {
  const auto rows = static_cast<Eigen::Index>(offsets.size());
  if (rows < least_rough) return std::nullopt;
  const Vec3 x = normal.unitOrthogonal(), y = normal.cross(x);
  const double size = offsets.back().norm();
  Rows<quadric_terms> matrix(rows, quadric_terms);
  Heights heights(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const Vec3& p = offsets[static_cast<std::size_t>(i)];
    const double u = p.dot(x) / size, v = p.dot(y) / size;
    matrix.row(i) << 1, u, v, u * u, u * v, v * v;
    heights[i] = p.dot(normal);
  }
  const Heights rest = heights - matrix * matrix.colPivHouseholderQr().solve(heights);
  const double spacing = offsets[usual_neighbour + 1].norm();
  if (!(spacing > 0)) return std::nullopt;
  return rest.norm() / std::sqrt(static_cast<double>(rows - quadric_terms)) / spacing;
}

}  // namespace

implicit::PointTree tree_of(const std::vector<ReachedVertex>& reached, const std::vector<Vec3>& positions) {
  std::vector<Vec3> places;
  for (const ReachedVertex& r : reached) places.push_back(positions[r.vertex]);
  return implicit::PointTree(places);
}

double surface_roughness(const std::vector<ReachedVertex>& reached, const std::vector<Vec3>& positions,
                         const implicit::PointTree& tree) {
  std::vector<double> found;
  for (std::size_t i = 0; i < reached.size(); i += reached.size() / most_places + 1) {
    if (reached[i].normal == Vec3::Zero()) continue;
    const Vec3& place = positions[reached[i].vertex];
    std::vector<Vec3> offsets;
    for (const Index j : tree.nearest(place, rough_neighbours)) {
      if (reached[j].normal.dot(reached[i].normal) > same_way) offsets.push_back(positions[reached[j].vertex] - place);
    }
    if (const auto roughness = roughness_at(offsets, reached[i].normal)) found.push_back(*roughness);
  }
  if (found.empty()) return 0;
  const auto middle = found.begin() + static_cast<std::ptrdiff_t>(found.size() / 2);
  std::nth_element(found.begin(), middle, found.end());
  return *middle;
}

void fit_rim_normals(std::vector<ReachedVertex>& reached, const std::vector<Vec3>& positions,
                     const implicit::PointTree& tree) {
  std::vector<Vec3> normals;
  for (std::size_t i = 0; i < reached.size() && reached[i].distance == 0; ++i) {
    const Vec3& place = positions[reached[i].vertex];
    std::vector<Vec3> neighbours;
    for (const Index j : tree.nearest(place, neighbour_count)) {
      const Vec3& neighbour = positions[reached[j].vertex];
      if (neighbour != place && reached[j].normal.dot(reached[i].normal) > same_way) neighbours.push_back(neighbour);
    }
    normals.push_back(neighbours.empty() ? reached[i].normal : fitted_normal(place, reached[i].normal, neighbours));
  }
  for (std::size_t i = 0; i < normals.size(); ++i) reached[i].normal = normals[i];
}

}  // namespace croquis::hole_filling
