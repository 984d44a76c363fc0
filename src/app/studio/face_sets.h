// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "croquis/session/selection.h"
#include "croquis/workspace/work_object.h"

namespace croquis::app {

/// Faces of an object that have a name: all patches that closed its holes, and each of them.
struct FaceSet {
  std::string name;          ///< "patches", "patch of hole 3", "patch of holes 3, 7"; of a mesh by itself "patch 3"
  std::vector<Index> holes;  ///< that the patch closes, as far as that is known
  std::vector<Index> faces;  ///< of the object's mesh, ascending
};

/// The sets of objects, read from the channel "patch_id" of their meshes. They are there as long as the patches are: in
/// projects and files with them. Kept until a mesh changes. One thread.
class FaceSets {
 public:
  /// Which holes each patch of an object closes, by its number; as far as that is known.
  using HolesOfPatches = std::function<std::map<std::int32_t, std::vector<Index>>(const WorkObject&)>;
  void set_holes(HolesOfPatches holes) { holes_ = std::move(holes); }

  void clear() { known_.clear(); }

  /// All patches first, then each by its lowest hole or number; none without patches. O(faces) for a new mesh.
  const std::vector<FaceSet>& of(const WorkObject& object);

  /// Of the sets that are selected as parts of the object, ascending.
  std::vector<Index> selected(const WorkObject& object, const Selection& selection);

 private:
  struct Known {
    std::shared_ptr<const PolyMesh> mesh;
    std::shared_ptr<const Evaluation> result;
    std::vector<FaceSet> sets;
  };
  std::vector<FaceSet> sets_of(const WorkObject& object) const;

  HolesOfPatches holes_;
  std::map<NodeId, Known> known_;
};

}  // namespace croquis::app
