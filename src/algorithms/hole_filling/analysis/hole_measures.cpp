// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/analysis/hole_measures.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "algorithms/hole_filling/analysis/farthest_pair.h"
#include "algorithms/hole_filling/triangulation/triangle_cost.h"
#include "croquis/geometry/polygon_area.h"
#include "croquis/hole_filling/rim_triangulation.h"

namespace croquis::hole_filling {
namespace {

/// The rim in the direction of a patch, about its own first vertex so that large coordinates cost no digits.
std::vector<Vec3> local_polygon(const PolyMesh& mesh, const Hole& hole) {
  std::vector<Vec3> polygon;
  polygon.reserve(hole.vertices.size());
  const Vec3& origin = mesh.positions[hole.vertices.front()];
  for (auto vertex = hole.vertices.rbegin(); vertex != hole.vertices.rend(); ++vertex)
    polygon.push_back(mesh.positions[*vertex] - origin);
  return polygon;
}

double perimeter_of(const std::vector<Vec3>& polygon) {
  double sum = (polygon.front() - polygon.back()).norm();
  for (std::size_t i = 1; i < polygon.size(); ++i) sum += (polygon[i] - polygon[i - 1]).norm();
  return sum;
}

void measure_area(const std::vector<Vec3>& polygon, const HoleAnalysisOptions& options, Hole& hole,
                  Progress& progress) {
  RimPolygon rim;
  rim.points = polygon;
  rim.loop_ends = {static_cast<Index>(polygon.size())};
  const auto triangulation = triangulate_rim(rim, progress, {.exact_points = options.exact_area_edges});
  hole.area_is_minimal = triangulation && triangulation->is_minimal;
  // A rim on one line, or wound so that no triangulation is proper: what it spans seen along its plane.
  hole.area = triangulation ? triangulation->area : area_normal(polygon).norm();
}

/// Unit normal of a triangle that has one, else zero.
Vec3 normal_of(const PolyMesh& mesh, const SurfaceView& view, Index triangle) {
  if ((view.flags[triangle] & (SurfaceView::NoArea | SurfaceView::Sliver)) != 0) return Vec3::Zero();
  const auto& t = view.triangles[triangle];
  const Vec3& a = mesh.positions[t[0]];
  return (mesh.positions[t[1]] - a).cross(mesh.positions[t[2]] - a).normalized();
}

DirectionCone cone_of(const std::vector<Vec3>& directions, const std::vector<double>& weights) {
  DirectionCone cone;
  for (std::size_t i = 0; i < directions.size(); ++i) cone.axis += weights[i] * directions[i];
  const double length = cone.axis.norm();
  cone.axis = length > 0 ? Vec3(cone.axis / length) : Vec3::Zero();
  for (const Vec3& direction : directions) cone.angle = std::max(cone.angle, angle_between(cone.axis, direction));
  return cone;
}

/// Where the faces along the rim look and where they would go on.
void measure_directions(const PolyMesh& mesh, const SurfaceView& view, Hole& hole) {
  std::vector<Vec3> normals, conormals;
  std::vector<double> lengths;
  for (const Index corner : hole.corners) {
    const Vec3 normal = normal_of(mesh, view, corner / 3);
    const Vec3 edge = mesh.positions[view.target(corner)] - mesh.positions[view.origin(corner)];
    if (normal.isZero(0)) continue;
    normals.push_back(normal);
    conormals.push_back(edge.cross(normal).normalized());
    lengths.push_back(edge.norm());
  }
  hole.rim_normals = cone_of(normals, lengths);
  hole.conormal = cone_of(conormals, lengths).axis;
  const Vec3 axis = hole.conormal.dot(hole.normal) < 0 ? Vec3(-hole.normal) : hole.normal;
  double sum = 0, weight = 0;
  for (std::size_t i = 0; i < conormals.size(); ++i) {
    sum += lengths[i] * angle_between(conormals[i], axis);
    weight += lengths[i];
  }
  hole.conormal_tilt = weight > 0 ? sum / weight : std::numbers::pi / 2;
}

}  // namespace

void measure_hole(const PolyMesh& mesh, const SurfaceView& view, const HoleAnalysisOptions& options, Hole& hole,
                  Progress& progress) {
  const std::vector<Vec3> polygon = local_polygon(mesh, hole);
  hole.perimeter = perimeter_of(polygon);
  hole.diameter = greatest_distance(polygon);
  const RimPlane plane = plane_of_rim(polygon);
  hole.centre = plane.centre + mesh.positions[hole.vertices.front()];
  hole.normal = plane.normal;
  double deviation = 0;
  for (const Vec3& point : polygon) deviation = std::max(deviation, std::abs(plane.normal.dot(point - plane.centre)));
  hole.planarity = hole.diameter > 0 ? deviation / hole.diameter : 0;
  measure_directions(mesh, view, hole);
  measure_area(polygon, options, hole, progress);
}

}  // namespace croquis::hole_filling
