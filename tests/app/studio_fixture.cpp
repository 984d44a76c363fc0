// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio_fixture.h"

#include <QAction>
#include <QApplication>
#include <QElapsedTimer>
#include <QMouseEvent>
#include <QTabletEvent>
#include <QTest>

#include "app/panels/lists.h"
#include "support/sanitizers.h"

namespace croquis::test {
namespace {

constexpr int patience_ms = 10'000 * slowness;

// Half the pixels of the window as it opens: without a graphics card nearly all the time goes into them.
constexpr QSize window_size(1120, 700);

}  // namespace

StudioFixture::StudioFixture()
    : pen_(std::make_unique<QPointingDevice>(
          "pen", 7, QInputDevice::DeviceType::Stylus, QPointingDevice::PointerType::Pen,
          QInputDevice::Capability::Position | QInputDevice::Capability::Pressure, 1, 1)),
      window_(std::make_unique<app::MainWindow>(folder_.path() + "/state")) {
  window_->resize(window_size);
  window_->show();
  (void)QTest::qWaitForWindowExposed(window_.get());
  window_->start_with();
  wait_for([this] { return viewport().pictures().frames > 0; });
  settle();  // panels get their sizes: views are where they stay
}

void StudioFixture::crash_and_restart() {
  window_->files().keeper().save_now();
  window_.reset();  // its work is nobody's before the next one looks for it
  window_ = std::make_unique<app::MainWindow>(folder_.path() + "/state");
  window_->show();
  (void)QTest::qWaitForWindowExposed(window_.get());
}

bool StudioFixture::wait_for(const std::function<bool()>& condition) {
  QElapsedTimer watch;
  watch.start();
  while (!condition()) {
    if (watch.elapsed() > patience_ms) return false;
    QApplication::processEvents(QEventLoop::AllEvents, 10);
  }
  return true;
}

void StudioFixture::settle() {
  QApplication::processEvents();
  wait_for([this] { return window_->settled(); });
  const int before = viewport().pictures().frames;
  viewport().update();
  wait_for([this, before] { return viewport().pictures().frames > before; });
}

void StudioFixture::send_pen(QEvent::Type type, const QPointF& place, double pressure) {
  const bool down = type != QEvent::TabletRelease;
  QTabletEvent event(type, pen_.get(), place, viewport().mapToGlobal(place), pressure, 0, 0, 0, 0, 0, Qt::NoModifier,
                     type == QEvent::TabletMove ? Qt::NoButton : Qt::LeftButton, down ? Qt::LeftButton : Qt::NoButton);
  QApplication::sendEvent(&viewport(), &event);
}

void StudioFixture::begin_stroke(const std::vector<Vec2>& places) {
  send_pen(QEvent::TabletPress, app::sketch_to_widget(viewport().views(), places.front()), 0.5);
  for (const Vec2& place : places) send_pen(QEvent::TabletMove, app::sketch_to_widget(viewport().views(), place), 0.6);
}

void StudioFixture::continue_stroke(const Vec2& place) {
  send_pen(QEvent::TabletMove, app::sketch_to_widget(viewport().views(), place), 0.6);
}

void StudioFixture::end_stroke(const Vec2& place) {
  send_pen(QEvent::TabletRelease, app::sketch_to_widget(viewport().views(), place), 0);
}

void StudioFixture::draw(const std::vector<Vec2>& places) {
  begin_stroke(places);
  end_stroke(places.back());
}

void StudioFixture::draw(const Sketch& sketch) {
  Vec2 low(1e300, 1e300);
  Vec2 high(-1e300, -1e300);
  const auto strokes = hand_strokes(sketch);
  for (const auto& stroke : strokes) {
    for (const Vec2& place : stroke) {
      low = low.cwiseMin(place);
      high = high.cwiseMax(place);
    }
  }
  look_at(low, high);
  for (const auto& stroke : strokes) draw(stroke);
}

void StudioFixture::look_at(const Vec2& low, const Vec2& high) {
  render::Bounds bounds;
  bounds.add({low.x(), low.y(), 0});
  bounds.add({high.x(), high.y(), 0});
  viewport().pane(app::Viewport::SketchView).frame(bounds);
}

void StudioFixture::send_mouse(QEvent::Type type, const QPointF& at, Qt::MouseButton button,
                               Qt::KeyboardModifiers modifiers) {
  const bool moved = type == QEvent::MouseMove;
  const Qt::MouseButtons held = type == QEvent::MouseButtonRelease ? Qt::NoButton : button;
  QMouseEvent event(type, at, viewport().mapToGlobal(at), moved ? Qt::NoButton : button, held, modifiers);
  QApplication::sendEvent(&viewport(), &event);
}

void StudioFixture::drag_pixels(const QPointF& from, const QPointF& to, Qt::MouseButton button,
                                Qt::KeyboardModifiers modifiers) {
  send_mouse(QEvent::MouseButtonPress, from, button, modifiers);
  constexpr int moves = 8;
  for (int i = 1; i <= moves; ++i) {
    send_mouse(QEvent::MouseMove, from + (to - from) * i / moves, button, modifiers);
    QApplication::processEvents();
  }
  send_mouse(QEvent::MouseButtonRelease, to, button, modifiers);
}

void StudioFixture::drag(const Vec2& from, const Vec2& to) {
  QTest::qWait(250);  // later than any mouse copy of the pen's events
  drag_pixels(app::sketch_to_widget(viewport().views(), from), app::sketch_to_widget(viewport().views(), to),
              Qt::LeftButton, Qt::NoModifier);
}

void StudioFixture::click(const Vec2& at, Qt::KeyboardModifiers modifiers) {
  QTest::qWait(250);
  const QPointF place = app::sketch_to_widget(viewport().views(), at);
  drag_pixels(place, place, Qt::LeftButton, modifiers);
}

void StudioFixture::open_cage(const char* name) {
  window_->open(QString(CROQUIS_SOURCE_DIR "/examples/data/") + name + ".obj");
  settle();
}

void StudioFixture::click_model(const Vec3& place, int view, int clicks, Qt::KeyboardModifiers modifiers) {
  const QPointF at = app::model_to_widget(viewport().views(), place, view);
  send_mouse(QEvent::MouseMove, at, Qt::NoButton, modifiers);
  for (int click = 0; click < clicks; ++click) {
    send_mouse(click == 0 ? QEvent::MouseButtonPress : QEvent::MouseButtonDblClick, at, Qt::LeftButton, modifiers);
    send_mouse(QEvent::MouseButtonRelease, at, Qt::LeftButton, modifiers);
  }
  QApplication::processEvents();
}

void StudioFixture::act(const QString& action) {
  window_->action(action)->trigger();
  QApplication::processEvents();
}

QImage StudioFixture::picture() {
  settle();
  return viewport().grabFramebuffer();
}

std::vector<QTreeWidgetItem*> part_rows(StudioFixture& fixture) {
  std::vector<QTreeWidgetItem*> rows;
  for (QTreeWidgetItemIterator row(fixture.window().findChild<app::ObjectList*>("objects")); *row != nullptr; ++row) {
    if (!app::ObjectList::parts_of(*row).empty()) rows.push_back(*row);
  }
  return rows;
}

double share_of_pixels(const QImage& picture, const QRectF& rect, const std::function<bool(const QColor&)>& fits) {
  const double ratio = picture.devicePixelRatio();
  const QRect pixels = QRectF(rect.topLeft() * ratio, rect.size() * ratio).toRect().intersected(picture.rect());
  int count = 0;
  for (int y = pixels.top(); y <= pixels.bottom(); ++y) {
    for (int x = pixels.left(); x <= pixels.right(); ++x) count += fits(picture.pixelColor(x, y));
  }
  return static_cast<double>(count) / (pixels.width() * pixels.height());
}

QRect box_of_solid(StudioFixture& fixture) {
  const QImage picture = fixture.picture();
  const double ratio = picture.devicePixelRatio();
  const QRectF rect = fixture.viewport().pane(app::Viewport::PerspectiveView).rect;
  const QRect view = QRectF(rect.topLeft() * ratio, rect.size() * ratio).toRect().intersected(picture.rect());
  // The background changes from top to bottom alone, and the axes stand in the lower left corner.
  QRect box;
  for (int y = view.top(); y < view.bottom() - 110 * ratio; ++y) {
    const QColor background = picture.pixelColor(view.right() - 1, y);
    for (int x = view.left() + 2; x < view.right(); ++x) {
      const QColor here = picture.pixelColor(x, y);
      const int difference = std::abs(here.red() - background.red()) + std::abs(here.green() - background.green()) +
                             std::abs(here.blue() - background.blue());
      if (difference > 24) box |= QRect(x, y, 1, 1);
    }
  }
  return box;
}

std::vector<std::vector<Vec2>> hand_strokes(const Sketch& sketch) {
  std::vector<std::vector<Vec2>> strokes;
  for (const Stroke& stroke : sketch.drawing.strokes) {
    std::vector<Vec2> places;
    for (const StrokeSample& sample : stroke.samples) places.push_back(sample.position);
    if (stroke.closed) places.push_back(places.front());
    strokes.push_back(std::move(places));
  }
  return strokes;
}

}  // namespace croquis::test
