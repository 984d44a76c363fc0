// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "algorithms/perspective/camera/camera_fit.h"

namespace croquis {

/// Vanishing points leave the signs of the axes open. Chosen so that at that place of the picture z goes up and x to
/// the right, where they are seen from the side; else z comes towards the eye and x goes away from it. y makes the
/// world right-handed.
/// @param place u
/// @param turn_round the other of the two worlds with z up
Eigen::Matrix3d signed_axes(const CameraParameters& camera, const Vec2& place, bool turn_round);

}  // namespace croquis
