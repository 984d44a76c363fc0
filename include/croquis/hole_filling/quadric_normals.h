// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/hole_filling/surface_reach.h"
#include "croquis/implicit/point_tree.h"

namespace croquis::hole_filling {

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
