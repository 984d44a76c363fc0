// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

#include "app/tools/silhouette/reading_strip.h"
#include "app/tools/silhouette/sketch_chips.h"
#include "app/tools/silhouette/sketch_scene.h"
#include "app/tools/tool.h"
#include "app/views/viewport.h"
#include "croquis/tools/silhouette/sketch_tool.h"

namespace croquis::app {

/// Sketches: outlines drawn with the pen become solids. Pen and mouse events of the sketch view become strokes, and the
/// view shows what they do.
class SilhouetteTool final : public Tool {
  Q_OBJECT

 public:
  explicit SilhouetteTool(ToolHost& host);

  SketchTool& tool() { return tool_; }
  const SketchScene& scene() const { return scene_; }

  void make_actions(ActionList& actions) override;
  void make_replays(Replays& replays) override;
  void refresh() override;
  void set_mode(const QString& mode) override;
  void follow(Change change) override;

  ViewUse use_of(int view) const override;
  ToolWords words() const override;
  ToolState state() const override;

  bool command(EditCommand command) override;
  void add_all_to(Selection& selection) const override;
  bool show(const Target& target) override;

  void adjust(ObjectScenes::Wanted& wanted, int view) const override;
  void add_to(render::Scene& scene, int view) override;
  std::optional<SelectionFrame> selection_frame(int) const override {
    return SelectionFrame{scene_.bounds(true), std::nullopt, false};
  }
  void place_chips(ChipPlaces& places) override;

  std::vector<ObjectRow> rows(const WorkObject& object, NodeId node) override;
  QString owner_of(const NodeFinding& found) const override;

 protected:
  void feed(const std::vector<PenStep>& steps) override;
  void hover(const PointerEvent& event) override;

 private:
  bool has_view(int view) const {
    return view == SketchView && studio().sheet_node() == 0 && studio().network_node() == 0;
  }
  SketchFrame frame() const { return host().viewport().pane(SketchView).sketch_frame(); }
  bool inking() const { return !tool_.preview().ink.empty(); }
  bool draws() const { return mode_ == "draw" || mode_ == "tube" || mode_ == "erase"; }
  void feed(const SketchEvent& event);
  void show_gesture();
  /// Feeds the tool a gesture in sketch coordinates, as a recording has it.
  /// @param scale units per pixel of the view it was made in; 0 for this one's
  void replay_gesture(const std::vector<StrokeSample>& samples, bool erases, const Modifiers& modifiers, double scale);

  SketchTool tool_;
  SketchScene scene_;
  SketchChips chips_;
  ReadingStrip* readings_;
  QLabel* hint_;
  double tube_share_ = 0.02;                     ///< radius of tubes drawn, of the view's diagonal
  QString under_pointer_;                        ///< the sentences of the findings whose marks are there
  std::map<NodeId, render::LineItemPtr> lines_;  ///< drawn on the surfaces of objects
};

}  // namespace croquis::app
