// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "app/studio/studio.h"
#include "croquis/operators/surface_result.h"

namespace croquis::app {

/// What is known of the surfaces of a network, as they were computed last: maybe of the network as it was a moment ago.
struct ShownSurface {
  std::shared_ptr<const Evaluation> result;  ///< keeps all the rest
  const SurfaceResult* found = nullptr;      ///< null before the first one
  std::shared_ptr<const PolyMesh> mesh;      ///< in the object's space
  Affine3 to_result;                         ///< from the network's own space to the result's
  Affine3 to_mesh;                           ///< … to that of the mesh
  Affine3 to_world;                          ///< … to the model's, where the object stands

  explicit operator bool() const { return found != nullptr; }
  const AttributeNetwork& network() const { return *found->network; }
  const AttributeSurface& surface() const { return *found->surface; }

  // Indices into that network, no_index where it has no such element.
  Index face(const std::string& id) const;
  Index curve(const std::string& id) const;
  Index point(const std::string& id) const;
};

/// @param network source. @param operation that it goes to; 0 for none
ShownSurface shown_surface(const Studio& studio, NodeId network, NodeId operation);

/// From a network's own space to that of the mesh.
Affine3 placement_of(const Document& document, NodeId network, NodeId operation);

/// The inverse. @param map invertible
Affine3 inverse_of(const Affine3& map);

}  // namespace croquis::app
