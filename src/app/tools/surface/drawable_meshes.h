// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <optional>

#include "app/studio/studio.h"
#include "croquis/tools/mesh/mesh_pick.h"
#include "croquis/tools/surface/surface_sight.h"

namespace croquis::app {

/// The other objects' meshes, which curves can be drawn on. Pickers are kept until a mesh changes. One thread.
class DrawableMeshes {
 public:
  explicit DrawableMeshes(const Studio& studio) : studio_(studio) {}

  /// @param ray    in the world
  /// @param except an object: the one that is drawn
  std::optional<MeshHit> under(const Ray& ray, NodeId except);

 private:
  struct Kept {
    std::shared_ptr<const PolyMesh> mesh;
    std::unique_ptr<MeshPicker> picker;
  };
  MeshPicker& picker_of(const WorkObject& object);

  const Studio& studio_;
  std::map<NodeId, Kept> kept_;
};

}  // namespace croquis::app
