// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "algorithms/silhouette/surface/inflation.h"
#include "algorithms/silhouette/surface/sheet_mesh.h"
#include "croquis/base/progress.h"
#include "croquis/geometry/poly_mesh.h"

namespace croquis::silhouette {

/// How a file may round the coordinates that it stores.
enum class Rounding {
  None,    ///< doubles, written so that they read back exactly
  Single,  ///< 32-bit floats: STL, glTF, most PLY
  Grid     ///< whole multiples of 0.01 u: text with few digits
};

double rounded(double value, Rounding rounding, double unit);

/// Exact proof that the doubled sheets don't meet, on the rounded numbers: every planar triangle keeps its sense (so
/// that the triangulation stays one), every front stays before its back inside, every back before the next front.
/// Attached objects are left out: what comes of them is another surface.
/// Sufficient, not necessary: a rounding that turns an empty sliver of the convex hull over fails it. O(M).
bool sheets_in_order(const InflatedSheets& sheets, Rounding rounding, double unit);

/// The same of sheets with triangles of their own, when the sheets that they were made of are in order: all of their
/// triangles keep their sense, every front stays before its back, and rounding moves none by half of the gap.
bool mesh_in_order(const SheetMesh& mesh, Rounding rounding, double unit);

/// Least distance along z of successive sheets that aren't attached, taken at all points of the common triangulation
/// and so over all of it; infinity when none overlap.
double least_gap(const InflatedSheets& sheets);

/// What is wrong with a mesh, empty for nothing: closed, manifold, oriented outwards, without degenerate faces, Euler
/// number twice that of the region that it doubles, if it doubles one. Any mesh may be given, also one that was
/// smoothed or remeshed.
std::string topology_fault(const PolyMesh& mesh, const std::optional<int>& euler_region, Progress& progress);

/// A face of one of several meshes.
struct MeshFace {
  std::size_t mesh = 0;
  Index face = 0;
};

/// Some faces of one of several meshes, ascending.
struct MeshFaces {
  std::size_t mesh = 0;
  std::span<const Index> faces;
};

/// Pairs of faces that meet after rounding, within one mesh or of two; the first of them where they are many.
/// @param among where given only pairs with at least one of these
std::vector<std::array<MeshFace, 2>> meeting_faces(std::span<const PolyMesh* const> meshes, Rounding rounding,
                                                   double unit, Progress& progress,
                                                   const std::optional<MeshFaces>& among = std::nullopt);

}  // namespace croquis::silhouette
