// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "croquis/geometry/vector.h"
#include "croquis/hole_filling/hole_site.h"
#include "croquis/implicit/local_fit.h"

/// Creases of the surface around a hole, and the smooth sides between them, which go on in it.
namespace croquis::hole_filling {

/// The cosine of the angle between triangles from which on an edge around the site is a crease: four times the angle
/// that four of five edges there don't exceed, so that bevels of fine models are creases and the noise of rough ones is
/// none; 12 degrees at least and 35 at most. Linear in the rims, the first time for a site with a memory.
double crease_cosine(const HoleSite& site);

/// Whether an edge between triangles of these normals, of any length, is no crease.
bool is_smooth(const Vec3& normal, const Vec3& other, double crease_cosine);

/// The surface around a site's rims, by itself: what methods may be tried on.
struct KnownSurface {
  PolyMesh mesh;                 ///< triangles; vertices by their distance to the rims, those of the rims first
  std::vector<double> distance;  ///< per vertex, along edges to the rims
  double edge = 0;               ///< mean length of the rims' edges
  double size = 0;               ///< diameter of the largest rim
  double crease_cosine = 1;      ///< of the site, see there
};

/// Triangles all of whose vertices edges join to the rims within max(`reach` × size, `least_reach` × edge), and of
/// these the `most_vertices` nearest. n log n in what is reached.
KnownSurface known_surface(const HoleSite& site, double reach, double least_reach, std::size_t most_vertices);

/// The same of what has been reached already: vertex i is reached[i].
KnownSurface known_surface(const HoleSite& site, const std::vector<ReachedVertex>& reached);

/// A part of the surface around a hole that is bounded by creases.
struct SmoothSide {
  std::vector<Index> vertices;  ///< of the known surface, ascending: nearest to the rims first
  std::vector<Vec3> normals;    ///< unit, of this side's triangles alone
};

/// The parts that have an edge on a rim and four triangles at least. A crease that ends somewhere separates nothing.
/// n log n.
std::vector<SmoothSide> smooth_sides(const KnownSurface& known);

/// Smooth sides that meet at creases, as one function: each side has a fit of its own, and of these the greatest (where
/// the crease is convex) or the least (where it is concave) counts, as a tree decides.
class CreaseField {
 public:
  /// A node of the tree: a side, or the greater or lesser of two nodes before it.
  struct Node {
    int side = -1;  ///< or -1
    bool is_greater = false;
    std::size_t first = 0, second = 0;
  };

  struct Value {
    double value = 0;
    std::size_t side = 0;  ///< which of them it comes from
  };

  CreaseField(std::vector<std::shared_ptr<const implicit::LocalFit>> fits, std::vector<Node> tree)
      : fits_(std::move(fits)), tree_(std::move(tree)) {}

  std::size_t side_count() const { return fits_.size(); }
  const implicit::LocalFit& fit(std::size_t side) const { return *fits_[side]; }
  Value value(const Vec3& point) const;

  /// This as a field; it shares what it needs.
  implicit::Field field() const;

 private:
  std::vector<std::shared_ptr<const implicit::LocalFit>> fits_;
  std::vector<Node> tree_;  ///< the last one counts
};

/// Whether creases (see crease_cosine) end at the rims: twice at least, since each that runs in runs out again or meets
/// others. Linear in the faces around the rims, and far cheaper than `fit_sides`.
bool creases_run_in(const HoleSite& site);

/// The mean distance of the known points to the continued sides, × mean rim edge, beyond which no sides are seen: where
/// creases are asked for, and where they aren't, since what runs into holes of rough or crumpled surfaces is hardly an
/// edge of the thing.
inline constexpr double usual_side_residual = 0.2, trusted_side_residual = 0.03;

/// Splits the surface around a site at its creases (see crease_cosine), continues each side that reaches the rims (Yoo
/// 2005, eq. 1-6), and finds the tree under which all known points come to lie nearest to the surface: so creases that
/// run into the hole go on in it.
/// @param most_residual see usual_side_residual
/// @return nothing when there are fewer than two sides or more than five, or no tree fits
std::optional<CreaseField> fit_sides(const HoleSite& site, double most_residual);

}  // namespace croquis::hole_filling
