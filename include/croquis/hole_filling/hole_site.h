// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "croquis/hole_filling/fill_options.h"
#include "croquis/hole_filling/hole_analysis.h"
#include "croquis/hole_filling/rim_triangulation.h"
#include "croquis/implicit/point_tree.h"

namespace croquis::hole_filling {

class SiteMemory;
class SurfaceSearch;

/// Where a patch is to be made, and how: one hole, or several that one patch joins.
struct HoleSite {
  const PolyMesh* mesh = nullptr;
  const HoleAnalysis* analysis = nullptr;
  std::vector<Index> holes;     ///< ascending
  RimPolygon polygon;           ///< rims with the patch on their left, the largest first
  std::vector<Index> vertices;  ///< of the mesh, per point of the polygon
  std::vector<Index> corners;   ///< of the view, per side of the polygon, from a point to the next
  PatchSettings settings;       ///< adapted to the preset, see adapted
  Preset preset = Preset::Auto;
  std::size_t most_triangles = 40000;     ///< a patch that would need more is made of larger ones
  bool bridge = false;                    ///< a band between the rims is wanted, rather than one rim's inside
  const SurfaceSearch* search = nullptr;  ///< of the mesh, shared by its sites; null: made where one is needed
  SiteMemory* memory = nullptr;           ///< of what several methods begin with; null: each makes it anew
};

/// @param rim_edges sorted pairs of the view's vertices that edges join already: kept free by the patch
HoleSite make_site(const PolyMesh& mesh, const HoleAnalysis& analysis, std::span<const Index> holes,
                   std::span<const std::array<Index, 2>> rim_edges);

/// The settings for a preset: Noisy smooths more, Paper takes offset points on one side.
PatchSettings adapted(PatchSettings settings, Preset preset);

/// Of all rims together, model units.
double rim_length(const HoleSite& site);

/// Mean length of the rims' edges, model units.
double mean_rim_edge(const HoleSite& site);

/// The hole of the largest diameter, and that.
const Hole& widest_hole(const HoleSite& site);
double widest_diameter(const HoleSite& site);

/// Normal of a triangle of the view, as long as twice its area.
Vec3 triangle_normal(const HoleSite& site, Index triangle);

/// Appends every triangle at the vertex of a corner that edges join to the corner's own, which isn't appended.
void add_fan(const SurfaceView& view, Index corner, std::vector<Index>& triangles);

/// Triangles of the view around the site's rims: those at a rim vertex, and those `rings - 1` vertices further.
/// Ascending. Linear in their number.
std::vector<Index> surroundings(const HoleSite& site, int rings);

/// A vertex of the surface around a hole.
struct ReachedVertex {
  Index vertex = 0;            ///< of the view
  double distance = 0;         ///< along edges to the nearest rim vertex of the site
  Vec3 normal = Vec3::Zero();  ///< unit, weighted by the angles of its sound triangles; 0 where they give none
  Index corner = 0;            ///< of the view, one there
  bool on_crease = false;      ///< a crease (see crease_cosine) starts, ends or passes there
};

/// The vertices that edges join to the site's rims within `reach` (model units): other sheets that merely pass nearby
/// aren't among them. Ordered by distance, then by number. n log n in what is reached.
std::vector<ReachedVertex> reach_from_rims(const HoleSite& site, double reach);

/// A tree of the places reached: point i is that of reached[i].
/// @param reached as reach_from_rims gives it; @param positions of the mesh
implicit::PointTree tree_of(const std::vector<ReachedVertex>& reached, const std::vector<Vec3>& positions);

/// Replaces the normals of rim vertices (distance 0), which see triangles on one side alone and lean by about half an
/// edge times the curvature, by those of a quadric through the vertex, fitted to the 16 nearest reached vertices whose
/// normals look the same way. A normal that would turn by more than 30 degrees stays: the surface isn't smooth there.
/// @param tree of the places reached
void fit_rim_normals(std::vector<ReachedVertex>& reached, const std::vector<Vec3>& positions,
                     const implicit::PointTree& tree);

/// How rough the surface is, × the distance of neighbouring vertices: the median over up to 100 places of the standard
/// deviation of 17 neighbouring vertices from the quadric fitted to them. Of noise along the normals, evenly
/// distributed, it is the standard deviation; smooth surfaces that their triangles resolve have 0.001 to 0.03. 0 where
/// nothing can be measured.
/// @param tree of the places reached
double surface_roughness(const std::vector<ReachedVertex>& reached, const std::vector<Vec3>& positions,
                         const implicit::PointTree& tree);

}  // namespace croquis::hole_filling
