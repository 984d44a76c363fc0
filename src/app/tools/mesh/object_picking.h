// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "app/studio/studio.h"
#include "app/views/object_picker.h"
#include "croquis/tools/objects/object_mover.h"
#include "croquis/tools/pointer/mesh_event.h"
#include "croquis/tools/recording/step.h"

namespace croquis::app {

/// Whole objects are picked with clicks and boxes, and moved by a manipulator.
class ObjectPicking {
 public:
  explicit ObjectPicking(Studio& studio) : studio_(studio), mover_(studio) {}

  ObjectMover& mover() { return mover_; }
  const ObjectMover& mover() const { return mover_; }

  bool active() const { return press_.has_value(); }
  const std::optional<PickBox>& box() const { return box_; }  ///< being spanned, pixels

  /// @return what was done, for recordings
  std::optional<recorded::Step> handle(const MeshEvent& event, int view);

 private:
  std::optional<recorded::Step> finish(const MeshEvent& event, int view);

  Studio& studio_;
  ObjectMover mover_;
  ObjectPicker picker_;
  std::optional<Vec2> press_;  ///< where the press was, pixels
  std::optional<PickBox> box_;
};

}  // namespace croquis::app
