// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/items/surface_normals.h"

#include <algorithm>
#include <cmath>

namespace croquis::render {
namespace {

glm::dvec3 unit_or_zero(const glm::dvec3& vector) {
  const double squared = glm::dot(vector, vector);
  return squared > 0 ? vector / std::sqrt(squared) : glm::dvec3(0);
}

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
  const double acute = y > size ? M_PI / 2 - slope : slope;
  return x < 0 ? M_PI - acute : acute;
}

/// The area vector times two; for a quad from its diagonals, for others around the polygon.
glm::dvec3 double_area(std::span<const Index> face, std::span<const glm::dvec3> positions) {
  const glm::dvec3& first = positions[face[0]];
  if (face.size() == 4) {
    return glm::cross(positions[face[2]] - first, positions[face[3]] - positions[face[1]]);
  }
  glm::dvec3 sum(0);
  for (std::size_t i = 1; i + 1 < face.size(); ++i) {
    sum += glm::cross(positions[face[i]] - first, positions[face[i + 1]] - first);
  }
  return sum;
}

glm::dvec3 face_normal(std::span<const Index> face, std::span<const glm::dvec3> positions) {
  return face.empty() ? glm::dvec3(0) : unit_or_zero(double_area(face, positions));
}

void add_weighted(std::span<const Index> face, std::span<const Index> groups, std::span<const glm::dvec3> positions,
                  std::vector<glm::dvec3>& sums) {
  const glm::dvec3 normal = face_normal(face, positions);
  glm::dvec3 here = positions[face.back()];
  glm::dvec3 back = here - positions[face[face.size() == 1 ? 0 : face.size() - 2]];
  std::size_t corner = face.size() - 1;
  for (std::size_t next = 0; next < face.size(); corner = next++) {
    const glm::dvec3& there = positions[face[next]];
    const glm::dvec3 ahead = there - here;
    const glm::dvec3 turn = glm::cross(ahead, back);
    sums[groups[corner]] += angle_of(-glm::dot(ahead, back), std::sqrt(glm::dot(turn, turn))) * normal;
    back = ahead;
    here = there;
  }
}

}  // namespace

std::vector<glm::dvec3> face_normals(const FaceArrays& faces, std::span<const glm::dvec3> positions) {
  std::vector<glm::dvec3> normals(faces.face_count());
  for (std::size_t f = 0; f < normals.size(); ++f) {
    const Index first = faces.offsets[f];
    normals[f] = face_normal(faces.corners.subspan(first, faces.offsets[f + 1] - first), positions);
  }
  return normals;
}

std::vector<glm::vec3> group_normals(const FaceArrays& faces, std::span<const glm::dvec3> positions,
                                     std::span<const Index> corner_groups, std::size_t group_count) {
  std::vector<glm::dvec3> sums(group_count, glm::dvec3(0));
  for (std::size_t f = 0; f < faces.face_count(); ++f) {
    const Index first = faces.offsets[f];
    const Index count = faces.offsets[f + 1] - first;
    if (count == 0) continue;
    add_weighted(faces.corners.subspan(first, count), corner_groups.subspan(first, count), positions, sums);
  }
  std::vector<glm::vec3> normals;
  normals.reserve(group_count);
  for (const glm::dvec3& sum : sums) normals.emplace_back(unit_or_zero(sum));
  return normals;
}

}  // namespace croquis::render
