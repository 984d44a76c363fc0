// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "app/tools/mesh/mesh_actions.h"
#include "app/tools/mesh/mesh_overlay.h"
#include "app/tools/mesh/mesh_panels.h"
#include "app/tools/mesh/object_picking.h"
#include "app/tools/tool.h"
#include "app/views/legend.h"
#include "croquis/tools/mesh/mesh_tool.h"

namespace croquis::app {

/// Meshes: objects and their vertices, edges and faces are selected, moved, tagged and cut, by pen and mouse in any
/// view and by menus.
class MeshEditingTool final : public Tool {
  Q_OBJECT

 public:
  explicit MeshEditingTool(ToolHost& host);

  MeshTool& tool() { return tool_; }

  /// Runs one of the tool's functions; what it did is recorded, what it lost or refused is reported.
  void act(const std::function<Verdict(MeshTool&)>& work);

  /// What the pointer picks: objects or elements of one kind.
  void set_mesh_mode(MeshMode mode);
  void enter_mesh_mode(MeshMode mode);  ///< the same where the window's mode stays

  /// Shows what is there after the document or the selection has changed.
  void follow();

  /// One step of a pen or mouse, in the space of frame_in: that of the elements' object, or the model's.
  void handle(const MeshEvent& event, int view);
  ViewFrame frame_in(int view) const;

  void make_actions(ActionList& actions) override { actions_ = make_mesh_actions(*this, host(), actions); }
  void make_panels(PanelDocks& docks) override;
  void make_replays(Replays& replays) override { add_mesh_replays(replays, *this, studio()); }
  void refresh() override;
  void set_mode(const QString& mode) override;
  void follow(Change change) override { change == Change::Opened ? actions_.scale->offer() : follow(); }

  ViewUse use_of(int view) const override;
  ToolWords words() const override;
  ToolState state() const override;

  bool abandon() override;  ///< also the loop cut that waits for an edge
  bool command(EditCommand command) override;
  bool show(const Target& target) override;

  void adjust(ObjectScenes::Wanted& wanted, int view) const override;
  void add_to(render::Scene& scene, int view) override;
  std::optional<SelectionFrame> selection_frame(int view) const override;
  void place_chips(ChipPlaces& places) override;

 protected:
  void feed(const std::vector<PenStep>& steps) override;
  void hover(const PointerEvent& event) override;

 private:
  void attempt(const std::function<Verdict(MeshTool&)>& work);
  void show_hover();
  bool picks_objects() const { return tool_.selection().mode() == MeshMode::Object; }

  MeshTool tool_;
  ObjectPicking objects_;
  MeshOverlay overlay_;
  bool cage_hidden_ = false;  ///< the smooth surface alone is wanted, also while elements are picked
  int gesture_view_ = 0;
  Legend* legend_;
  bool shows_sharpness_ = false;  ///< of the edge under the pointer
  MeshActions actions_;
  std::function<void(bool useful)> show_panels_;
};

}  // namespace croquis::app
