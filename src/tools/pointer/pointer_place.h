// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "croquis/tools/pointer/view_frame.h"

/// Where a pointer is along an axis or in a plane, so that what it holds stays under it in every view, perspective or
/// parallel, wherever the view's near and far planes are. Towards the horizon places end where things would look a
/// hundred times smaller. O(1).
namespace croquis {

/// How far from a place along an axis that is seen lies which is nearest to the pixel on the screen, model units; 0
/// where the axis points straight into the view.
/// @param place in front of the eye. @param axis unit
double pointer_on_axis(const ViewFrame& frame, const Vec2& pixel, const Vec3& place, const Vec3& axis);

/// The place of the plane that is seen at the pixel; nothing when the plane is seen from its edge.
/// @param place of the plane, in front of the eye. @param normal unit
std::optional<Vec3> pointer_on_plane(const ViewFrame& frame, const Vec2& pixel, const Vec3& place, const Vec3& normal);

}  // namespace croquis
