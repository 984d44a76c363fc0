// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <functional>
#include <optional>
#include <vector>

#include "app/studio/studio.h"
#include "app/tools/silhouette/sketch_scene.h"
#include "app/views/view_pane.h"
#include "croquis/tools/pointer/pen.h"
#include "croquis/tools/silhouette/sketch_tool.h"

namespace croquis::app {

/// Work on the sketch: pen and mouse events of the sketch view become strokes, and the view shows what they do.
class SketchInteraction : public QObject {
  Q_OBJECT

 public:
  /// @param pane of the sketch view; outlives this
  SketchInteraction(Studio& studio, const ViewPane& pane, QObject* parent);

  SketchTool& tool() { return tool_; }
  const SketchScene& scene() const { return scene_; }

  SketchMode mode() const { return tool_.mode(); }
  void set_mode(SketchMode mode);

  /// An event of the sketch view, its place in the view's pixels.
  void take(const PointerEvent& event);

  bool down() const { return pen_.down(); }

  /// The stroke under way as drawn so far; empty while none is.
  const std::vector<StrokeSample>& ink() const { return tool_.preview().ink; }
  bool inking() const { return !ink().empty(); }
  bool inks_behind() const { return tool_.preview().behind; }  ///< that stroke will lie behind others

  bool abandon();  ///< gives up the gesture under way. @return false when there was none

  /// The sentences of the findings whose marks are under the pointer.
  const QString& told_finding() const { return told_finding_; }

  /// Feeds the tool a gesture in sketch coordinates, as a recording has it.
  /// @param scale units per pixel of the view it was made in; 0 for this one's
  void replay_gesture(const std::vector<StrokeSample>& samples, bool erases, const Modifiers& modifiers, double scale);

  void follow_document();
  void follow_result();

 signals:
  void changed();  ///< the scene
  void inked();    ///< nothing but the ink
  void committed(const croquis::recorded::Step& step);

 private:
  void take_pen(const std::vector<PenStep>& steps);
  void feed(const SketchEvent& event);
  void show_gesture();
  void follow_ink();
  void hover(const PointerEvent& event);
  QString told_at(const Vec2& pixel) const;

  Studio& studio_;
  const ViewPane& pane_;
  SketchTool tool_;
  PenInput pen_;
  SketchScene scene_;
  QString told_finding_;
  QTimer pen_watch_;  ///< while a stroke is under way: a pen may vanish without an event
  double last_time_ = 0;
  QElapsedTimer since_event_;
};

}  // namespace croquis::app
