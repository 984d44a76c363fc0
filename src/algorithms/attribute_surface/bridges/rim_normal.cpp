// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/attribute_surface/bridges/rim_normal.h"

#include <set>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

namespace croquis {
namespace {

constexpr double other_side = 0.5;   // cosine: faces beyond a crease say nothing of the surface here
constexpr double even_slope = 1e-3;  // × sum of squares: holds slopes that too few faces give

struct FaceSample {
  Vec3 area = Vec3::Zero();  ///< twice the area along the normal
  Vec3 centre = Vec3::Zero();
};

FaceSample sample_of(const PolyMesh& mesh, Index face) {
  FaceSample sample;
  const auto corners = mesh.face(face);
  for (const Index vertex : corners) sample.centre += mesh.positions[vertex];
  sample.centre /= static_cast<double>(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 a = mesh.positions[corners[i]] - sample.centre;
    const Vec3 b = mesh.positions[corners[(i + 1) % corners.size()]] - sample.centre;
    sample.area += a.cross(b);
  }
  return sample;
}

std::set<Index> faces_at(const MeshTopology& topology, Index vertex) {
  std::set<Index> faces;
  for (const Index corner : topology.vertex_corners(vertex)) faces.insert(topology.face(corner));
  return faces;
}

std::set<Index> faces_around(const PolyMesh& mesh, const MeshTopology& topology, const std::set<Index>& ring) {
  std::set<Index> faces;
  for (const Index face : ring) {
    for (const Index vertex : mesh.face(face)) faces.merge(faces_at(topology, vertex));
  }
  return faces;
}

/// The value at the origin of the linear function nearest to the samples' normals.
Vec3 carried_on(const std::vector<FaceSample>& samples, const Vec3& origin, const Vec3& mean) {
  const Vec3 u = mean.unitOrthogonal(), v = mean.cross(u);
  Eigen::Matrix3d gram = Eigen::Matrix3d::Zero(), sides = Eigen::Matrix3d::Zero();
  for (const FaceSample& sample : samples) {
    const double weight = sample.area.norm();
    const Vec3 offset = sample.centre - origin;
    const Vec3 row(1, u.dot(offset), v.dot(offset));
    gram += weight * row * row.transpose();
    sides += row * sample.area.transpose();
  }
  const double spread = gram(1, 1) + gram(2, 2);
  gram(1, 1) += even_slope * spread;
  gram(2, 2) += even_slope * spread;
  const Eigen::Matrix3d fitted = gram.ldlt().solve(sides);
  return fitted.row(0).transpose();
}

}  // namespace

Vec3 rim_normal(const PolyMesh& mesh, const MeshTopology& topology, Index vertex) {
  const std::set<Index> ring = faces_at(topology, vertex);
  Vec3 mean = Vec3::Zero();
  for (const Index face : ring) mean += sample_of(mesh, face).area;
  mean = unit_or_zero(mean);
  if (mean == Vec3::Zero()) return mean;
  std::vector<FaceSample> samples;
  for (const Index face : faces_around(mesh, topology, ring)) {
    const FaceSample sample = sample_of(mesh, face);
    if (mean.dot(sample.area) > other_side * sample.area.norm()) samples.push_back(sample);
  }
  if (samples.size() < 3) return mean;
  const Vec3 normal = unit_or_zero(carried_on(samples, mesh.positions[vertex], mean));
  return normal.dot(mean) > other_side ? normal : mean;
}

}  // namespace croquis
