// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/attribute_surface/attribute_surface.h"
#include "croquis/attribute_surface/surface_tessellation.h"
#include "croquis/base/parameter.h"
#include "croquis/document/operation.h"

namespace croquis {

/// The parameters of `surface`, parsed.
struct SurfaceSettings {
  AttributeSurfaceOptions surface;
  SurfaceTessellationOptions tessellation;
};

std::vector<ParameterDescription> surface_parameters();

/// @param parameters complete (see croquis::complete)
/// @throws Error (E_PARAMETER) for a fullness that can't be read
SurfaceSettings read_surface_settings(const ParameterValues& parameters, Quality quality);

}  // namespace croquis
