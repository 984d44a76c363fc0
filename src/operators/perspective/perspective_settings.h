// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "croquis/base/parameter.h"
#include "croquis/geometry/perspective_drawing.h"
#include "croquis/perspective/network_reconstruction.h"
#include "croquis/perspective/solid.h"

namespace croquis {

/// The parameters of `perspective`, parsed.
struct PerspectiveSettings {
  NetworkReconstructionOptions network;
  FaceFindingOptions faces;
  SolidOptions solid;
  bool fix = false;  ///< the first proposed fix is made
};

std::vector<ParameterDescription> perspective_parameters();

/// @param parameters complete (see croquis::complete)
/// @throws Error (E_PARAMETER) for lists that can't be read
PerspectiveSettings read_perspective_settings(const ParameterValues& parameters);

/// The drawing with what parameters say of it: strokes ignored, known point and lengths, field of view.
/// @throws Error (E_PARAMETER) for a stroke that isn't in the drawing
PerspectiveDrawing with_parameters(const PerspectiveDrawing& drawing, const ParameterValues& parameters);

}  // namespace croquis
