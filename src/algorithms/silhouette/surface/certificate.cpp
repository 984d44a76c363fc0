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

std::string topology_fault(const MeshReport& figures, const std::optional<int>& euler_region) {
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

bool triangles_keep_sense(const SheetSampling& sampling, Rounding rounding, double unit) {
  std::vector<Vec2> points;
  points.reserve(sampling.points.size());
  for (const Vec2& p : sampling.points) {
    points.emplace_back(rounded(p.x(), rounding, unit), rounded(p.y(), rounding, unit));
  }
  const auto keeps = [&](const std::array<Index, 3>& t) {
    return orientation(points[t[0]], points[t[1]], points[t[2]]) > 0;
  };
  return std::all_of(sampling.planar.triangles.begin(), sampling.planar.triangles.end(), keeps);
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

/// Several meshes as one, rounded.
struct RoundedMeshes {
  RoundedMeshes(std::span<const CertificateInput> meshes, Rounding rounding, double unit) {
    for (std::size_t m = 0; m < meshes.size(); ++m) {
      const PolyMesh& mesh = *meshes[m].mesh;
      const auto first = static_cast<Index>(all.positions.size());
      for (const Vec3& p : mesh.positions) {
        all.positions.push_back(p.unaryExpr([&](double value) { return rounded(value, rounding, unit); }));
      }
      const auto first_corner = static_cast<Index>(all.corners.size());
      for (const Index corner : mesh.corners) all.corners.push_back(first + corner);
      for (Index f = 0; f < mesh.face_count(); ++f) {
        all.face_offsets.push_back(first_corner + mesh.face_offsets[f + 1]);
        origin.push_back({m, f});
      }
    }
  }

  std::vector<std::array<MeshFace, 2>> pairs(const SelfIntersections& found) const {
    std::vector<std::array<MeshFace, 2>> meeting;
    for (const auto& [a, b] : found.pairs) meeting.push_back({origin[a], origin[b]});
    return meeting;
  }

  PolyMesh all;
  std::vector<MeshFace> origin;  ///< per face of all
};

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
  const auto front = [&](Index v) { return rounded(sheets.z[v] + sheets.thickness[v], rounding, unit); };
  const auto back = [&](Index v) { return rounded(sheets.z[v] - sheets.thickness[v], rounding, unit); };
  const std::vector<std::uint8_t>& on_boundary = sheets.sampling.lifted.on_boundary;
  for (Index v = 0; v < on_boundary.size(); ++v) {
    const bool apart = front(v) > back(v);
    if (on_boundary[v] ? sheets.thickness[v] != 0 : !apart) return false;
  }
  const auto in_order = [&](const StackedPair& pair) {
    return pair.attached() || back(pair.upper) > front(pair.lower);
  };
  return std::all_of(sheets.pairs.begin(), sheets.pairs.end(), in_order) &&
         triangles_keep_sense(sheets.sampling, rounding, unit);
}

bool mesh_in_order(const SheetMesh& mesh, Rounding rounding, double unit) {
  const auto moved = [&](double value) { return rounded(value, rounding, unit); };
  std::vector<Vec2> places;
  for (const Vec2& p : mesh.place) places.emplace_back(moved(p.x()), moved(p.y()));
  const auto front = [&](Index v) { return mesh.z[v] + mesh.thickness[v]; };
  const auto back = [&](Index v) { return mesh.z[v] - mesh.thickness[v]; };
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
    if (!std::isfinite(mesh.room[t].least())) continue;
    const double slope = std::max(slope_of(mesh, t, front), slope_of(mesh, t, back));
    if (mesh.room[t].least() < 0 || along + slope_spread * slope * aside >= mesh.gap / 2) return false;
  }
  return true;
}

double least_gap(const InflatedSheets& sheets) {
  double least = std::numeric_limits<double>::infinity();
  for (const StackedPair& pair : sheets.pairs) {
    if (pair.attached()) continue;
    const double back = sheets.z[pair.upper] - sheets.thickness[pair.upper];
    least = std::min(least, back - (sheets.z[pair.lower] + sheets.thickness[pair.lower]));
  }
  return least;
}

std::vector<std::string> certify_topology(std::span<const CertificateInput> meshes, Progress& progress) {
  std::vector<std::string> faults;
  for (const CertificateInput& input : meshes) {
    faults.push_back(topology_fault(inspect(*input.mesh, false, progress), input.euler_region));
  }
  return faults;
}

std::vector<std::array<MeshFace, 2>> meeting_faces(std::span<const CertificateInput> meshes, Rounding rounding,
                                                   double unit, Progress& progress) {
  const RoundedMeshes rounded(meshes, rounding, unit);
  return rounded.pairs(find_self_intersections(rounded.all, progress));
}

std::vector<std::array<MeshFace, 2>> meeting_faces_of(std::span<const CertificateInput> meshes, std::size_t mesh,
                                                      std::span<const Index> faces, Rounding rounding, double unit,
                                                      Progress& progress) {
  const RoundedMeshes rounded(meshes, rounding, unit);
  Index first = 0;
  for (std::size_t m = 0; m < mesh; ++m) first += static_cast<Index>(meshes[m].mesh->face_count());
  std::vector<Index> chosen(faces.begin(), faces.end());
  for (Index& face : chosen) face += first;
  return rounded.pairs(find_intersections_of(rounded.all, chosen, progress));
}

void certify_apart(std::span<const CertificateInput> meshes, Rounding rounding, double unit,
                   std::vector<std::string>& faults, Progress& progress) {
  for (const auto& pair : meeting_faces(meshes, rounding, unit, progress)) {
    for (const MeshFace& place : pair) {
      if (faults[place.mesh].empty()) faults[place.mesh] = "intersects itself or another one";
    }
  }
}

}  // namespace croquis::silhouette
