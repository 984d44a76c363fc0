// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "croquis/attribute_surface/attribute_surface.h"
#include "croquis/attribute_surface/surface_measures.h"
#include "croquis/attribute_surface/surface_tessellation.h"

/// What the operation `surface` gives besides its mesh; its report is made of this.
namespace croquis {

/// The answer to a question for a place.
struct EvaluatedPlace {
  Index face = no_index;
  FanPlace fan;
  std::optional<SurfacePlace> place;  ///< none: the face failed
  Vec3 normal = Vec3::Zero();         ///< unit, towards who sees the face's loop counter-clockwise
};

struct SurfaceResult {
  std::shared_ptr<const AttributeNetwork> network;  ///< that it was made of
  std::shared_ptr<const AttributeSurface> surface;  ///< by the indices of the network
  std::vector<SurfacePart> parts;                   ///< of the mesh: triangles, and vertices with their places
  SurfaceMeasures measures;
  std::vector<EvaluatedPlace> evaluated;
};

std::size_t byte_size(const SurfaceResult& result);

}  // namespace croquis
