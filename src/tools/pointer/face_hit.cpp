// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/pointer/face_hit.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "croquis/geometry/polygon_area.h"
#include "croquis/geometry/polygon_cut.h"

namespace croquis {

FaceHit::FaceHit(const Ray& ray) : ray_(ray), x_(ray.direction.unitOrthogonal()), y_(ray.direction.cross(x_)) {}

FaceHit::Seen FaceHit::seen(const Vec3& place) const {
  const Vec3 offset = place - ray_.origin;
  return {x_.dot(offset), y_.dot(offset), ray_.direction.dot(offset)};
}

std::optional<double> FaceHit::triangle(const Seen& a, const Seen& b, const Seen& c) {
  // A shared edge gives the same number with the other sign in both faces, so 0 counts as inside for both.
  const double at_a = b.x * c.y - b.y * c.x;
  const double at_b = c.x * a.y - c.y * a.x;
  const double at_c = a.x * b.y - a.y * b.x;
  const bool inside = (at_a >= 0 && at_b >= 0 && at_c >= 0) || (at_a <= 0 && at_b <= 0 && at_c <= 0);
  const double area = at_a + at_b + at_c;
  if (!inside || area == 0) return std::nullopt;
  return (at_a * a.depth + at_b * b.depth + at_c * c.depth) / area;
}

std::optional<double> FaceHit::quad(const PolyMesh& mesh, std::span<const Index> corners) const {
  const std::size_t first = quad_cut(mesh.positions, corners);
  const Seen a = seen(mesh.positions[corners[first]]);
  const Seen b = seen(mesh.positions[corners[first + 1]]);
  const Seen c = seen(mesh.positions[corners[first + 2]]);
  const Seen d = seen(mesh.positions[corners[(first + 3) % 4]]);
  const auto one = triangle(a, b, c);
  const auto two = triangle(a, c, d);
  if (one && two) return std::min(*one, *two);
  return one ? one : two;
}

std::optional<double> FaceHit::polygon(const PolyMesh& mesh, Index face) const {
  const auto corners = mesh.face(face);
  bool inside = false;
  double nearest = std::numeric_limits<double>::infinity();
  double furthest = -nearest;
  Seen a = seen(mesh.positions[corners.back()]);
  for (const Index corner : corners) {
    const Seen b = seen(mesh.positions[corner]);
    nearest = std::min(nearest, b.depth);
    furthest = std::max(furthest, b.depth);
    if ((a.y > 0) != (b.y > 0)) {
      const double side = a.x * b.y - a.y * b.x;
      if ((side > 0) == (b.y > a.y)) inside = !inside;
    }
    a = b;
  }
  if (!inside) return std::nullopt;
  const Vec3 normal = area_normal(mesh, face);
  const double across = normal.dot(ray_.direction);
  if (across == 0) return nearest;
  const double depth = normal.dot(mesh.positions[corners[0]] - ray_.origin) / across;
  return std::clamp(depth, nearest, furthest);  // a polygon needn't be flat
}

std::optional<double> FaceHit::distance(const PolyMesh& mesh, Index face) const {
  const auto corners = mesh.face(face);
  if (corners.size() < 3) return std::nullopt;
  if (corners.size() == 4) return quad(mesh, corners);
  if (corners.size() > 4) return polygon(mesh, face);
  return triangle(seen(mesh.positions[corners[0]]), seen(mesh.positions[corners[1]]), seen(mesh.positions[corners[2]]));
}

}  // namespace croquis
