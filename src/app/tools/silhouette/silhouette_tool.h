// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QLabel>
#include <QTimer>

#include "app/tools/silhouette/sketch_chips.h"
#include "app/tools/silhouette/sketch_scene.h"
#include "app/tools/tool.h"
#include "croquis/tools/pointer/pen.h"
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
  void refresh() override;

  void set_mode(const QString& mode) override;
  bool works_in(int view) const override;
  void take(const PointerEvent& event) override;
  bool down() const override { return pen_.down(); }
  bool abandon() override;
  QString help() const override;
  QString tooltip() const override { return told_finding_; }

  void add_all_to(Selection& selection) const override;
  bool command(EditCommand command) override;
  bool open_step(const Node& step) override;

  void adjust(ObjectScenes::Wanted& wanted, int view) const override;
  void add_to(render::Scene& scene, int view) override;
  std::optional<Ink> ink() const override;
  render::Bounds bounds_in(int view) const override;
  std::optional<SelectionFrame> selection_frame(int view) const override;
  ViewUse use_of(int view) const override;
  void place_chips(ChipPlaces& places) override;

  void follow(Change change) override;
  bool show_finding(const NodeFinding& found) override;

  std::vector<ObjectRow> rows(const WorkObject& object, NodeId node) const override;
  bool choose_parts(NodeId node, const std::vector<std::string>& parts) override;
  QString owner_of(const NodeFinding& found) const override;

  void make_replays(Replays& replays) override;

 private:
  void add_sketch(const DrawingPlane& plane);
  bool has_view(int view) const;
  bool is_paper(int view) const;
  void add_counts(Replays& replays);
  void follow_lines();
  const ViewPane& pane() const;
  bool inking() const { return !tool_.preview().ink.empty(); }
  void take_pen(const std::vector<PenStep>& steps);
  void feed(const SketchEvent& event);
  void show_gesture();
  void hover(const PointerEvent& event);
  QString told_at(const Vec2& pixel) const;
  /// Feeds the tool a gesture in sketch coordinates, as a recording has it.
  /// @param scale units per pixel of the view it was made in; 0 for this one's
  void replay_gesture(const std::vector<StrokeSample>& samples, bool erases, const Modifiers& modifiers, double scale);
  bool draws() const { return mode() == "draw" || mode() == "erase"; }

  SketchTool tool_;
  PenInput pen_;
  SketchScene scene_;
  SketchChips chips_;
  QLabel* hint_;
  QString told_finding_;  ///< the sentences of the findings whose marks are under the pointer
  QTimer pen_watch_;      ///< while a stroke is under way: a pen may vanish without an event
  double last_time_ = 0;
  QElapsedTimer since_event_;
  std::map<NodeId, render::LineItemPtr> lines_;  ///< drawn on the surfaces of objects
};

}  // namespace croquis::app
