// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "croquis/base/progress.h"
#include "croquis/hole_filling/hole_analysis.h"

/// The steps of view_surface and analyse_holes.
namespace croquis::hole_filling {

struct Welding {
  std::vector<Index> representative;  ///< #V, or empty when no two used vertices are at one place
  std::size_t welded = 0;
  double widest_gap = 0;  ///< the greatest distance between two vertices that became one, model units
};

/// For each vertex that a face uses the lowest such vertex with exactly equal coordinates; others stay themselves.
/// Expected linear: an open-addressed table of indices, whose order never shows.
Welding weld_identical(const PolyMesh& mesh, Progress& progress);

/// The same for vertices of rims that are nearly at one place, as where two exports of one seam differ by rounding:
/// those within `tolerance` of each other and nearer than half the rim edges beside them, the nearest pairs first. Two
/// ends of an edge never become one. Vertices that were one in the view stay so; empty when no more become one.
/// Costs n log n in the rims' vertices and their pairs.
/// @param tolerance model units, 0 for none
Welding weld_rims(const PolyMesh& mesh, const SurfaceView& view, double tolerance, Progress& progress);

struct EdgePairing {
  std::vector<Index> opposite;  ///< #3T, as in SurfaceView
  std::size_t nonmanifold_edges = 0;
  std::vector<std::array<Index, 2>> nonmanifold_corners;  ///< of each non-manifold edge: (first corner, a further one)
};

/// Finds the triangles on both sides of every edge by sorting the edges' keys (low end, high end, corner): by lists of
/// the low ends, then by comparison within each vertex. Takes 4 bytes per vertex beside the result.
/// @param triangles #T by 3, vertices below vertex_count, three different ones each
EdgePairing pair_edges(std::span<const std::array<Index, 3>> triangles, std::size_t vertex_count, Progress& progress);

/// Walks all rims of the analysis' view and counts those that don't close. The holes have corners and vertices of the
/// view in walking order, no vertex twice, and are ambiguous where edges are walked against their triangles. Where one
/// fan of triangles ends at a vertex, the walk turns around it within the fan. Where several fans meet in a vertex and
/// lie around it like petals, it goes on with the fan across the gap, so that gaps between them are holes of their own;
/// else it stays in its fan too. Every walk is cut wherever a vertex comes again. n log n in the rim edges, linear in
/// their fans.
void walk_rims(const PolyMesh& mesh, HoleAnalysis& analysis, Progress& progress);

/// Fills all other measures of a hole from its vertices and corners.
void measure_hole(const PolyMesh& mesh, const SurfaceView& view, const HoleAnalysisOptions& options, Hole& hole,
                  Progress& progress);

/// Area, diagonal and size of every component, and the component of every hole. Linear.
void measure_components(const PolyMesh& mesh, HoleAnalysis& analysis);

/// The greatest distance of two of the points, exact; 0 for fewer than two.
///
/// Of runs of points only those are compared whose boxes could hold a longer one than is known: rims run along, so that
/// boxes are small, and few are compared, on circles too.
double greatest_distance(std::span<const Vec3> points);

/// Sets kind and companions of every hole from their measures. L log L plus the pairs of holes near each other.
void classify_holes(const PolyMesh& mesh, const HoleAnalysisOptions& options, HoleAnalysis& analysis);

/// Beyond this angle between their faces two rims belong to different sides of something thin (radians; 100 degrees).
inline constexpr double greatest_group_angle = 1.7453292519943295;

/// Whether one sheet could hold both rims: their mean normals don't turn away from each other.
bool are_compatible(const Hole& a, const Hole& b);

/// Pairs (low, high), sorted, of holes whose boxes meet once each has grown by half its diameter in all directions.
/// L log L plus the pairs.
std::vector<std::array<Index, 2>> near_pairs(const PolyMesh& mesh, std::span<const Hole> holes);

}  // namespace croquis::hole_filling
