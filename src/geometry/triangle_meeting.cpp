// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/triangle_meeting.h"

#include <algorithm>

#include <Eigen/Geometry>

#include "geometry/clear_sign.h"
#include "geometry/exact_kernel.h"

namespace croquis {
namespace {

ExactKernel::Triangle_3 exact_triangle(const std::vector<Vec3>& positions, const std::array<Index, 3>& v) {
  return {exact_point(positions[v[0]]), exact_point(positions[v[1]]), exact_point(positions[v[2]])};
}

std::array<Index, 3> arranged(const std::array<Index, 3>& vertices, const std::array<std::uint8_t, 3>& order) {
  return {vertices[order[0]], vertices[order[1]], vertices[order[2]]};
}

}  // namespace

bool TriangleMeeting::make(const std::array<Index, 3>& vertices, MeetingTriangle& triangle) const {
  const Vec3& a = positions_[vertices[0]];
  const Vec3& b = positions_[vertices[1]];
  const Vec3& c = positions_[vertices[2]];
  triangle = {vertices, longest_edge_squared(a, b, c)};
  return clearly_has_area(a, b, c, triangle.longest) ||
         !CGAL::collinear(exact_point(a), exact_point(b), exact_point(c));
}

bool TriangleMeeting::operator()(const MeetingTriangle& a, const MeetingTriangle& b,
                                 const SharedCorners& shared) const {
  const Corners u = arranged(a.vertices, shared.first);
  const Corners v = arranged(b.vertices, shared.second);
  const double longest = std::max(a.longest, b.longest);
  switch (shared.count) {
    case 0: return !clearly_apart(u, v) && meet_anywhere(u, v);
    case 1: return !clearly_apart_around_vertex(u, v, longest) && meet_beyond_vertex(u, v);
    case 2: return !clearly_unfolded(u, v, longest) && fold_over(u, v);
    default: return true;
  }
}

/// By a plane across the line between the centroids.
bool TriangleMeeting::clearly_apart(const Corners& u, const Corners& v) const {
  const Vec3& origin = positions_[u[0]];
  const std::array<Vec3, 2> a = {positions_[u[1]] - origin, positions_[u[2]] - origin};
  const std::array<Vec3, 3> b = {positions_[v[0]] - origin, positions_[v[1]] - origin, positions_[v[2]] - origin};
  const Vec3 across = b[0] + b[1] + b[2] - a[0] - a[1];
  const double size =
      std::max({a[0].squaredNorm(), a[1].squaredNorm(), b[0].squaredNorm(), b[1].squaredNorm(), b[2].squaredNorm()});
  if (!(size < largest_square)) return false;
  const double high_a = std::max({0.0, across.dot(a[0]), across.dot(a[1])});
  const double low_b = std::min({across.dot(b[0]), across.dot(b[1]), across.dot(b[2])});
  return low_b - high_a > 5 * sign_margin * size + smallest_product;  // `across` is five of these long at most
}

/// By a plane through the common vertex u[0] = v[0].
bool TriangleMeeting::clearly_apart_around_vertex(const Corners& u, const Corners& v, double longest) const {
  if (!(longest < largest_square)) return false;
  const Vec3& origin = positions_[u[0]];
  std::array<Vec3, 2> a = {positions_[u[1]] - origin, positions_[u[2]] - origin};
  std::array<Vec3, 2> b = {positions_[v[1]] - origin, positions_[v[2]] - origin};
  const auto separates = [&](const Vec3& across, double margin) {
    return std::max(across.dot(a[0]), across.dot(a[1])) < -margin &&
           std::min(across.dot(b[0]), across.dot(b[1])) > margin;
  };
  if (separates(b[0] + b[1] - a[0] - a[1], 4 * sign_margin * longest + smallest_product)) return true;
  // Directions instead of distances, where the larger triangle alone turned the plane.
  for (Vec3* side : {&a[0], &a[1], &b[0], &b[1]}) side->normalize();
  return separates(b[0] + b[1] - a[0] - a[1], 4 * sign_margin + smallest_product);
}

/// Seen along the common edge from u[0] = v[0] to u[1] = v[1], the triangles clearly lie to different sides.
bool TriangleMeeting::clearly_unfolded(const Corners& u, const Corners& v, double longest) const {
  if (!(longest < largest_square)) return false;
  const Vec3& origin = positions_[u[0]];
  const Vec3 edge = positions_[u[1]] - origin;
  const Vec3 a = edge.cross(positions_[u[2]] - origin);
  const Vec3 b = edge.cross(positions_[v[2]] - origin);
  return a.dot(b) < -(sign_margin * longest * longest + smallest_product);
}

bool TriangleMeeting::meet_anywhere(const Corners& u, const Corners& v) const {
  return CGAL::do_intersect(exact_triangle(positions_, u), exact_triangle(positions_, v));
}

/// Triangles with the common vertex u[0] = v[0] that meet elsewhere too: following a common ray from the vertex, one
/// of them ends first, on its opposite edge, inside the other.
bool TriangleMeeting::meet_beyond_vertex(const Corners& u, const Corners& v) const {
  const auto opposite_edge = [&](const Corners& corners) {
    return ExactKernel::Segment_3(exact_point(positions_[corners[1]]), exact_point(positions_[corners[2]]));
  };
  return CGAL::do_intersect(exact_triangle(positions_, u), opposite_edge(v)) ||
         CGAL::do_intersect(exact_triangle(positions_, v), opposite_edge(u));
}

/// Triangles on a common edge overlap only when they lie in one plane on the same side of it.
bool TriangleMeeting::fold_over(const Corners& u, const Corners& v) const {
  const ExactKernel::Point_3 p = exact_point(positions_[u[0]]);
  const ExactKernel::Point_3 q = exact_point(positions_[u[1]]);
  const ExactKernel::Point_3 r = exact_point(positions_[u[2]]);
  const ExactKernel::Point_3 s = exact_point(positions_[v[2]]);
  return CGAL::coplanar(p, q, r, s) && CGAL::coplanar_orientation(p, q, r, s) == CGAL::POSITIVE;
}

}  // namespace croquis
