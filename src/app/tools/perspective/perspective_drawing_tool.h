// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineEdit>
#include <functional>

#include "app/panels/panel.h"
#include "app/tools/perspective/perspective_chips.h"
#include "app/tools/perspective/sheet_interaction.h"
#include "app/tools/tool.h"

namespace croquis::app {

/// A field for one value at the pen. Enter takes what was typed, Escape and a click elsewhere leave everything as it
/// was. What can't be read stays, with a red frame.
class PenEntry : public QLineEdit {
  Q_OBJECT

 public:
  /// @return whether the text could be read
  using Take = std::function<bool(const QString& text)>;

  explicit PenEntry(QWidget* views);

  /// @param at logical pixels of the views, where the pen is
  /// @param title what is asked for, shown while the field is empty and as its tooltip
  void ask(const QPointF& at, const QString& title, const QString& text, Take take);

 signals:
  void finished();

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  void close_entry();
  void show_wrong(bool wrong);

  Take take_;
};

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

  void set_mode(const QString& mode) override;
  bool works_in(int view) const override;
  void take(const PointerEvent& event) override { sheet_.take(event); }
  bool down() const override { return sheet_.down(); }
  bool abandon() override;
  QString help() const override;
  QString tooltip() const override { return sheet_.told_finding(); }

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
  QString status() const override;

  void make_replays(Replays& replays) override;

 private:
  bool has_view(int view) const { return view == SketchView && studio().sheet_node() != 0; }
  bool draws() const { return mode() == "draw" || mode() == "erase"; }
  bool looks_through() const;
  void set_looking_through(bool on);
  void begin_new();
  void choose_group(std::optional<StrokeGroup> group);
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
  bool do_and_record(const recorded::Step& step);  ///< @return whether something changed
  void make_group_actions(ActionList& actions);
  void make_stroke_actions(ActionList& actions);
  void make_keys();

  SheetInteraction sheet_;
  PerspectiveChips chips_;
  PenEntry* entry_;
  Panel* panel_ = nullptr;
  PanelDocks* docks_ = nullptr;
  QDockWidget* dock_ = nullptr;
  double overlay_ = 0.6;  ///< opacity of the drawing there; 0: none
  NodeId shown_node_ = 0;
};

}  // namespace croquis::app
