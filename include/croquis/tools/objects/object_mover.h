// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "croquis/tools/pointer/manipulator.h"
#include "croquis/tools/pointer/mesh_event.h"
#include "croquis/tools/pointer/pointer_event.h"
#include "croquis/tools/pointer/session_drag.h"
#include "croquis/tools/recording/general_steps.h"
#include "croquis/workspace/object_commands.h"

namespace croquis {

/// Moves, rotates and scales the objects that are picked (see picked) by a manipulator in their middle, all
/// together and as one undo step. Nothing is computed again. The workspace outlives it. One thread.
class ObjectMover {
 public:
  explicit ObjectMover(Workspace& workspace) : workspace_(workspace), drag_of_session_(workspace.session()) {}

  void set_kind(ManipulatorKind kind);

  /// In the middle of the picked objects that are seen; none without any, and for the kind None. It scales a single
  /// object along its own axes.
  std::optional<Manipulator> manipulator() const;
  ManipulatorPicture manipulator_picture(const ViewFrame& frame) const;

  /// A Begin off the handles is not taken: then active() is false. With Ctrl held rotations go in steps of 15 degrees,
  /// scales in tenths.
  Verdict handle(const MeshEvent& event);
  bool active() const { return drag_.has_value(); }
  /// What the drag has done so far; null without one.
  const ManipulatorMotion* motion() const { return drag_ ? &drag_->motion() : nullptr; }

  bool hover(const Vec2& pixel, const ViewFrame& frame);  ///< @return whether the picture changed
  bool leave();

  /// What the last Commit did, for recordings.
  const std::optional<recorded::Place>& done() const { return done_; }

 private:
  void drag_to(const Vec2& pixel);
  Verdict finish();
  Verdict give_up();
  std::vector<PlacedObject> moved_by(const Eigen::Affine3d& map) const;

  Workspace& workspace_;
  ManipulatorKind kind_ = ManipulatorKind::None;
  ManipulatorHandle hovered_ = ManipulatorHandle::None;
  std::optional<ManipulatorDrag> drag_;
  MeshEvent start_;                  ///< that began the drag
  Document begun_;                   ///< the document then …
  std::vector<PlacedObject> moved_;  ///< … and where the objects stood
  SessionDrag drag_of_session_;
  std::optional<recorded::Place> done_;
};

}  // namespace croquis
