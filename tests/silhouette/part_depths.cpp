// SPDX-License-Identifier: GPL-3.0-or-later
#include "silhouette/part_depths.h"

#include <algorithm>
#include <limits>

#include <Eigen/Dense>

#include "silhouette/surface_quality.h"

namespace croquis::test {
namespace {

double plane_slope(const PolyMesh& mesh) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Vec3 right = Vec3::Zero();
  const Vec3 origin = mesh.positions.front();
  for (const Vec3& position : mesh.positions) {
    const Vec3 place = position - origin;
    const Vec3 row(place.x(), place.y(), 1);
    normal += row * row.transpose();
    right += place.z() * row;
  }
  const Vec3 plane = normal.fullPivHouseholderQr().solve(right);
  return plane.head<2>().norm();
}

}  // namespace

std::vector<PartDepth> part_depths(const silhouette::Solid& solid) {
  const AttributeChannel& channel = *solid.mesh.channel("object", Domain::Face);
  std::vector<PartDepth> parts;
  for (std::size_t object = 0; object < channel.labels.size(); ++object) {
    const PolyMesh mesh = part_of(solid.mesh, static_cast<int>(object));
    if (mesh.positions.empty()) continue;
    const auto by_height = [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); };
    const auto [low, high] = std::minmax_element(mesh.positions.begin(), mesh.positions.end(), by_height);
    parts.push_back({channel.labels[object], low->z(), high->z(), plane_slope(mesh)});
  }
  return parts;
}

std::map<std::string, PartDepth> depths_by_name(const silhouette::Solid& solid) {
  std::map<std::string, PartDepth> parts;
  for (const PartDepth& part : part_depths(solid)) parts[part.name] = part;
  return parts;
}

double middle_spread(const std::vector<PartDepth>& parts) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  double sum = 0;
  for (const PartDepth& part : parts) {
    low = std::min(low, part.middle());
    high = std::max(high, part.middle());
    sum += part.depth();
  }
  return parts.empty() ? 0 : (high - low) / sum;
}

double steepest(const std::vector<PartDepth>& parts) {
  double most = 0;
  for (const PartDepth& part : parts) most = std::max(most, part.slope);
  return most;
}

}  // namespace croquis::test
