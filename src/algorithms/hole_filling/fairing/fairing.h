// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/SparseCholesky>

#include "algorithms/hole_filling/triangulation/triangulations.h"
#include "croquis/base/progress.h"
#include "croquis/geometry/poly_mesh.h"
#include "croquis/hole_filling/hole_patch.h"

/// What patches are improved with: cut, brought to size, evened out, faired and displaced.
namespace croquis::hole_filling {

/// A patch by itself, while it is made: its points have numbers of their own.
struct LoosePatch {
  std::vector<Vec3> points;     ///< first those that stay: of the rims, and of the faces around where these count
  std::vector<double> sizes;    ///< #points, the edge length wanted there, > 0; needed by bring_to_size and relax alone
  Triangles triangles;          ///< #T by 3, oriented like the faces around
  std::size_t known = 0;        ///< how many points stay
  Triangles surroundings = {};  ///< a ring of faces around the hole
};

/// The triangles of the points' Delaunay tetrahedra, of their plane's when they lie in one, none when in a line. Of
/// points at the same place one counts.
/// @return corners ascending, in an order that may be another one every time
Triangles cgal_delaunay_triangles(std::span<const Vec3> points);

/// Refines the patch (Liepa 2003, section 3) and moves its new points where the surface bends least, with tangents
/// that agree at the rim (continuity 1; Botsch et al., Polygon Mesh Processing, section 4.3, cotangent weights).
/// @param density CGAL's density control; larger is denser, sqrt(2) gives the rim's own density
/// @return false when the surroundings aren't manifold, the system is singular, a coordinate isn't finite, or CGAL
///         throws: nothing is changed
/// @throws Cancelled between the steps
bool cgal_refine_and_fair(LoosePatch& patch, double density, const Progress& progress);

/// Cuts the triangles of a patch without new points, and flips them, until their edges are `coarseness` times as long
/// as those of its rim; farther inside lengths are interpolated between those of the rim. Nothing is faired:
/// new points lie in the triangles given.
/// @return false when triangles share edges as no surface does
bool refine_evenly(LoosePatch& patch, double coarseness);

/// Moves the new points of a refined patch where it bends least together with the faces around it: the least sum of
/// squared distances from each point to the mean of its neighbours (the umbrella operator of Kobbelt et al. 1998),
/// over new points and those of the rim. Without cotangents and areas it follows uneven triangles a little, and takes
/// a fraction of the time: a place to begin from.
/// @return false when the system is singular: nothing is moved
bool fair_evenly(LoosePatch& patch);

/// Moves a patch's new vertices so that the vertex nearest to each place comes to lie there and the others follow
/// softly: the displacement bends least in the same sense, and neither moves nor tilts at the rims. Near-linear in the
/// patch.
/// @return false when the patch has too few new vertices
bool displace_through(const PolyMesh& mesh, HolePatch& patch, std::span<const Vec3> places);

/// Continues values from a patch's rims to its new vertices so that each is the mean of its neighbours'.
class HarmonicValues {
 public:
  /// Factorises the system once for all values.
  /// @param vertices_given #V, see HolePatch
  HarmonicValues(const HolePatch& patch, Index vertices_given);

  /// The vertices of the mesh that the patch uses, ascending.
  std::span<const Index> rim_vertices() const { return rim_; }

  /// Where all known values are equal, nothing is rounded.
  /// @param known a row per rim vertex @return a row per new vertex
  Eigen::MatrixXd continued(const Eigen::MatrixXd& known) const;

 private:
  std::vector<Index> rim_;
  Eigen::SparseMatrix<double> to_rim_;  ///< which rim vertices are neighbours: new vertices × rim vertices

  /// Rows of new vertices: the number of neighbours times the vertex, less the neighbours.
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
};

/// The triangles' vertices, ascending.
std::vector<Index> vertices_of(std::span<const Triangle> triangles);

/// Per place another of the points, the nearest that is left; there are as many points at least. Linear for each.
std::vector<std::size_t> nearest_points(std::span<const Vec3> points, std::span<const Vec3> places);

/// Mean length of the edges at each point, 0 where there is none.
/// @param edges pairs of points
std::vector<double> mean_lengths(std::span<const Vec3> points, std::span<const std::array<Index, 2>> edges);

/// Brings edges to the lengths wanted, once: those above 4/3 are split at their middle, those below 4/5 collapse unless
/// that would make one above 4/3 or turn a triangle over, then edges are flipped to the Delaunay side where the two
/// triangles look the same way. Edges of rims stay, and no further edge between two rim points is made.
/// (Botsch and Kobbelt 2004, section 4, without its last two steps.)
/// @return false when the triangles aren't manifold: nothing is changed
bool bring_to_size(LoosePatch& patch);

/// Every vertex moves to the mean of the centroids of its triangles, all at the same time. They are weighted by their
/// areas (Yoo 2005, eq. 9) over the lengths that edges are to have there. Where one length is wanted everywhere that
/// changes nothing; by areas alone, vertices near short edges of a rim move to the larger triangles behind them
/// and leave slender ones at the rim, and by areas over squared lengths, which count triangles, they crowd there and
/// fold.
/// @param fixed #points, 1 where a vertex stays, as those of rims must
void relax(LoosePatch& patch, std::span<const std::uint8_t> fixed);

}  // namespace croquis::hole_filling
