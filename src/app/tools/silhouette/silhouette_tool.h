// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

#include "app/tools/silhouette/sketch_chips.h"
#include "app/tools/silhouette/sketch_interaction.h"
#include "app/tools/tool.h"

namespace croquis::app {

/// Sketches: outlines drawn with the pen become solids.
class SilhouetteTool final : public Tool {
  Q_OBJECT

 public:
  explicit SilhouetteTool(ToolHost& host);

  SketchInteraction& sketch() { return sketch_; }

  void make_actions(ActionList& actions) override;
  void refresh() override;

  void set_mode(const QString& mode) override;
  bool works_in(int view) const override;
  void take(const PointerEvent& event) override { sketch_.take(event); }
  bool needs_every_move() const override { return true; }
  bool down() const override { return sketch_.down(); }
  bool abandon() override { return sketch_.abandon(); }
  QString help_topic() const override { return QStringLiteral("Drawing"); }
  QString help() const override;
  QString tooltip() const override { return sketch_.told_finding(); }
  Qt::CursorShape cursor(int view) const override;

  void add_all_to(Selection& selection) const override;
  bool delete_selection() override;
  bool open_step(const Node& step) override;

  void adjust(ObjectScenes::Wanted& wanted, int view) const override;
  void add_to(render::Scene& scene, int view) override;
  std::optional<Ink> ink() const override;
  bool is_paper(int view) const override;
  render::Bounds bounds_in(int view) const override;
  std::optional<SelectionFrame> selection_frame(int view) const override;
  QString view_title(int view) const override;
  void place_chips(ChipPlaces& places) override;

  void follow_document() override;
  void follow_result() override;
  bool show_finding(const NodeFinding& found) override;

  std::vector<ObjectRow> rows(const WorkObject& object, NodeId node) const override;
  bool choose_parts(NodeId node, const std::vector<std::string>& parts) override;
  QString owner_of(const NodeFinding& found) const override;

  std::vector<const recorded::StepKind*> steps() const override;
  bool replay(const recorded::Step& step) override;
  std::optional<std::size_t> parts_of(const WorkObject& object) const override;
  Expectations expectations() override;

 private:
  void add_sketch(const DrawingPlane& plane);
  bool has_view(int view) const;
  void follow_lines();
  bool draws() const { return mode() == "draw" || mode() == "erase"; }

  SketchInteraction sketch_;
  SketchChips chips_;
  QLabel* hint_;
  std::map<NodeId, render::LineItemPtr> lines_;  ///< drawn on the surfaces of objects
};

}  // namespace croquis::app
