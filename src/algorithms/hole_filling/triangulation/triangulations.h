// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "croquis/base/progress.h"
#include "croquis/geometry/vector.h"
#include "croquis/hole_filling/rim_triangulation.h"

/// What triangulate_rim is made of, and the triangulations that methods begin with.
namespace croquis::hole_filling {

using Triangle = std::array<Index, 3>;
using Triangles = std::vector<Triangle>;

/// What edges weigh beside the area: decides where areas are equal, as on flat rims, and only there. More would fold
/// flat patches over where that shortens edges; less would be lost in the rounding of areas.
inline constexpr double edge_weight = 1e-10;

/// Twice the area over the squared longest edge: flatter triangles count as impossible.
inline constexpr double least_flatness = 1e-9;

/// Twice the area of a triangle plus a trace of its squared edges; infinite for one without area.
inline double triangle_cost(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const double twice_area = ab.cross(ac).norm();
  const double squares[3] = {ab.squaredNorm(), ac.squaredNorm(), (ac - ab).squaredNorm()};
  if (!(twice_area > least_flatness * std::max({squares[0], squares[1], squares[2]})))
    return std::numeric_limits<double>::infinity();
  return twice_area + edge_weight * (squares[0] + squares[1] + squares[2]);
}

inline double triangle_area(const Vec3& a, const Vec3& b, const Vec3& c) { return (b - a).cross(c - a).norm() / 2; }

/// The cheapest triangulation of one closed polygon by `triangle_cost`, again and again while more triangles are
/// avoided: weights W(i,k) = min over j of W(i,j) + W(j,k) + cost(i,j,k), Barequet and Sharir 1995, section 3. n^3 / 6
/// costs at first, later only what the triangles avoided change.
class MinimalTriangulations {
 public:
  /// @param rims kept as a reference: `avoided` may grow between searches, nothing else may change
  /// @param order the polygon as points of `rims`; a point may come twice, where loops are bridged
  MinimalTriangulations(const RimPolygon& rims, std::vector<Index> order);

  /// @return triangles of points, or nothing when every triangulation has a triangle without area, one that is to be
  ///         avoided or a blocked edge
  std::optional<Triangles> next(Progress& progress);

 private:
  std::size_t at(std::size_t i, std::size_t k) const { return i * size_ + k; }
  bool may_join(std::size_t i, std::size_t k) const;
  bool is_avoided(std::size_t i, std::size_t j, std::size_t k) const;
  bool may_have_changed(std::size_t i, std::size_t k) const;
  void measure_triangles(std::size_t i, std::size_t k);
  void choose_apex(std::size_t i, std::size_t k);

  const RimPolygon& rims_;
  std::vector<Index> order_;
  std::size_t size_;
  std::array<std::vector<double>, 3> points_;  ///< of the polygon, per axis
  std::vector<double> between_;  ///< costs of the triangles on the chord under way, per point between its ends
  std::vector<double> squares_, flat_;
  std::vector<double> cost_;         ///< of the part from i to k, at (i, k) and (k, i): both are read row by row
  std::vector<std::uint32_t> apex_;  ///< the third corner of the triangle on (i, k)
  std::vector<char> has_grown_;      ///< whether the cost is higher than in the search before
  bool is_first_ = true;
};

/// One closed polygon of all loops: each further loop is entered and left over the shortest bridge to what is joined
/// already, or where they share a vertex. Quadratic in the points.
std::vector<Index> bridged_order(const RimPolygon& rims);

/// The triangulation of one closed polygon that folds least: the sum over edges of 1 - cos of the angle between their
/// triangles, the polygon's sides included, then that of `triangle_cost`. (Liepa 2003, section 2, takes the largest
/// angle alone. Where a ragged rim has one that can't be helped, everything below it is free then, and the patch may
/// fold.) It is chosen among `candidates`, among all triangles too on sides of the polygon that no candidate has, and
/// for short polygons among all triangles when that gives nothing. The choice depends on the numbers alone, not on the
/// order of the candidates.
/// @param polygon of one loop; `avoided` is not looked at
/// @param beyond #P, unit normals of the faces on the other side of the polygon's sides, each from a point to the next;
///        empty where there are none
/// @param candidates corners ascending
/// @return nothing when every triangulation has a triangle without area or a blocked edge
/// @throws Cancelled
std::optional<Triangles> dihedral_triangulation(const RimPolygon& polygon, std::span<const Vec3> beyond,
                                                Triangles candidates, Progress& progress);

/// What a band has least of.
enum class BandCost {
  Area,   ///< for bands that are to be curved: the start of a smooth one
  Length  ///< squared lengths of the edges between both sides: never twisted where that can be avoided
};

/// A band of triangles between two rims, each with an edge on one of them and the third corner on the other, no new
/// vertices. Of all bands with the shortest edge between the rims the one of least cost, by dynamic programming (time
/// and memory n m); for rims with n m above 4 million by going on with the shorter edge each time (linear).
/// @param rims two loops @return triangles of its points, or nothing when all have blocked edges or no area
/// @throws Cancelled
std::optional<Triangles> band_triangulation(const RimPolygon& rims, BandCost cost, Progress& progress);

/// A plane with right-handed axes: u × v = normal, all unit.
struct RimPlane {
  Vec3 centre, u, v, normal;

  Vec2 project(const Vec3& point) const { return {u.dot(point - centre), v.dot(point - centre)}; }
};

/// The plane nearest to the edges of a closed polygon in the sense of squared distances weighted by length, around
/// whose normal it runs counter-clockwise.
RimPlane plane_of_rim(std::span<const Vec3> polygon);

/// The constrained Delaunay triangulation of the rims in the plane nearest to the first, inside the first and outside
/// the others; nothing when rims meet in that plane or don't run around one another as they should.
std::optional<Triangles> plane_triangulation(const RimPolygon& rims);

}  // namespace croquis::hole_filling
