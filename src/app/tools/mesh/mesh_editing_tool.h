// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <map>

#include "app/studio/scene_scale.h"
#include "app/tools/mesh/mesh_interaction.h"
#include "app/tools/mesh/sharpness_legend.h"
#include "app/tools/tool.h"

class QAction;
class QDockWidget;
class QLabel;
class QPushButton;
class QToolBar;

namespace croquis::app {

class CreaseSetPanel;
class EditPanel;
class TagPanel;

/// Meshes: objects and their vertices, edges and faces are selected, moved, tagged and cut.
class MeshEditingTool final : public Tool {
  Q_OBJECT

 public:
  explicit MeshEditingTool(ToolHost& host);

  MeshInteraction& mesh() { return mesh_; }

  void make_actions(ActionList& actions) override;
  void make_panels(PanelDocks& panels) override;
  void refresh() override;
  QStringList marking_menu(int view) const override;

  void set_mode(const QString& mode) override;
  bool works_in(int view) const override;
  void take(const PointerEvent& event) override;
  bool down() const override { return mesh_.down(); }
  bool abandon() override { return mesh_.abandon(); }
  QString help_topic() const override { return QStringLiteral("Meshes"); }
  QString help() const override;

  bool select_all() override;
  bool select_none() override;
  bool delete_selection() override;
  bool has_selection() const override;
  bool picks_elements() const override { return works() && !mesh_.picks_objects(); }
  bool pick(ComponentKind kind, const std::vector<Index>& elements) override;

  void adjust(ObjectScenes::Wanted& wanted, int view) const override;
  void add_to(render::Scene& scene, int view) override;
  std::optional<SelectionFrame> selection_frame(int view) const override;
  void place_chips(ChipPlaces& places) override;

  void follow_document() override { mesh_.follow(); }
  bool open_step(const Node& step) override;
  void follow_result() override { mesh_.follow(); }
  void follow_scenes() override { mesh_.follow(); }
  void opened() override { offer_scale(); }
  bool show_finding(const NodeFinding& found) override;

  std::vector<const recorded::StepKind*> steps() const override;
  bool replay(const recorded::Step& step) override;

 private:
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
  void set_mesh_mode(MeshMode mode);
  void replay_on_mesh(const std::string& node, const recorded::Step& step);
  void offer_scale();  ///< where what has been added is far larger or smaller than the rest
  void follow_scale();

  MeshInteraction mesh_;
  SceneScale scale_;
  SharpnessLegend* legend_;
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
