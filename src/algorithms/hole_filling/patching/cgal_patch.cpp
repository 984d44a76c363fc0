// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/patching/cgal_patch.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <iterator>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/fair.h>
#include <CGAL/Polygon_mesh_processing/refine.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Random.h>
#include <CGAL/Surface_mesh.h>

#include "croquis/base/error.h"

namespace croquis::hole_filling {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
namespace pmp = CGAL::Polygon_mesh_processing;

/// CGAL falls back to a search of cubic time when the Delaunay tetrahedra hold no triangulation: never for more points.
constexpr std::size_t most_cubic_points = 200;

/// Lets CGAL's long searches be cancelled between their steps.
struct CancelVisitor : pmp::Hole_filling::Default_visitor {
  explicit CancelVisitor(const Progress& to_check) : progress(&to_check) {}

  void start_quadratic_phase(std::size_t) const { progress->check(); }
  void quadratic_step() const { progress->check(); }
  void start_cubic_phase(int) const { progress->check(); }
  void cubic_step() const { progress->check(); }

  const Progress* progress;
};

struct IndexTriangle {
  IndexTriangle(int a, int b, int c) : corners{static_cast<Index>(a), static_cast<Index>(b), static_cast<Index>(c)} {}
  Triangle corners;
};

/// A triangulation is turned right when its triangle on the edge from point 0 to point 1 runs that edge forwards.
void turn_along_polygon(std::vector<Triangle>& triangles) {
  for (const Triangle& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (t[i] == 0 && t[(i + 1) % 3] == 1) return;
    }
  }
  for (Triangle& t : triangles) std::swap(t[1], t[2]);
}

/// The order of triangles and of their corners comes from where things lie in memory, too.
void put_in_order(std::vector<Triangle>& triangles) {
  for (Triangle& t : triangles) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  std::sort(triangles.begin(), triangles.end());
}

/// Calls CGAL: what it throws is "nothing", but cancelling passes. Its random numbers, which begin with the time of
/// day, are the same ones every time.
template <typename Call>
auto guarded(Call&& call) -> decltype(call()) {
  CGAL::get_default_random() = CGAL::Random(1);
  try {
    return call();
  } catch (const Cancelled&) {
    throw;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

Point to_point(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

/// Points moved by far less than matters, always alike: of triangulations of exactly equal cost, which symmetric rims
/// have, CGAL would take one by where things lie in memory.
std::vector<Point> without_ties(std::span<const Vec3> polygon, double extent) {
  constexpr double share = 1e-9;  // of the extent: far above rounding
  std::uint32_t state = 1;
  const auto next = [&] {
    state = state * 1664525U + 1013904223U;  // the linear congruence of Numerical Recipes
    return share * extent * (static_cast<double>(state) / 0x1p31 - 1);
  };
  std::vector<Point> points;
  for (const Vec3& point : polygon) {
    const double x = next(), y = next(), z = next();
    points.push_back(to_point(point + Vec3(x, y, z)));
  }
  return points;
}

/// The farthest from the first point.
Vec3 farthest(std::span<const Vec3> polygon) {
  return *std::ranges::max_element(polygon, {}, [&](const Vec3& point) { return (point - polygon[0]).squaredNorm(); });
}

bool is_straight(std::span<const Vec3> polygon) {
  constexpr double thinnest = 1e-7;  // × length²: what moved points of a line may span
  const Vec3 along = farthest(polygon) - polygon[0];
  return std::ranges::all_of(polygon, [&](const Vec3& point) {
    return along.cross(point - polygon[0]).norm() <= thinnest * along.squaredNorm();
  });
}

struct LocalMesh {
  Mesh mesh;
  std::vector<Mesh::Face_index> patch;
  bool is_manifold = true;
};

LocalMesh build(const FairingInput& input) {
  LocalMesh local;
  for (const Vec3& point : input.points) local.mesh.add_vertex(to_point(point));
  const auto add = [&](const Triangle& t) {
    const auto face = local.mesh.add_face(Mesh::Vertex_index(t[0]), Mesh::Vertex_index(t[1]), Mesh::Vertex_index(t[2]));
    local.is_manifold &= face != Mesh::null_face();
    return face;
  };
  for (const Triangle& t : input.surroundings) add(t);
  for (const Triangle& t : input.patch) local.patch.push_back(add(t));
  return local;
}

/// @return nothing when a coordinate isn't finite
std::optional<FairingResult> read_back(const FairingInput& input, const LocalMesh& local) {
  FairingResult result;
  for (std::size_t v = input.points.size(); v < local.mesh.number_of_vertices(); ++v) {
    const Point& point = local.mesh.point(Mesh::Vertex_index(static_cast<Index>(v)));
    result.new_points.emplace_back(point.x(), point.y(), point.z());
    if (!result.new_points.back().allFinite()) return std::nullopt;
  }
  for (const Mesh::Face_index face : local.patch) {
    Triangle t{};
    std::size_t i = 0;
    for (const auto vertex : local.mesh.vertices_around_face(local.mesh.halfedge(face))) t[i++] = vertex.idx();
    result.patch.push_back(t);
  }
  put_in_order(result.patch);
  return result;
}

}  // namespace

std::optional<std::vector<Triangle>> cgal_triangulation(std::span<const Vec3> polygon, Progress& progress) {
  return guarded([&]() -> std::optional<std::vector<Triangle>> {
    if (is_straight(polygon)) return std::nullopt;
    const std::vector<Point> points = without_ties(polygon, (farthest(polygon) - polygon[0]).norm());
    std::vector<IndexTriangle> found;
    pmp::triangulate_hole_polyline(points, std::back_inserter(found),
                                   CGAL::parameters::use_delaunay_triangulation(true)
                                       .do_not_use_cubic_algorithm(points.size() > most_cubic_points)
                                       .visitor(CancelVisitor(progress)));
    if (found.size() + 2 != points.size()) return std::nullopt;
    std::vector<Triangle> triangles;
    for (const IndexTriangle& t : found) triangles.push_back(t.corners);
    turn_along_polygon(triangles);
    put_in_order(triangles);
    return triangles;
  });
}

std::optional<FairingResult> cgal_refine_and_fair(const FairingInput& input, Progress& progress) {
  return guarded([&]() -> std::optional<FairingResult> {
    LocalMesh local = build(input);
    if (!local.is_manifold) return std::nullopt;
    progress.check();
    std::vector<Mesh::Vertex_index> new_vertices;
    std::vector<Mesh::Face_index> new_faces;
    pmp::refine(local.mesh, local.patch, std::back_inserter(new_faces), std::back_inserter(new_vertices),
                CGAL::parameters::density_control_factor(input.density));
    local.patch.insert(local.patch.end(), new_faces.begin(), new_faces.end());
    progress.check();
    if (!new_vertices.empty() &&
        !pmp::fair(local.mesh, new_vertices, CGAL::parameters::fairing_continuity(input.continuity)))
      return std::nullopt;
    return read_back(input, local);
  });
}

}  // namespace croquis::hole_filling
