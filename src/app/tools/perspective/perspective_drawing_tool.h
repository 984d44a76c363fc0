// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/tools/perspective/perspective_chips.h"
#include "app/tools/perspective/sheet.h"
#include "app/tools/tool.h"

class QDockWidget;

namespace croquis::app {

/// Drawings in perspective: lines towards vanishing points and edges become a camera and a solid.
class PerspectiveDrawingTool final : public Tool {
  Q_OBJECT

 public:
  explicit PerspectiveDrawingTool(ToolHost& host);

  Sheet& sheet() { return sheet_; }

  void make_actions(ActionList& actions) override { add_sheet_actions(sheet_, actions, keys); }
  void make_panels(PanelDocks& docks) override;
  void make_replays(Replays& replays) override { add_sheet_replays(replays, sheet_); }
  void refresh() override;
  void set_mode(const QString& mode) override;
  void follow(Change change) override;

  ViewUse use_of(int view) const override;
  ToolWords words() const override;
  ToolState state() const override;

  void take(const PointerEvent& event) override;
  bool abandon() override;
  bool command(EditCommand command) override;
  void add_all_to(Selection& selection) const override;
  bool show(const Target& target) override;

  void adjust(ObjectScenes::Wanted& wanted, int view) const override;
  void add_to(render::Scene& scene, int view) override;
  std::optional<SelectionFrame> selection_frame(int view) const override;
  void place_chips(ChipPlaces& places) override;

 protected:
  void feed(const std::vector<PenStep>& steps) override;
  void hover(const PointerEvent& event) override;

 private:
  bool has_view(int view) const { return view == SketchView && sheet_.is_there(); }
  bool draws() const { return mode_ == "draw" || mode_ == "erase"; }
  bool inking() const { return !sheet_.tool.preview().ink.empty(); }
  void show_change();
  void show_gesture();
  void show_guides(const std::optional<Vec2>& from);
  void follow_document();
  void follow_result();

  Sheet sheet_;
  PerspectiveChips chips_;
  Panel* panel_ = nullptr;
  PanelDocks* docks_ = nullptr;
  QDockWidget* dock_ = nullptr;
  QString under_pointer_;  ///< the sentences of the findings whose marks are there
  NodeId shown_node_ = 0;
};

}  // namespace croquis::app
