// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "croquis/geometry/camera.h"

/// Cameras as JSON, and those that fSpy found (https://fspy.io).
namespace croquis {

struct CameraFile {
  Camera camera;
  int mode = 0;  ///< how many vanishing points are finite, 1..3; 0 for not said
};

/// {"mode", "focal_length": px, "principal_point": [u, v], "eye": [x, y, z], "rotation": [[right], [down], [forward]],
///  "image": [width, height], "origin": [x, y] where it isn't 0}, and the members of fSpy's own export beside them:
/// principalPoint, viewTransform, cameraTransform, horizontalFieldOfView, verticalFieldOfView, vanishingPoints (null at
/// infinity), vanishingPointAxes, relativeFocalLength, imageWidth, imageHeight. fSpy's picture has its origin in the
/// middle, y up, and half of its longer side is 1; its camera looks along -z with y up. As in fSpy both fields of view
/// are those of a picture that is not higher than wide.
std::string write_camera_json(const CameraFile& file);

/// Reads what write_camera_json writes, fSpy's JSON export, and fSpy's projects (.fspy, version 1; the picture in them
/// is passed over). Rotations are made orthonormal.
/// @throws Error Malformed: E_EMPTY, E_SYNTAX, E_TRUNCATED, each with the place; E_VERSION for projects of another
/// version
CameraFile read_camera_file(std::string_view bytes, const std::string& file_name);

}  // namespace croquis
