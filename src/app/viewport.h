// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QLabel>
#include <QOpenGLWidget>
#include <QTimer>
#include <QToolButton>
#include <array>
#include <memory>
#include <optional>

#include "app/joints.h"
#include "app/scenes.h"
#include "app/studio.h"
#include "app/view_pane.h"
#include "croquis/render/renderer.h"
#include "croquis/tools/navigation.h"
#include "croquis/tools/pen.h"
#include "croquis/tools/sketch_tool.h"

namespace croquis::app {

class OffscreenPictures;

enum class MeshLook { Wire, Shaded, ShadedWire };

/// The sketch view and the perspective view beside it, in one widget with one OpenGL context. Takes pen, mouse and
/// wheel, feeds the tools, and draws.
class Viewport : public QOpenGLWidget {
  Q_OBJECT

 public:
  enum View { SketchView = 0, PerspectiveView = 1 };

  Viewport(Studio& studio, QWidget* parent);
  ~Viewport() override;

  void set_mode(SketchMode mode);
  SketchMode mode() const { return tool_.mode(); }
  SketchTool& tool() { return tool_; }
  void set_look(MeshLook look);

  void frame_all();
  void frame_selection();

  /// The view under the pointer alone, or both again.
  void toggle_layout();

  void delete_selection();

  /// Accepts every joint of limb and body that is offered.
  void join_all();

  /// Gives up the gesture under way. @return false when there was none
  bool abandon();

  /// The window itself was moved: by Alt and a drag, the desktop may keep them for itself.
  void note_window_moved();

  /// The next action, in words and keys.
  QString help() const;

  /// The solid as the perspective view shows it, in a large picture. @throws Error
  void export_picture(OffscreenPictures& pictures, const QString& path) const;

  ViewPane& pane(View view) { return panes_[view]; }
  const Scenes& scenes() const { return scenes_; }

  void redraw_all();

  /// Draws the finer picture now instead of after a pause.
  void settle_now();

  /// Where a place of the sketch plane is seen, in the widget's logical pixels.
  QPointF sketch_to_widget(const Vec2& place) const;

  /// Feeds the tool a gesture in sketch coordinates, as a recording has it.
  /// @param scale units per pixel of the view it was made in; 0 for this one's
  void replay_gesture(const std::vector<StrokeSample>& samples, bool erases, const Modifiers& modifiers, double scale);

  /// Milliseconds from the last input event to the end of the frame that showed it, and how often frames were drawn.
  double last_latency_ms() const { return latency_ms_; }
  int frames() const { return frames_; }

 signals:
  void help_changed();

  /// A gesture changed the document or the selection.
  void committed(const croquis::recorded::Step& step);

 protected:
  void initializeGL() override;
  void resizeGL(int width, int height) override;
  void paintGL() override;
  bool event(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void tabletEvent(QTabletEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  void take(PointerEvent event, const QPointF& place);
  void hover(const PointerEvent& event);
  void tell_finding(const PointerEvent& event);
  void take_pen(const std::vector<PenStep>& steps);
  void feed(const SketchEvent& event);
  void show_gesture();
  void watch_pen();
  int view_at(const QPointF& place) const;
  void lay_out();
  void follow_document();
  void follow_result();
  void redraw(View view);
  void note_busy(bool busy);
  void draw_pane(const ViewPane& pane, const render::Scene& scene, const render::RenderOptions& options);
  render::RenderOptions solid_options() const;
  void place_labels();
  void place_finding_chips();
  void keep_solid_in_view();
  void show_joints();
  void place_joint_chips();
  bool drag_divider(const PointerEvent& event, const QPointF& place);

  Studio& studio_;
  SketchTool tool_;
  Navigation navigation_;
  PenInput pen_;
  Scenes scenes_;
  std::array<ViewPane, 2> panes_;
  std::unique_ptr<render::Renderer> renderer_;
  MeshLook look_ = MeshLook::Shaded;
  double divider_ = 0.5;  ///< share of the sketch view
  int alone_ = -1;        ///< the view that fills the widget, or -1
  int grabbed_ = -1;      ///< the view that the gesture under way began in, or -1
  int under_pointer_ = SketchView;
  bool dragging_divider_ = false;
  bool told_finding_ = false;
  bool turned_ = false;       ///< somebody moved the perspective view: it isn't framed by itself any more
  QTimer pen_watch_;          ///< while a stroke is under way: a pen may vanish without a word
  QTimer settle_;             ///< after a pause the solid is drawn once more, finer
  bool solid_drawn_ = false;  ///< the perspective view's pixels are still right: most events change the sketch alone
  QTimer patience_;           ///< a solid that is out of date for longer is shown faded
  bool stale_ = false;
  bool settled_ = false;
  bool affordable_ = true;  ///< the last fine frame was quick enough not to be felt
  QElapsedTimer clock_;
  QLabel* hint_;
  std::array<QLabel*, 3> finding_chips_;
  std::vector<Joint> joints_;
  std::vector<QToolButton*> joint_chips_;  ///< one for each of joints_; later ones wait hidden
  double input_time_ms_ = -1;
  double latency_ms_ = 0;
  int frames_ = 0;
};

}  // namespace croquis::app
