// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "croquis/hole_filling/hole_analysis.h"
#include "croquis/hole_filling/hole_request.h"
#include "croquis/hole_filling/rim_triangulation.h"

namespace croquis::hole_filling {

class SiteMemory;
class SurfaceSearch;

/// Where a patch is to be made: one hole, or several that one patch joins.
struct HoleSite {
  const PolyMesh* mesh = nullptr;
  const HoleAnalysis* analysis = nullptr;
  std::vector<Index> holes;     ///< ascending
  RimPolygon polygon;           ///< rims with the patch on their left, the largest first
  std::vector<Index> vertices;  ///< of the mesh, per point of the polygon
  PatchWish wish;
  const SurfaceSearch* search = nullptr;  ///< of the mesh, shared by its sites; null: made where one is needed
  SiteMemory* memory = nullptr;           ///< of what several methods begin with; null: each makes it anew
  bool bridge = false;                    ///< a band between the rims is wanted, rather than one rim's inside
};

/// @param rim_edges sorted pairs of the view's vertices that edges join already: kept free by the patch
HoleSite make_site(const PolyMesh& mesh, const HoleAnalysis& analysis, std::span<const Index> holes,
                   std::span<const std::array<Index, 2>> rim_edges);

/// Of all rims together, model units.
double rim_length(const HoleSite& site);

/// Mean length of the rims' edges, model units.
double mean_rim_edge(const HoleSite& site);

/// Diameter of the largest rim.
double widest_diameter(const HoleSite& site);

/// The faces on the other side of the polygon's sides, each from a point to the next. #P unit normals, zero for a face
/// without area.
std::vector<Vec3> normals_beyond(const HoleSite& site);

/// Normal of a triangle of the view, as long as twice its area.
Vec3 triangle_normal(const HoleSite& site, Index triangle);

/// Appends every triangle at the vertex of a corner that edges join to the corner's own, which isn't appended.
void add_fan(const SurfaceView& view, Index corner, std::vector<Index>& triangles);

/// Triangles of the view around the site's rims: those at a rim vertex, and those `rings - 1` vertices further.
/// Ascending. Linear in their number.
std::vector<Index> surroundings(const HoleSite& site, int rings);

}  // namespace croquis::hole_filling
