// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "app/studio/studio.h"
#include "croquis/tools/mesh/mesh_pick.h"

namespace croquis::app {

/// Pickers of the objects' meshes, kept until a mesh changes. One thread.
class MeshPickers {
 public:
  MeshPicker* known(const WorkObject& object) const;  ///< null when there is none for the object as it is
  MeshPicker& of(const WorkObject& object);

 private:
  struct Kept {
    std::shared_ptr<const PolyMesh> mesh;
    std::unique_ptr<MeshPicker> picker;
  };
  std::map<NodeId, Kept> kept_;
};

/// Finds whole objects in a view. Pickers are made when the vertices of a mesh are first asked for.
class ObjectPicker {
 public:
  /// A place of an object's surface.
  struct Hit {
    NodeId node = 0;
    Vec3 place = Vec3::Zero();
  };

  /// The nearest object at a pixel; node 0 for none.
  Hit at(const std::vector<WorkObject>& objects, const ViewFrame& frame, const Vec2& pixel);

  /// The vertex nearest to a pixel, within reach and not hidden; else the place of a surface there; else nothing.
  std::optional<Vec3> place_at(const std::vector<WorkObject>& objects, const ViewFrame& frame, const Vec2& pixel);

  /// The objects whose boxes the pixels' box touches.
  static std::vector<NodeId> in_box(const std::vector<WorkObject>& objects, const ViewFrame& frame, const PickBox& box);

 private:
  MeshPickers pickers_;
};

}  // namespace croquis::app
