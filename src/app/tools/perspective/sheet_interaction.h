// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>
#include <vector>

#include "app/studio/studio.h"
#include "app/tools/perspective/sheet_scene.h"
#include "app/views/view_pane.h"
#include "croquis/operators/perspective_result.h"
#include "croquis/tools/perspective/perspective_tool.h"
#include "croquis/tools/pointer/pen.h"

namespace croquis::app {

/// Work on the sheet: pen and mouse events of the sketch view become strokes, and the view shows what they do and what
/// was found in them.
class SheetInteraction : public QObject {
  Q_OBJECT

 public:
  /// @param pane of the sketch view; outlives this
  SheetInteraction(Studio& studio, const ViewPane& pane);

  PerspectiveTool& tool() { return tool_; }
  const PerspectiveTool& tool() const { return tool_; }

  void set_mode(PerspectiveMode mode);
  void take(const PointerEvent& event);  ///< its place in the view's pixels
  bool down() const { return pen_.down(); }
  bool abandon();

  const std::vector<StrokeSample>& ink() const { return tool_.preview().ink; }
  bool inking() const { return !ink().empty(); }

  /// What the next press chooses instead of drawing: the known point, or the stroke whose length is known.
  enum class Pick { None, Point, Length };
  void pick(Pick wanted);
  Pick picks() const { return picks_; }

  /// Of what is shown; an empty one while there is none.
  const PerspectiveDrawing& drawing() const;
  /// What was found in it, also while it is out of date; null before that.
  const PerspectiveResult* result() const;
  Findings findings() const;

  /// Parameters of the operation that the drawing goes to; empty and false where it has none of its own.
  std::string parameter_text(const std::string& name) const;
  bool parameter_flag(const std::string& name) const;

  /// What a mirror would add, or nothing.
  const std::optional<MirrorProposal>& proposal() const { return proposal_; }
  void propose_mirror(bool wanted);

  /// The sentences of the findings under the pointer.
  const QString& told_finding() const { return told_finding_; }

  render::Scene scene() const;
  render::Bounds bounds() const { return scene_.bounds(); }

  void follow_document();
  void follow_result();

 signals:
  void changed();  ///< what is drawn
  void inked();    ///< nothing but the ink
  void committed(const croquis::recorded::Step& step);
  void state_changed();
  void point_picked(const croquis::Vec2& at);  ///< px of the sheet
  void length_picked(const std::string& stroke);

 private:
  template <typename T>
  const T* parameter_of(const std::string& name) const;
  void take_pick(const PointerEvent& event);
  void take_pen(const std::vector<PenStep>& steps);
  void feed(const PenStep& step);
  void show();
  void hover(const PointerEvent& event);
  void show_guides(const std::optional<Vec2>& from);
  QString told_at(const Vec2& pixel) const;
  Vec2 to_sheet(const Vec2& pixel) const;

  Studio& studio_;
  const ViewPane& pane_;
  PerspectiveTool tool_;
  PenInput pen_;
  SheetScene scene_;
  Pick picks_ = Pick::None;
  std::optional<MirrorProposal> proposal_;
  std::shared_ptr<const Evaluation> shown_;  ///< result that the scene is made of
  QString told_finding_;
  QTimer pen_watch_;  ///< while a stroke is under way: a pen may vanish without an event
  double last_time_ = 0;
  QElapsedTimer since_event_;
};

}  // namespace croquis::app
