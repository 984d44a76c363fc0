// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "croquis/tools/pointer/view_frame.h"

/// Where a stroke lies in space that is drawn in a view.
namespace croquis {

/// A plane in space to draw on.
struct SpacePlane {
  Vec3 point = Vec3::Zero();
  Vec3 normal = Vec3::UnitY();  ///< of any length above 0

  friend bool operator==(const SpacePlane&, const SpacePlane&) = default;
};

/// The place of the plane that is shown at a pixel; none where the plane is seen from its edge (below 3 degrees) or the
/// place lies behind the eye.
std::optional<Vec3> place_on(const SpacePlane& plane, const ViewFrame& frame, const Vec2& pixel);

/// Through a place, across the view.
SpacePlane view_plane(const ViewFrame& frame, const Vec3& place);

/// Through two places, and as much across the view as such a plane can be; of places that are one, the view's plane.
SpacePlane plane_through(const ViewFrame& frame, const Vec3& a, const Vec3& b);

/// For a stroke that begins on nothing: the ground where it is seen at 15 degrees or more, else the view's plane
/// through the place of the ground that is nearest to its point.
SpacePlane ground_or_view(const ViewFrame& frame, const SpacePlane& ground);

}  // namespace croquis
