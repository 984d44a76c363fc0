// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/geometry/surface_normals.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "croquis/geometry/polygon_area.h"

namespace croquis {
namespace {

/// The angle of a vector with y >= 0 to the x axis, in [0, pi], to 1e-5 radians: weights need no more, and the
/// system's function is most of the work of a drag. Abramowitz and Stegun 1964, 4.4.49.
double angle_of(double x, double y) {
  const double size = std::abs(x);
  const double low = std::min(size, y);
  const double high = std::max(size, y);
  if (!(high > 0)) return 0;
  const double t = low / high;
  const double s = t * t;
  const double slope = t * (0.9998660 + s * (-0.3302995 + s * (0.1801410 + s * (-0.0851330 + s * 0.0208351))));
  const double acute = y > size ? std::numbers::pi / 2 - slope : slope;
  return x < 0 ? std::numbers::pi - acute : acute;
}

Vec3 face_normal(std::span<const Index> face, std::span<const Vec3> positions) {
  return unit_or_zero(area_normal(positions, face));
}

void add_weighted(std::span<const Index> face, std::span<const Index> groups, std::span<const Vec3> positions,
                  std::vector<Vec3>& sums) {
  const Vec3 normal = face_normal(face, positions);
  Vec3 here = positions[face.back()];
  Vec3 back = here - positions[face[face.size() == 1 ? 0 : face.size() - 2]];
  std::size_t corner = face.size() - 1;
  for (std::size_t next = 0; next < face.size(); corner = next++) {
    const Vec3& there = positions[face[next]];
    const Vec3 ahead = there - here;
    const Vec3 turn = ahead.cross(back);
    sums[groups[corner]] += angle_of(-ahead.dot(back), std::sqrt(turn.dot(turn))) * normal;
    back = ahead;
    here = there;
  }
}

}  // namespace

std::vector<Vec3> face_normals(const FaceArrays& faces, std::span<const Vec3> positions) {
  std::vector<Vec3> normals(faces.face_count());
  for (std::size_t f = 0; f < normals.size(); ++f) {
    const Index first = faces.offsets[f];
    normals[f] = face_normal(faces.corners.subspan(first, faces.offsets[f + 1] - first), positions);
  }
  return normals;
}

std::vector<Vec3> group_normals(const FaceArrays& faces, std::span<const Vec3> positions,
                                std::span<const Index> corner_groups, std::size_t group_count) {
  std::vector<Vec3> sums(group_count, Vec3::Zero());
  for (std::size_t f = 0; f < faces.face_count(); ++f) {
    const Index first = faces.offsets[f];
    const Index count = faces.offsets[f + 1] - first;
    if (count == 0) continue;
    add_weighted(faces.corners.subspan(first, count), corner_groups.subspan(first, count), positions, sums);
  }
  std::vector<Vec3> normals;
  normals.reserve(group_count);
  for (const Vec3& sum : sums) normals.emplace_back(unit_or_zero(sum));
  return normals;
}

}  // namespace croquis
