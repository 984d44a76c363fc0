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

/// A mesh that should be a closed solid, and the Euler number of the region that it doubles, if it doubles one.
struct CertificateInput {
  const PolyMesh* mesh = nullptr;
  std::optional<int> euler_region;
};

/// For each mesh what is wrong with it, empty for nothing: closed, manifold, oriented outwards, without degenerate
/// faces, Euler number twice its region's. Any mesh may be given, also one that was smoothed or remeshed.
std::vector<std::string> certify_topology(std::span<const CertificateInput> meshes, Progress& progress);

/// A face of one of several meshes.
struct MeshFace {
  std::size_t mesh = 0;
  Index face = 0;
};

/// Pairs of faces that meet after rounding, within one mesh or of two; the first of them where they are many.
std::vector<std::array<MeshFace, 2>> meeting_faces(std::span<const CertificateInput> meshes, Rounding rounding,
                                                   double unit, Progress& progress);

/// The same, but only of pairs with at least one of these faces of one of the meshes.
/// @param faces ascending
std::vector<std::array<MeshFace, 2>> meeting_faces_of(std::span<const CertificateInput> meshes, std::size_t mesh,
                                                      std::span<const Index> faces, Rounding rounding, double unit,
                                                      Progress& progress);

/// Adds to `faults` the meshes that intersect themselves or each other after rounding.
void certify_apart(std::span<const CertificateInput> meshes, Rounding rounding, double unit,
                   std::vector<std::string>& faults, Progress& progress);

}  // namespace croquis::silhouette
