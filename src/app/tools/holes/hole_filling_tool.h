// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>

#include "app/tools/holes/hole_interaction.h"
#include "app/tools/holes/hole_overlay.h"
#include "app/tools/tool.h"
#include "app/views/legend.h"

class QAction;
class QDockWidget;
class QMenu;

namespace croquis::app {

class HolePanel;

/// Holes of scans: listed, previewed, filled, shaped.
class HoleFillingTool final : public Tool {
  Q_OBJECT

 public:
  explicit HoleFillingTool(ToolHost& host);

  HoleInteraction& holes() { return holes_; }

  void make_actions(ActionList& actions) override;
  void make_panels(PanelDocks& panels) override;
  void refresh() override;

  void set_mode(const QString& mode) override;
  bool works_in(int) const override { return holes_.active(); }
  void take(const PointerEvent& event) override;
  bool down() const override { return holes_.down(); }
  bool abandon() override { return holes_.abandon(); }
  QString help() const override { return holes_.help(); }
  QString offer(const WorkObject& object) const override;

  bool command(EditCommand command) override;
  bool has_selection() const override { return holes_.active() && !holes_.selected().empty(); }

  void adjust(ObjectScenes::Wanted& wanted, int view) const override;
  void add_to(render::Scene& scene, int view) override { holes_.add_to(scene, view); }
  std::optional<SelectionFrame> selection_frame(int view) const override;
  void place_chips(ChipPlaces& places) override;
  bool busy() const override { return holes_.busy(); }

  void follow(Change change) override;
  void chosen_by_name(const std::vector<const FaceSet*>& sets) override;
  bool show_finding(const NodeFinding& found) override;
  bool open_step(const Node& step) override;

  std::vector<ObjectRow> rows(const WorkObject& object, NodeId node) const override;
  bool choose_parts(NodeId node, const std::vector<std::string>& parts) override;

  void make_replays(Replays& replays) override;

 private:
  QAction* add(ActionList& actions, QMenu* menu, const QString& name, const QString& text,
               const QList<QKeySequence>& keys, std::function<void(HoleInteraction&)> work,
               bool records_itself = false);
  void start();  ///< the active object gets the operation, and its holes are shown
  void show_patch_look();
  void frame_holes();
  void follow_dock(bool working);

  HoleInteraction holes_;
  HolePinView pins_;
  Legend* legend_;
  QList<QAction*> actions_;  ///< that need holes to work on
  HolePanel* panel_ = nullptr;
  PanelDocks* panels_ = nullptr;
  QDockWidget* dock_ = nullptr;
  bool tinted_ = false;  ///< patches by their confidence
};

}  // namespace croquis::app
