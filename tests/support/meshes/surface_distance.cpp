// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/meshes/surface_distance.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

#include <Eigen/Geometry>

#include "support/random.h"

namespace croquis::test {
namespace {

std::vector<Index> faces_from(std::size_t first, std::size_t end) {
  std::vector<Index> faces(end - std::min(first, end));
  std::iota(faces.begin(), faces.end(), static_cast<Index>(first));
  return faces;
}

std::vector<std::array<Vec3, 3>> fans_of(const PolyMesh& mesh, std::span<const Index> faces) {
  std::vector<std::array<Vec3, 3>> triangles;
  for (const Index f : faces) {
    const auto corners = mesh.face(f);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
      triangles.push_back({mesh.positions[corners[0]], mesh.positions[corners[i]], mesh.positions[corners[i + 1]]});
  }
  return triangles;
}

}  // namespace

SurfaceDistance::SurfaceDistance(const PolyMesh& mesh, std::size_t first_face)
    : SurfaceDistance(mesh, faces_from(first_face, mesh.face_count())) {}

SurfaceDistance::SurfaceDistance(const PolyMesh& mesh, std::span<const Index> faces) : tree_(fans_of(mesh, faces)) {}

double SurfaceDistance::operator()(const Vec3& point) const {
  return tree_.nearest(point, std::numeric_limits<double>::infinity()).distance;
}

std::vector<Vec3> sample_faces(const PolyMesh& mesh, std::span<const Index> faces, std::size_t count,
                               std::uint64_t seed) {
  const auto corner = [&](Index face, std::size_t i) { return mesh.positions[mesh.face(face)[i]]; };
  const auto area = [&](Index face, std::size_t i) {
    const Vec3 a = corner(face, 0);
    return (corner(face, i) - a).cross(corner(face, i + 1) - a).norm() / 2;
  };
  double whole = 0;
  for (const Index f : faces) {
    for (std::size_t i = 1; i + 1 < mesh.face(f).size(); ++i) whole += area(f, i);
  }
  Random random(seed);
  std::vector<Vec3> samples;
  double due = 0.5;
  for (const Index f : faces) {
    for (std::size_t i = 1; i + 1 < mesh.face(f).size(); ++i) {
      due += whole > 0 ? static_cast<double>(count) * area(f, i) / whole : 1;
      for (; due >= 1; --due) {
        double u = random.unit(), v = random.unit();
        if (u + v > 1) u = 1 - u, v = 1 - v;
        samples.emplace_back((1 - u - v) * corner(f, 0) + u * corner(f, i) + v * corner(f, i + 1));
      }
    }
  }
  return samples;
}

DistanceSummary summary_of_distances(std::span<const Vec3> points, const SurfaceDistance& surface) {
  DistanceSummary summary;
  for (const Vec3& p : points) {
    const double distance = surface(p);
    summary.mean += distance / static_cast<double>(points.size());
    summary.greatest = std::max(summary.greatest, distance);
  }
  return summary;
}

}  // namespace croquis::test
