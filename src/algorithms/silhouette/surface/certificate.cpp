// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/surface/certificate.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "croquis/geometry/mesh_report.h"
#include "croquis/geometry/predicates.h"
#include "croquis/geometry/self_intersection.h"

namespace croquis::silhouette {
namespace {

constexpr double grid = 0.01;  // u: two digits after the point at the usual 1000 units

std::vector<Vec2> rounded_points(const std::vector<Vec2>& points, Rounding rounding, double unit) {
  std::vector<Vec2> result;
  for (const Vec2& p : points) result.emplace_back(rounded(p.x(), rounding, unit), rounded(p.y(), rounding, unit));
  return result;
}

/// A place that is rounded may come under a neighbour, which is steeper.
constexpr double slope_spread = 2;

/// Of a plane over a triangle, as a tangent.
template <typename Height>
double slope_of(const SheetMesh& mesh, std::size_t triangle, const Height& height) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  const Vec2 p = mesh.place[b] - mesh.place[a];
  const Vec2 q = mesh.place[c] - mesh.place[a];
  const Vec2 rise = (height(b) - height(a)) * q - (height(c) - height(a)) * p;
  return rise.norm() / std::abs(cross(p, q));
}

}  // namespace

double rounded(double value, Rounding rounding, double unit) {
  switch (rounding) {
    case Rounding::None: return value;
    case Rounding::Single: return static_cast<double>(static_cast<float>(value));
    case Rounding::Grid: return std::round(value / (grid * unit)) * (grid * unit);
  }
  return value;
}

bool sheets_in_order(const InflatedSheets& sheets, Rounding rounding, double unit) {
  const auto front = [&](Index v) { return rounded(sheets.front(v), rounding, unit); };
  const auto back = [&](Index v) { return rounded(sheets.back(v), rounding, unit); };
  const std::vector<std::uint8_t>& on_boundary = sheets.sampling.lifted.on_boundary;
  for (Index v = 0; v < on_boundary.size(); ++v) {
    const bool apart = front(v) > back(v);
    if (on_boundary[v] ? sheets.thickness[v] != 0 : !apart) return false;
  }
  const auto in_order = [&](const StackedPair& pair) {
    return pair.attached() || back(pair.upper) > front(pair.lower);
  };
  const std::vector<Vec2> points = rounded_points(sheets.sampling.points, rounding, unit);
  const auto keeps_sense = [&](const std::array<Index, 3>& t) {
    return orientation(points[t[0]], points[t[1]], points[t[2]]) > 0;
  };
  return std::ranges::all_of(sheets.pairs, in_order) &&
         std::ranges::all_of(sheets.sampling.planar.triangles, keeps_sense);
}

bool mesh_in_order(const SheetMesh& mesh, Rounding rounding, double unit) {
  const auto moved = [&](double value) { return rounded(value, rounding, unit); };
  const std::vector<Vec2> places = rounded_points(mesh.place, rounding, unit);
  const auto front = [&](Index v) { return mesh.front(v); };
  const auto back = [&](Index v) { return mesh.back(v); };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    if (orientation(places[a], places[b], places[c]) <= 0) return false;
    double aside = 0;
    double along = 0;
    for (const Index v : mesh.triangles[t]) {
      if (mesh.on_boundary[v] ? mesh.thickness[v] != 0 : !(moved(front(v)) > moved(back(v)))) return false;
      aside = std::max(aside, (places[v] - mesh.place[v]).norm());
      along = std::max({along, std::abs(moved(front(v)) - front(v)), std::abs(moved(back(v)) - back(v))});
    }
    if (!std::isfinite(mesh.clearance[t].least())) continue;
    const double slope = std::max(slope_of(mesh, t, front), slope_of(mesh, t, back));
    if (mesh.clearance[t].least() < 0 || along + slope_spread * slope * aside >= mesh.gap / 2) return false;
  }
  return true;
}

double least_gap(const InflatedSheets& sheets) {
  double least = std::numeric_limits<double>::infinity();
  for (const StackedPair& pair : sheets.pairs) {
    if (!pair.attached()) least = std::min(least, sheets.back(pair.upper) - sheets.front(pair.lower));
  }
  return least;
}

std::string topology_fault(const PolyMesh& mesh, const std::optional<int>& euler_region, Progress& progress) {
  const MeshReport figures = inspect(mesh, false, progress);
  if (!figures.closed) return "is not closed";
  if (figures.nonmanifold_edges > 0 || figures.nonmanifold_vertices > 0) return "is not a manifold";
  if (!figures.oriented || !figures.volume || *figures.volume <= 0) return "is not oriented outwards";
  if (figures.degenerate_faces > 0) return "has faces without area";
  if (euler_region && figures.euler_characteristic != 2 * *euler_region) {
    return "has Euler number " + std::to_string(figures.euler_characteristic) + " where the drawing has " +
           std::to_string(2 * *euler_region);
  }
  return {};
}

std::vector<std::array<MeshFace, 2>> meeting_faces(std::span<const PolyMesh* const> meshes, Rounding rounding,
                                                   double unit, Progress& progress,
                                                   const std::optional<MeshFaces>& among) {
  PolyMesh all;
  std::vector<MeshFace> origin;  // per face of all
  std::vector<Index> chosen;
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    if (among && among->mesh == m) {
      for (const Index face : among->faces) chosen.push_back(static_cast<Index>(origin.size()) + face);
    }
    append_triangles(*meshes[m], all);
    for (Index face = 0; face < meshes[m]->face_count(); ++face) origin.push_back({m, face});
  }
  for (Vec3& p : all.positions) p = p.unaryExpr([&](double value) { return rounded(value, rounding, unit); });
  const SelfIntersections found =
      among ? find_intersections_of(all, chosen, progress) : find_self_intersections(all, progress);
  std::vector<std::array<MeshFace, 2>> meeting;
  for (const auto& [a, b] : found.pairs) meeting.push_back({origin[a], origin[b]});
  return meeting;
}

}  // namespace croquis::silhouette
