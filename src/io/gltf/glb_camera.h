// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/geometry/camera.h"
#include "croquis/geometry/vector.h"

namespace tinygltf {
class Model;
}

namespace croquis {

/// Adds a perspective camera and its node, which looks along -z with y up (glTF 2.0, sections 3.10 and 5.12).
///
/// A glTF camera has its principal point in the middle of what it sees. It gets the smallest such picture that holds
/// the sheet: `extras` of the camera has `image` [width, height], `origin` [x, y] and `principal_point` [u, v] of the
/// sheet (px, y down) and `focal_length` (px), and `frame` [x, y, width, height], the part of the sheet's plane that
/// the camera sees (px).
/// @param positions that are to lie between the near and the far plane
/// @return the node
int add_camera_node(const Camera& camera, const std::vector<Vec3>& positions, tinygltf::Model& model);

}  // namespace croquis
