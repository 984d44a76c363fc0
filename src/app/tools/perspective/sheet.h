// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineEdit>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/panels/panel.h"
#include "app/tools/perspective/sheet_scene.h"
#include "app/tools/tool.h"
#include "croquis/operators/perspective_result.h"
#include "croquis/tools/perspective/perspective_tool.h"

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

/// What the next press on the sheet chooses instead of drawing: the known point, or the stroke whose length is known.
enum class SheetPick { None, Point, Length };

/// The drawing in perspective that is worked on, with what was found in it and what is shown of it. Its actions, panel
/// and chips are functions of it.
struct Sheet {
  explicit Sheet(Tool& tool_of_window, ToolHost& window);

  /// Of what is shown; an empty one while there is none.
  const PerspectiveDrawing& drawing() const;
  /// What was found in it, also while it is out of date; null before that.
  const PerspectiveResult* result() const { return result_of<PerspectiveResult>(shown.get()); }
  Findings findings() const { return shown ? shown->findings : Findings(); }

  /// Does a step of the tool, recorded. @return whether something changed
  bool take(const recorded::Step& step) { return record(tool.take(step)); }
  /// What the tool has done: a Commit is recorded. @return whether it is one
  bool record(Verdict verdict) const;

  bool is_there() const { return host.studio().sheet_node() != 0; }
  bool selects() const;        ///< the mode is the one for selecting
  bool looks_through() const;  ///< the perspective view is held at the drawing's eye

  Tool& owner;
  ToolHost& host;
  PerspectiveTool tool;
  SheetScene scene;
  PenEntry* entry;
  SheetPick picks = SheetPick::None;
  std::optional<MirrorProposal> proposal;   ///< what a mirror would add
  std::shared_ptr<const Evaluation> shown;  ///< result that the scene is made of
  double overlay = 0.6;                     ///< opacity of the drawing over the solid, 0: none
};

/// The actions of menus, keys and buttons, and which of them are enabled and checked now.
void add_sheet_actions(Sheet& sheet, ActionList& actions, ToolKeys& keys);
void refresh_sheet_actions(const Sheet& sheet);

/// The groups of strokes, the camera that was found, what is known, and which lines miss their vanishing point.
Panel* make_perspective_panel(Sheet& sheet);

/// What replays can do with a drawing, and ask of it.
void add_sheet_replays(Replays& replays, Sheet& sheet);

// What people do to it beside drawing.

void pick(Sheet& sheet, SheetPick wanted);

/// Where a place of the sheet is seen, in the views' pixels.
QPointF widget_place(const Sheet& sheet, const Vec2& at);

/// Asks at the pen for the point at a place of the sheet, or for the length of a stroke.
void ask_point(Sheet& sheet, const Vec2& at);
void ask_length(Sheet& sheet, const std::string& stroke);

/// Selects them, and frames them in the sketch view.
void look_at_strokes(Sheet& sheet, const std::vector<std::string>& strokes);
void look_through(Sheet& sheet, bool on);

/// Makes the first change that is proposed.
void apply_fix(Sheet& sheet);

void propose_mirror(Sheet& sheet, bool wanted);
void complete_mirrored(Sheet& sheet);

}  // namespace croquis::app
