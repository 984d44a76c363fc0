// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "croquis/geometry/vector.h"

/// The linear rows that one skeleton edge gives to the depth problem. The edge from p_i to p_k carries a patch
/// S = a x^2 + b x + c y^2 + d y + e x y + f through the heights and gradients of its ends.
/// Coefficients stand in the order (z_i, gx_i, gy_i, z_k, gx_k, gy_k).
namespace croquis::silhouette {

using EdgeRow = std::array<double, 6>;

/// A patch through both ends exists: [2 (z_k - z_i) - D.(g_i + g_k)] / l = 0, D = p_k - p_i, l = |D|.
///
/// The left null vector of the 6 by 6 interpolation matrix. Cordier, Seo, Cho 2006, section 4.4.2 print it divided by
/// y_i - y_k, which fails on horizontal edges.
/// @param along D, not zero
EdgeRow continuity_row(const Vec2& along);

/// Thin-plate energy of the patch over an area L l, least over the one coefficient that the ends leave free (curl
/// across the edge): the squares of the two rows, for D_f = 2.
/// Cordier, Seo, Cho 2006, section 4.4.3, in closed form:
/// E = L/l [(1 - nu^2) (t.(g_k - g_i))^2 + 2 (1 - nu) (m.(g_k - g_i))^2], t = D/l, m = t turned left.
/// The area L l in place of the paper's l^2 makes the energy independent of the number of nodes.
/// @param along D, not zero
/// @param scale L
/// @param poisson nu, 0..0.5
std::array<EdgeRow, 2> curvature_rows(const Vec2& along, double scale, double poisson = 0.5);

}  // namespace croquis::silhouette
