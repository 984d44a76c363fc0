// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "croquis/base/progress.h"
#include "croquis/geometry/poly_mesh.h"

namespace croquis::hole_filling {

/// Stands for the opposite corner of an edge that more than two triangles share.
inline constexpr Index nonmanifold_edge = no_index - 1;

/// A mesh as hole filling sees it: welded, triangulated, turned to agree, with neighbours. The mesh itself isn't
/// changed; everything here refers back to it.
///
/// Corner 3t + i is corner i of triangle t and stands for the edge from there to the triangle's next corner.
struct SurfaceView {
  enum Flag : std::uint8_t {
    Turned = 1,  ///< runs against its face as written
    NoArea = 2,  ///< area below 1e-14 of the squared diagonal: no use for the surface
    Sliver = 4   ///< longest edge above 1e6 times its height: its normal is noise
  };

  std::vector<std::array<Index, 3>> triangles;  ///< #T by 3, vertices of the mesh by their representatives
  std::vector<Index> face;                      ///< #T, the face of the mesh that it is part of
  std::vector<Index> opposite;      ///< #3T, the corner across the edge, no_index on a rim, or nonmanifold_edge
  std::vector<Index> component;     ///< #T, numbered by the lowest triangle; joined across any edge
  std::vector<std::uint8_t> flags;  ///< #T, of Flag
  std::vector<Index>
      representative;              ///< #V, the lowest used vertex that counts as the same; empty when nothing is welded
  std::vector<Index> rim_corners;  ///< those of edges with one triangle, ascending

  double diagonal = 0;  ///< of the box of all used vertices
  std::size_t component_count = 0;
  std::size_t welded_vertices = 0;         ///< used vertices that another one at exactly their place represents
  std::size_t nearly_welded_vertices = 0;  ///< of rims, that another one near them represents
  double widest_weld = 0;                  ///< the greatest distance to such a one, model units
  std::size_t dropped_triangles = 0;       ///< with two corners at one place: not in `triangles`
  std::size_t nonmanifold_edges = 0;       ///< edges of more than two triangles
  std::size_t turned_faces = 0;            ///< faces of a minority that disagrees with its neighbours
  std::size_t one_sided_components = 0;    ///< that can't be turned to agree (a Moebius band)
  std::size_t unsound_triangles = 0;       ///< with NoArea or Sliver

  static Index next(Index corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
  static Index previous(Index corner) { return corner % 3 == 0 ? corner + 2 : corner - 1; }
  Index origin(Index corner) const { return triangles[corner / 3][corner % 3]; }
  Index target(Index corner) const { return origin(next(corner)); }
  Index representative_of(Index vertex) const { return representative.empty() ? vertex : representative[vertex]; }

  /// Of a triangle, as long as twice its area.
  /// @param positions of the mesh
  Vec3 normal(Index triangle, std::span<const Vec3> positions) const {
    const auto& [a, b, c] = triangles[triangle];
    return (positions[b] - positions[a]).cross(positions[c] - positions[a]);
  }

  /// True when the corner's edge lies between exactly two triangles.
  bool has_opposite(Index corner) const { return opposite[corner] < nonmanifold_edge; }

  /// The other edge of the corner's triangle that ends at `vertex`, which is an end of the corner's edge.
  Index other_edge_at(Index corner, Index vertex) const {
    return origin(corner) == vertex ? previous(corner) : next(corner);
  }
};

/// How near vertices of rims must be to count as one, × the diagonal: what single precision leaves of a seam.
inline constexpr double usual_weld_tolerance = 1e-6;

/// Makes the view: vertices at exactly equal places count as one, and those of rims that are within the tolerance of
/// each other and nearer than half the edges beside them, so that seams that differ by rounding are none; polygons as
/// their cut (see polygon_cut), and of each part that edges of two triangles join the minority that runs the other
/// way is turned.
///
/// Edges are matched by sorting (low end, high end, corner), the low end by lists or by counting: n log n in the worst
/// case, linear for bounded valences; at most about 75 bytes per triangle at the peak, 35 after.
/// @throws Error (E_INDEX, E_NOT_FINITE, E_NO_FACES, E_DEGENERATE) with all findings
/// @throws Cancelled
/// @param weld_tolerance × the diagonal; 0: only what is at exactly one place
SurfaceView view_surface(const PolyMesh& mesh, Progress& progress, double weld_tolerance = usual_weld_tolerance);

/// A mesh with one vertex where several count as one, so that whatever is counted of it agrees with the view.
struct JoinedMesh {
  PolyMesh mesh;            ///< all positions, and the faces that keep three corners; no channels, no tags
  std::vector<Index> face;  ///< of each of its faces the one of the mesh given, ascending
};

/// Linear.
JoinedMesh joined(const PolyMesh& mesh, const SurfaceView& view);

/// Edges of two triangles that the mesh itself has apart, since vertices that count as one are several: seams, as those
/// of textures. Linear.
std::size_t count_seam_edges(const PolyMesh& mesh, const SurfaceView& view);

/// The vertex of the mesh that a corner of the view stands for.
Index mesh_vertex(const SurfaceView& view, const PolyMesh& mesh, Index corner);

}  // namespace croquis::hole_filling
