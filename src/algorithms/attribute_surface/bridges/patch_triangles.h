// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "croquis/attribute_surface/domain_polygon.h"

namespace croquis {

/// A place on the outline of a domain.
struct OutlinePlace {
  Vec2 place = Vec2::Zero();
  std::size_t side = 0;  ///< the place is at its beginning or on it
  double fraction = 0;   ///< 0..1 of the side
};

/// Triangles over a domain: the outline's places first, in their order, then places inside.
struct PatchTriangles {
  std::vector<Vec2> places;
  std::vector<std::array<Index, 3>> triangles;  ///< counter-clockwise; empty where the outline is too narrow
};

/// Fills a domain with triangles of about equal sides.
/// @param outline counter-clockwise, at least 3
/// @param spacing of places inside, > 0, in the domain's units
PatchTriangles fill_domain(const DomainPolygon& domain, std::span<const OutlinePlace> outline, double spacing);

/// Turns inner edges over until the least angle of no pair of triangles grows by it, in space.
/// @param points one for each place, in space
void even_out(std::span<const Vec3> points, std::vector<std::array<Index, 3>>& triangles);

/// Cuts in two those inner edges that may not be there, and the triangles beside them.
/// @param is_taken of two places of the outline that an edge joins
void cut_edges(const std::function<bool(Index, Index)>& is_taken, PatchTriangles& patch);

}  // namespace croquis
