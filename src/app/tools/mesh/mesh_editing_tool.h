// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <functional>
#include <map>
#include <optional>

#include "app/tools/mesh/mesh_overlay.h"
#include "app/tools/tool.h"
#include "app/views/legend.h"
#include "app/views/object_picker.h"
#include "croquis/tools/mesh/mesh_tool.h"
#include "croquis/tools/objects/object_mover.h"
#include "croquis/tools/pointer/pen.h"

class QAction;
class QDockWidget;
class QLabel;
class QPushButton;
class QToolBar;

namespace croquis::app {

class CreaseSetPanel;
class EditPanel;
class TagPanel;

/// Meshes: objects and their vertices, edges and faces are selected, moved, tagged and cut, by pen and mouse in any
/// view and by menus.
class MeshEditingTool final : public Tool {
  Q_OBJECT

 public:
  explicit MeshEditingTool(ToolHost& host);

  MeshTool& tool() { return tool_; }
  const MeshTool& tool() const { return tool_; }

  /// Runs one of the tool's functions; what it did is recorded, what it lost or refused is reported.
  void act(const std::function<Verdict(MeshTool&)>& work);

  /// What the pointer picks: objects or elements of one kind.
  void set_mesh_mode(MeshMode mode);

  /// Shows what is there after the document or the selection has changed.
  void follow();

  void make_actions(ActionList& actions) override;
  void make_panels(PanelDocks& panels) override;
  void refresh() override;
  QStringList marking_menu(int view) const override;

  void set_mode(const QString& mode) override;
  bool works_in(int view) const override;
  void take(const PointerEvent& event) override;
  bool down() const override { return pen_.down(); }
  bool abandon() override;  ///< also the loop cut that waits for an edge
  QString help() const override;

  bool command(EditCommand command) override;
  bool has_selection() const override;
  bool picks_elements() const override { return works() && !picks_objects(); }
  bool pick(ComponentKind kind, const std::vector<Index>& elements) override;

  void adjust(ObjectScenes::Wanted& wanted, int view) const override;
  void add_to(render::Scene& scene, int view) override;
  std::optional<SelectionFrame> selection_frame(int view) const override;
  void place_chips(ChipPlaces& places) override;

  void follow(Change change) override { change == Change::Opened ? offer_scale() : follow(); }
  bool open_step(const Node& step) override;
  bool show_finding(const NodeFinding& found) override;

  void make_replays(Replays& replays) override;

 private:
  /// What stands beside the pointer, and its place in the view: the sharpness of the edge there, or what a drag has
  /// done.
  struct HoveredValue {
    int view = 0;
    Vec2 pixel = Vec2::Zero();
    QString text;
  };

  void finish(Verdict verdict);
  void set_handles(MeshHandles handles);
  void leave();
  void feed(const PenStep& step);
  void feed(const MeshEvent& event, int view);
  void feed_object(const MeshEvent& event, int view);
  void choose_objects(std::vector<NodeId> nodes, const Modifiers& modifiers);
  void hover(const PointerEvent& event);
  void follow_hover();
  ViewFrame frame_in(int view) const;
  const ManipulatorMotion* motion() const;  ///< of the drag of a handle under way; null without one
  bool picks_objects() const { return tool_.selection().mode() == MeshMode::Object; }
  /// Only the smooth surface is wanted, also while elements are picked; a mode that picks them shows the cage again.
  void hide_cage(bool hidden);
  void enter_mesh_mode(MeshMode mode);
  /// A click or drag between places of the model, as a recording has it. @param clicks 2 for a double click
  void replay_drag(int view, const Vec3& from, const Vec3& to, const Modifiers& modifiers, int clicks);
  bool works() const;  ///< the mode is one of its own, and there is a mesh to work on
  QAction* add(ActionList& actions, QMenu* menu, const QString& name, const QString& text,
               const QList<QKeySequence>& keys, std::function<Verdict(MeshTool&)> work);
  void make_handle_actions(ActionList& actions);
  void make_mode_actions(ActionList& actions, QMenu* menu);
  void make_selection_actions(ActionList& actions, QMenu* menu);
  void make_shape_actions(ActionList& actions, QMenu* menu);
  void make_edit_actions(ActionList& actions, QMenu* menu);
  void make_scale_actions(ActionList& actions, QMenu* menu);
  void make_tag_actions(ActionList& actions, QMenu* menu);
  void show_last_edit();
  template <class... Commands>
  void replay_commands(Replays& replays);
  void replay_on_mesh(const std::string& node, const recorded::Step& step);
  void offer_scale();  ///< where what has been added is far larger or smaller than the rest
  void follow_scale();

  MeshTool tool_;
  ObjectMover mover_;
  PenInput pen_;
  MeshOverlay overlay_;
  ObjectPicker objects_;
  bool cage_hidden_ = false;
  int gesture_view_ = 0;
  std::optional<Vec2> object_press_;  ///< in object mode: where the press was, pixels
  std::optional<PickBox> object_box_;
  std::optional<HoveredValue> hovered_value_;
  Legend* legend_;
  QLabel* value_;                 ///< sharpness of the edge under the pointer, beside it
  QList<QAction*> mesh_actions_;  ///< that need a mesh to work on
  std::map<MeshMode, QAction*> mode_actions_;
  struct EditAction {
    QAction* action = nullptr;
    EditDescription edit;
  };
  std::vector<EditAction> edit_actions_;  ///< of edits that have no action of their own
  QToolBar* bar_ = nullptr;
  TagPanel* tags_ = nullptr;
  CreaseSetPanel* sets_ = nullptr;
  PanelDocks* panels_ = nullptr;
  QDockWidget* edges_dock_ = nullptr;
  QDockWidget* sets_dock_ = nullptr;
  EditPanel* last_edit_ = nullptr;
  QDockWidget* last_edit_dock_ = nullptr;
  QPushButton* scale_offer_ = nullptr;
  std::size_t scale_offered_at_ = 0;  ///< steps of the history when it was; another step takes the offer back
  NodeId scale_offered_ = 0;          ///< the object that was added
};

}  // namespace croquis::app
