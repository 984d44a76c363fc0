// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>

#include "app/panels/panel.h"
#include "app/tools/holes/hole_overlay.h"
#include "app/tools/holes/scan_holes.h"
#include "app/tools/tool.h"
#include "app/views/legend.h"

class QDockWidget;

namespace croquis::app {

/// Holes of scans: listed, previewed, filled, shaped.
class HoleFillingTool final : public Tool {
  Q_OBJECT

 public:
  explicit HoleFillingTool(ToolHost& host);

  ScanHoles& holes() { return holes_; }

  void make_actions(ActionList& actions) override;
  void make_panels(PanelDocks& panels) override;
  void make_replays(Replays& replays) override;
  void refresh() override;
  void set_mode(const QString& mode) override;
  void follow(Change change) override;

  ViewUse use_of(int) const override { return {.works = holes_.active}; }
  ToolWords words() const override;
  ToolState state() const override;
  QString offer() const override;

  bool command(EditCommand command) override;
  bool show(const Target& target) override;

  void adjust(ObjectScenes::Wanted& wanted, int view) const override;
  void add_to(render::Scene& scene, int view) override;
  std::optional<SelectionFrame> selection_frame(int view) const override;
  void place_chips(ChipPlaces& places) override;

  std::vector<ObjectRow> rows(const WorkObject& object, NodeId node) override;

 protected:
  void feed(const std::vector<PenStep>& steps) override;
  void hover(const PointerEvent& event) override;

 private:
  void open();  ///< the mode is that of holes
  void show_patch_look();
  void show_hover();

  ScanHoles holes_;
  HolePinView pins_;
  Legend* legend_;
  QList<QAction*> actions_;  ///< that need holes to work on
  int gesture_view_ = 0;
  Panel* panel_ = nullptr;
  PanelDocks* panels_ = nullptr;
  QDockWidget* dock_ = nullptr;
};

}  // namespace croquis::app
