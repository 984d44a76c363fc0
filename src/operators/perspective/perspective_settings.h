// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "croquis/base/parameter_list.h"
#include "croquis/geometry/perspective_drawing.h"
#include "croquis/perspective/network_reconstruction.h"
#include "croquis/perspective/solid.h"

namespace croquis {

/// What people set of `perspective`.
struct PerspectiveSettings {
  NetworkReconstructionOptions network;
  FaceFindingOptions faces;
  SolidOptions solid;
  double smooth_angle = 15 * std::numbers::pi / 180;  ///< radians; of strokes and of faces
  bool fix = false;                                   ///< the first proposed fix is made
  std::vector<std::string> ignored;                   ///< strokes
  std::optional<KnownPoint> known_point;              ///< each of these goes before what the drawing says
  std::vector<KnownLength> known_lengths;
  std::optional<double> field_of_view;  ///< degrees
};

void list_perspective_parameters(PerspectiveSettings& settings, ParameterList& list);

/// The drawing with what the settings say of it: strokes ignored, known point and lengths, field of view.
/// @throws Error (E_PARAMETER) for a stroke that isn't in the drawing
PerspectiveDrawing with_settings(const PerspectiveDrawing& drawing, const PerspectiveSettings& settings);

}  // namespace croquis
