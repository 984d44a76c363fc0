// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/tools/perspective/pen_entry.h"
#include "app/tools/perspective/perspective_chips.h"
#include "app/tools/perspective/sheet_interaction.h"
#include "app/tools/tool.h"

namespace croquis::app {

class PerspectivePanel;

/// Drawings in perspective: lines towards vanishing points and edges become a camera and a solid.
class PerspectiveDrawingTool final : public Tool {
  Q_OBJECT

 public:
  explicit PerspectiveDrawingTool(ToolHost& host);

  SheetInteraction& sheet() { return sheet_; }

  void make_actions(ActionList& actions) override;
  void make_panels(PanelDocks& docks) override;
  void refresh() override;
  QStringList marking_menu(int view) const override;
  int marking_key() const override;

  void set_mode(const QString& mode) override;
  bool works_in(int view) const override;
  void take(const PointerEvent& event) override { sheet_.take(event); }
  bool needs_every_move() const override { return true; }
  bool down() const override { return sheet_.down(); }
  bool abandon() override;
  QString help_topic() const override { return QStringLiteral("Drawings in perspective"); }
  QString help() const override;
  QString tooltip() const override { return sheet_.told_finding(); }
  Qt::CursorShape cursor(int view) const override;

  void add_all_to(Selection& selection) const override;
  bool delete_selection() override;
  bool accept() override;
  bool takes_key(int key) const override;
  void press_key(int key) override;
  bool open_step(const Node& step) override;

  void adjust(ObjectScenes::Wanted& wanted, int view) const override;
  void add_to(render::Scene& scene, int view) override;
  std::optional<Ink> ink() const override;
  bool is_paper(int view) const override { return has_view(view); }
  render::Bounds bounds_in(int view) const override;
  std::optional<SelectionFrame> selection_frame(int view) const override;
  QString view_title(int view) const override;
  void place_chips(ChipPlaces& places) override;

  void follow_document() override;
  void follow_result() override;
  bool show_finding(const NodeFinding& found) override;
  QString status() const override;

  std::vector<const recorded::StepKind*> steps() const override;
  bool replay(const recorded::Step& step) override;
  Expectations expectations() override;

 private:
  bool has_view(int view) const { return view == SketchView && studio().sheet_node() != 0; }
  bool draws() const { return mode() == "draw" || mode() == "erase"; }
  bool looks_through() const;
  void set_looking_through(bool on);
  void begin_new();
  void choose_group(std::optional<StrokeGroup> group);
  void connect_panel();
  void apply_fix();
  void ask_point(const Vec2& at);
  void ask_length(const std::string& stroke);
  void begin_known_length();
  void take_alternative(std::size_t alternative);
  void add_alternative_to(render::Scene& scene, int view) const;
  void set_parameter(const std::string& name, const ParameterValue& value);
  QPointF widget_place(const Vec2& sheet) const;
  void look_at_strokes(const std::vector<std::string>& strokes);
  void toggle_sharp();
  void set_face(bool add);
  void complete_mirrored();
  void do_and_record(Verdict verdict);
  void make_group_actions(ActionList& actions);
  void make_stroke_actions(ActionList& actions);

  SheetInteraction sheet_;
  PerspectiveChips chips_;
  PenEntry* entry_;
  PerspectivePanel* panel_ = nullptr;
  PanelDocks* docks_ = nullptr;
  QDockWidget* dock_ = nullptr;
  double overlay_ = 0.6;  ///< opacity of the drawing there; 0: none
  NodeId shown_node_ = 0;
};

}  // namespace croquis::app
