// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "croquis/mesh_editing/mesh_edit.h"
#include "croquis/session/session.h"
#include "croquis/tools/mesh/mesh_editor.h"
#include "croquis/tools/mesh/mesh_pick.h"
#include "croquis/tools/mesh/mesh_selector.h"
#include "croquis/tools/pointer/manipulator.h"
#include "croquis/tools/pointer/mesh_event.h"
#include "croquis/tools/pointer/pen.h"
#include "croquis/tools/pointer/session_drag.h"

namespace croquis {

/// What a drag does. Sharpen: from a selected edge, or with Shift from anywhere, sideways changes the sharpness of the
/// selected edges.
enum class MeshHandles { Select, Move, Rotate, Scale, Sharpen };

/// Of the handles that move, rotate and scale; None for the others.
ManipulatorKind manipulator_kind(MeshHandles handles);

struct MeshToolOptions {
  MeshPickOptions pick;
  double drag_pixels = 4;  ///< a press that moves less is a click
  double double_click_seconds = 0.4;
  double pixels_per_level = 60;  ///< sideways drag for one level of sharpness
  double manipulator_pixels = 80;
  ManipulatorSnap snap = {0, 15, 0.1};  ///< while Ctrl is held at the beginning of a drag of the manipulator
};

/// What to draw over the views besides the selection (Session::components).
struct MeshPreview {
  std::optional<PickBox> box;               ///< pixels of the view the gesture began in
  std::optional<PickedElement> hovered;     ///< of the mode's kind
  std::optional<double> hovered_sharpness;  ///< of a hovered edge with a tag
  ManipulatorHandle hovered_handle = ManipulatorHandle::None;
  ManipulatorHandle active_handle = ManipulatorHandle::None;
  std::optional<LoopCutPreview> cut;        ///< while the loop cut is armed: where it would go
  std::optional<double> sharpness_change;   ///< Sharpen: levels so far
  std::optional<ManipulatorMotion> motion;  ///< what the drag has done, for the help line
};

/// What a click has to know of those before it.
struct MeshClicks {
  std::optional<MeshEvent> last;                      ///< that another one would make a double click
  Index anchor = no_index, anchor_before = no_index;  ///< last clicked element, and the one before that …
  std::uint64_t connectivity = 0;                     ///< … in this connectivity
};

struct MeshGesture;

/// Works on one mesh of a session as Maya does: picks components, moves them, tags edges, cuts. Its parts have what
/// selects and edits; the tool itself is what the pointer does.
///
/// Clicks: plain replaces, Shift toggles, Ctrl removes, Ctrl+Shift adds; boxes the same. Double click: of an edge its
/// loop, of a face or vertex all that is connected. Shift+double click goes on from the last picked element: along the
/// loop or ring of edges, the row of faces, the shortest path between vertices; else it adds what a double click picks.
/// Every change is one undo step. Selections come back with undo. The session outlives the tool. One thread.
///
/// What a gesture costs: a drag event copies the mesh and moves the picked vertices, nothing else.
class MeshTool {
 public:
  /// @param workspace computes meshes; null: it works on meshes of sources alone
  explicit MeshTool(Session& session, Workspace* workspace = nullptr, MeshToolOptions options = {});
  ~MeshTool();
  MeshTool(const MeshTool&) = delete;  // its parts refer to one another
  MeshTool& operator=(const MeshTool&) = delete;

  // ---- What it works on
  /// A node with a mesh, or one that gives a mesh: that is edited by a step of edits after it, and the tool goes on
  /// with this step. Another node than before empties hover and gestures.
  void set_node(NodeId node);
  EditableMesh& editable() { return editable_; }
  const EditableMesh& editable() const { return editable_; }

  // ---- Commands
  MeshSelector& selection() { return selector_; }
  const MeshSelector& selection() const { return selector_; }
  MeshEditor& edits() { return editor_; }
  /// As MeshEditor::take.
  Verdict take(const recorded::Step& step) { return editor_.take(step); }
  /// What the last Commit did, for recordings.
  const std::optional<recorded::Step>& done() const { return log_.done; }
  /// What the last edit lost or refused (warnings).
  const Findings& notes() const { return log_.notes; }

  // ---- Pointer
  MeshHandles handles() const { return handles_; }
  void set_handles(MeshHandles handles);
  void set_pick_through(bool through) { options_.pick.through = through; }

  Verdict handle(const MeshEvent& event);
  /// After a Begin in Object mode it isn't: the gesture is the window's, to pick and move objects with.
  bool active() const { return gesture_ != nullptr; }
  /// Pre-highlights. @return whether the preview changed
  bool hover(const Vec2& pixel, const ViewFrame& frame);
  bool leave();
  const MeshPreview& preview() const { return preview_; }
  /// At the middle of the selected elements; nothing when there is nothing to move.
  std::optional<Manipulator> manipulator();

  /// The next click cuts the hovered edge's ring, where it was hovered; every mode. Escape or another mode disarms.
  void arm_loop_cut(bool armed);
  bool loop_cut_armed() const { return loop_cut_armed_; }

 private:
  void begin(const MeshEvent& event);
  void drag();
  Verdict finish();
  Verdict give_up();

  Session& session_;
  MeshToolOptions options_;
  CommandLog log_;
  EditableMesh editable_;
  MeshSelector selector_;
  MeshEditor editor_;
  MeshHandles handles_ = MeshHandles::Select;
  bool loop_cut_armed_ = false;
  MeshPreview preview_;
  MeshClicks clicks_;
  std::unique_ptr<MeshGesture> gesture_;  ///< null: none is under way
  SessionDrag drag_;
};

/// The tool's manipulator as a view shows it; empty while a loop cut is armed.
ManipulatorPicture manipulator_picture(MeshTool& tool, const ViewFrame& frame);

}  // namespace croquis
