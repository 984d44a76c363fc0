// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QEvent>
#include <QImage>
#include <QPointingDevice>
#include <QTemporaryDir>
#include <QTreeWidget>
#include <functional>
#include <memory>
#include <vector>

#include "app/studio/content.h"
#include "app/tools/holes/hole_filling_tool.h"
#include "app/tools/mesh/mesh_editing_tool.h"
#include "app/tools/silhouette/silhouette_tool.h"
#include "app/views/viewport.h"
#include "app/window/main_window.h"
#include "support/sketches/sketch.h"

namespace croquis::test {

/// The real window on a virtual display, with hands: pen and mouse events reach it as Qt delivers a device's.
class StudioFixture {
 public:
  StudioFixture();

  app::MainWindow& window() { return *window_; }
  app::Viewport& viewport() { return window_->viewport(); }
  app::Studio& studio() { return window_->studio(); }
  app::SilhouetteTool& sketch() { return window_->tool<app::SilhouetteTool>(); }
  app::MeshEditingTool& mesh() { return window_->tool<app::MeshEditingTool>(); }
  app::ScanHoles& holes() { return window_->tool<app::HoleFillingTool>().holes(); }
  QString folder() const { return folder_.path(); }

  /// Closes the window as a crash would and opens another one with the same folders.
  void crash_and_restart();

  /// Waits until a condition holds. @return whether it did within ten seconds
  bool wait_for(const std::function<bool()>& condition);

  /// Waits for the final solid of the document as it is.
  void settle();

  /// Draws with a pen through the places, sketch units; pressed, moved, lifted.
  void draw(const std::vector<Vec2>& places);

  /// The same without lifting the pen; and its end.
  void begin_stroke(const std::vector<Vec2>& places);
  void continue_stroke(const Vec2& place);
  void end_stroke(const Vec2& place);

  /// Every stroke of a sketch, with the view framed so that it fits.
  void draw(const Sketch& sketch);

  /// Shows the drawing's place in the middle of the sketch view.
  void look_at(const Vec2& low, const Vec2& high);

  /// Presses the mouse at a place of the sketch, drags to another, lets go.
  void drag(const Vec2& from, const Vec2& to);
  void click(const Vec2& at, Qt::KeyboardModifiers modifiers = Qt::NoModifier);

  /// One event of the mouse at a place of the widget, logical pixels.
  void send_mouse(QEvent::Type type, const QPointF& at, Qt::MouseButton button, Qt::KeyboardModifiers modifiers);

  /// Sends the mouse along a line of the widget, logical pixels.
  void drag_pixels(const QPointF& from, const QPointF& to, Qt::MouseButton button, Qt::KeyboardModifiers modifiers);

  /// Opens a shipped cage and waits.
  void open_cage(const char* name);

  /// Clicks with the mouse at a place of the model as a view shows it. @param clicks 2 for a double click
  void click_model(const Vec3& place, int view, int clicks = 1, Qt::KeyboardModifiers modifiers = Qt::NoModifier);

  /// Triggers an action of the window by its name.
  void act(const QString& action);

  /// The viewport's pixels.
  QImage picture();

 private:
  void send_pen(QEvent::Type type, const QPointF& place, double pressure);

  QTemporaryDir folder_;
  std::unique_ptr<QPointingDevice> pen_;
  std::unique_ptr<app::MainWindow> window_;
};

/// The rows of the object list that stand for parts (bodies, strokes, faces by a name), from above.
std::vector<QTreeWidgetItem*> part_rows(StudioFixture& fixture);

/// Part of the picture's pixels in the rectangle (logical pixels of the widget) that fit a colour test.
double share_of_pixels(const QImage& picture, const QRectF& rect, const std::function<bool(const QColor&)>& fits);

/// Where the perspective view shows something other than its background, in device pixels of the picture.
QRect box_of_solid(StudioFixture& fixture);

/// The samples of each stroke of a sketch, as a hand would follow them.
std::vector<std::vector<Vec2>> hand_strokes(const Sketch& sketch);

}  // namespace croquis::test
