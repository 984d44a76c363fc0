// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "croquis/attribute_surface/domain_polygon.h"
#include "croquis/attribute_surface/face_surface.h"
#include "croquis/attribute_surface/rim_patch.h"
#include "croquis/geometry/vector.h"

namespace croquis {

/// Where a closed row of points is cut into sides.
struct RimCuts {
  std::vector<std::size_t> at;  ///< ascending
  std::vector<bool> is_corner;  ///< one for each: whether the row turns sharply there
};

/// @param corner radians: turns by more, beyond those of a circle of as many points, are corners
/// @param sides  3..12, or 0 for as many as the corners ask for; never more than there are points
RimCuts cut_rim(std::span<const Vec3> loop, double corner, std::size_t sides);

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

/// A closed row of vertices as the outline of one face, counter-clockwise seen from where the normals point to.
struct RimLoop {
  std::vector<Vec3> points;   ///< at least 3, neighbours different
  std::vector<Vec3> normals;  ///< unit, one for each
};

/// The surface within a rim.
class RimFace {
 public:
  RimFace(const RimLoop& loop, const RimPatchOptions& options);

  const FaceSurface& surface() const { return *surface_; }

  /// The loop's points on the outline of the domain, in the loop's order from first_point() on.
  const std::vector<OutlinePlace>& outline() const { return outline_; }
  std::size_t first_point() const { return first_point_; }

  /// Greatest distance of the loop's points from the curves.
  double curve_distance() const { return curve_distance_; }

  /// Edges of triangles inside that are about as long as the rim's, in the domain's units.
  double spacing() const;

  /// The surface, moved near the outline to where the rim is.
  Vec3 at(const Vec2& place) const;

 private:
  SurfaceSide make_side(const RimLoop& loop, std::size_t from, std::size_t edges, const RimPatchOptions& options);
  Vec3 miss_at(const Vec2& place) const;

  std::optional<FaceSurface> surface_;
  RimLoop even_;  ///< the loop without its teeth
  std::size_t sides_ = 0;
  std::vector<OutlinePlace> outline_;
  std::vector<Vec3> misses_;     ///< one for each of these: what is left from the curve to the loop's point
  std::vector<bool> is_corner_;  ///< of the loop's points
  std::size_t first_point_ = 0;
  double curve_distance_ = 0;
  double miss_reach_ = 0;  ///< of the domain: farther inside the surface is as the curves make it
};

}  // namespace croquis
