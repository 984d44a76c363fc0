// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QOpenGLWidget>

#include "app/views/pointer_events.h"
#include "app/views/view_chips.h"
#include "app/views/view_pictures.h"
#include "app/views/views.h"

namespace croquis::app {

/// All views in one widget with one OpenGL context.
class Viewport : public QOpenGLWidget {
  Q_OBJECT

 public:
  using View = app::View;
  using enum app::View;

  Viewport(Studio& studio, QWidget* parent);
  ~Viewport() override;

  Views& views() { return views_; }
  ViewPane& pane(int view) { return views_.layout.pane(view); }
  ObjectScenes& objects() { return views_.objects; }
  ViewPictures& pictures() { return pictures_; }
  MarkingMenu& marking_menu() { return input_.menu; }

  /// What draws: the driver's own words.
  QString graphics();

  /// Milliseconds from the last input event to the end of the frame that showed it.
  double last_latency_ms() const { return latency_ms_; }

 protected:
  void initializeGL() override;
  void resizeGL(int width, int height) override;
  void resizeEvent(QResizeEvent* event) override;
  void paintGL() override;
  bool event(QEvent* event) override;

 private:
  Views views_;
  ViewPictures pictures_;
  ViewChips chips_;
  PointerInput input_;
  double latency_ms_ = 0;
};

}  // namespace croquis::app
