// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "algorithms/attribute_surface/bridges/patch_triangles.h"
#include "croquis/attribute_surface/face_surface.h"
#include "croquis/attribute_surface/rim_patch.h"

namespace croquis {

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
