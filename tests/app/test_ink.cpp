// SPDX-License-Identifier: GPL-3.0-or-later
// A stroke while it is drawn: no event of it is lost, and nothing but its ink is drawn meanwhile.
#include <QApplication>
#include <QOpenGLFunctions>
#include <QTest>
#include <QThread>

#include <catch2/catch.hpp>

#include "app/studio_fixture.h"
#include "app/views/pointer_events.h"
#include "app/x_pointer.h"
#include "croquis/geometry/polyline.h"
#include "croquis/tools/silhouette/sketch_steps.h"
#include "support/sketches/sketch_gallery.h"
#include "support/sketches/sketch_modifiers.h"

using namespace croquis;
using app::Viewport;
using croquis::test::StudioFixture;

namespace {

/// What came of a stroke before anything was cleaned.
struct DrawnInk : QObject {
  explicit DrawnInk(Viewport& viewport) {
    connect(&viewport.views(), &app::Views::committed, this, [this](const recorded::Step& step) {
      if (const auto* stroke = step.as<recorded::StrokeDrawn>()) strokes.push_back(stroke->points);
    });
  }
  std::vector<std::vector<StrokeSample>> strokes;
};

/// The stamps of the mouse's events as the widget got them.
struct Stamps : QObject {
  explicit Stamps(QWidget& widget) { widget.installEventFilter(this); }
  bool eventFilter(QObject*, QEvent* event) override {
    const bool press = event->type() == QEvent::MouseButtonPress;
    if (press) of_strokes.emplace_back();
    const bool held =
        event->type() == QEvent::MouseMove && static_cast<QMouseEvent*>(event)->buttons().testFlag(Qt::LeftButton);
    if (press || held) of_strokes.back().push_back(static_cast<QMouseEvent*>(event)->timestamp());
    return false;
  }
  std::vector<std::vector<quint64>> of_strokes;
};

/// Every frame of the window takes that long.
void slow_down(Viewport& viewport, unsigned long frame_ms) {
  QObject::connect(&viewport, &QOpenGLWidget::aboutToCompose, &viewport, [frame_ms] { QThread::msleep(frame_ms); });
}

/// Whole pixels around the middle of the sketch view, neighbours different.
std::vector<QPoint> circle_of_pixels(Viewport& viewport, double radius, int count) {
  const QPointF middle = viewport.pane(Viewport::SketchView).rect.center();
  std::vector<QPoint> places;
  for (int k = 0; k <= count; ++k) {
    const double angle = 2 * 3.14159265358979 * k / count;
    places.push_back((middle + radius * QPointF(std::cos(angle), std::sin(angle))).toPoint());
  }
  return places;
}

std::vector<QPoint> on_screen(Viewport& viewport, std::vector<QPoint> places) {
  for (QPoint& place : places) place = viewport.mapToGlobal(place);
  return places;
}

Vec2 on_sketch(Viewport& viewport, const QPointF& place) {
  const app::ViewPane& pane = viewport.pane(Viewport::SketchView);
  const QPointF in_pane = place - pane.rect.topLeft();
  return pane.sketch_frame().to_sketch({in_pane.x(), in_pane.y()});
}

/// A mouse event with a stamp, as one that waited in the window's queue has it.
void send_stamped(Viewport& viewport, QEvent::Type type, const QPointF& at, bool held, quint64 stamp) {
  const bool moved = type == QEvent::MouseMove;
  QMouseEvent event(type, at, viewport.mapToGlobal(at), moved ? Qt::NoButton : Qt::LeftButton,
                    held ? Qt::LeftButton : Qt::NoButton, Qt::NoModifier);
  event.setTimestamp(stamp);
  QApplication::sendEvent(&viewport, &event);
}

bool is_magenta(const QColor& c) { return c.red() > 250 && c.green() < 5 && c.blue() > 250; }

/// Paints over all that was drawn: where the colour is gone, something was drawn again.
void paint_over(Viewport& viewport) {
  viewport.makeCurrent();
  QOpenGLFunctions* gl = QOpenGLContext::currentContext()->functions();
  gl->glClearColor(1, 0, 1, 1);
  gl->glClear(GL_COLOR_BUFFER_BIT);
  viewport.doneCurrent();
}

double painted_over(Viewport& viewport, const QRectF& rect) {
  return test::share_of_pixels(viewport.grabFramebuffer(), rect, is_magenta);
}

/// Of any channel of any pixel.
int largest_difference(const QImage& a, const QImage& b) {
  if (a.size() != b.size()) return 255;
  int largest = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      const QColor one = a.pixelColor(x, y);
      const QColor other = b.pixelColor(x, y);
      largest = std::max({largest, std::abs(one.red() - other.red()), std::abs(one.green() - other.green()),
                          std::abs(one.blue() - other.blue())});
    }
  }
  return largest;
}

std::vector<Vec2> arc(double radius, double from, double to, int count) {
  std::vector<Vec2> places;
  for (int k = 0; k <= count; ++k) {
    const double angle = from + (to - from) * k / count;
    places.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return places;
}

/// Shows all of some strokes in the sketch view.
void frame(StudioFixture& hand, const std::vector<std::vector<Vec2>>& strokes) {
  Vec2 low = strokes.front().front();
  Vec2 high = low;
  for (const auto& stroke : strokes) {
    for (const Vec2& place : stroke) {
      low = low.cwiseMin(place);
      high = high.cwiseMax(place);
    }
  }
  hand.look_at(low, high);
}

/// A stroke in whole pixels as a mouse reports it within 0.7 seconds, four milliseconds apart.
std::vector<QPoint> at_pace(Viewport& viewport, const std::vector<Vec2>& stroke) {
  constexpr int moves = 175;
  const std::vector<double> lengths = arc_lengths(stroke, false);
  std::vector<QPoint> places;
  std::size_t next = 0;
  for (int k = 0; k <= moves; ++k) {
    const double along = lengths.back() * k / moves;
    while (next + 2 < stroke.size() && lengths[next + 1] < along) ++next;
    const double share = (along - lengths[next]) / (lengths[next + 1] - lengths[next]);
    const QPoint place =
        app::sketch_to_widget(viewport.views(), stroke[next] + share * (stroke[next + 1] - stroke[next])).toPoint();
    if (places.empty() || places.back() != place) places.push_back(place);
  }
  return places;
}

/// Draws a sketch as a hasty hand does, with the display's own pointer, while frames take their time.
void draw_by_hand(const test::Sketch& sketch) {
  StudioFixture hand;
  Viewport& view = hand.viewport();
  slow_down(view, 60);
  test::Sketch drawn = sketch;
  drawn.drawing = test::noisy(sketch.drawing, 3);
  const auto strokes = test::hand_strokes(drawn);
  frame(hand, strokes);
  test::XPointer pointer;
  for (const auto& stroke : strokes) {
    const std::size_t before = hand.studio().drawing().strokes.size();
    pointer.drag(on_screen(view, at_pace(view, stroke)), 4);
    REQUIRE(hand.wait_for([&] { return hand.studio().drawing().strokes.size() > before; }));
  }
  hand.settle();
  const auto result = hand.studio().result();
  REQUIRE(result != nullptr);
  for (const Finding& finding : result->findings) {
    INFO(finding.message);
    CHECK(finding.severity != Severity::Error);
  }
  REQUIRE(!result->failed);
  const auto details = result->outputs.at("details").as<Report>();
  CHECK(static_cast<int>(details->at("objects").as_array().size()) == sketch.truth.components);
}

}  // namespace

TEST_CASE("of a real pointer a thousand times a second every event is ink, at its own time, while frames take 100 ms",
          "[ink]") {
  StudioFixture hand;
  Viewport& view = hand.viewport();
  const DrawnInk drawn(view);
  const Stamps stamps(view);
  slow_down(view, 100);
  test::XPointer pointer;
  const std::vector<QPoint> places = circle_of_pixels(view, 130, 300);
  pointer.drag(on_screen(view, places), 1);
  REQUIRE(hand.wait_for([&] { return !drawn.strokes.empty(); }));

  const std::vector<StrokeSample>& ink = drawn.strokes.front();
  REQUIRE(ink.size() == places.size());
  REQUIRE(stamps.of_strokes.size() == 1);
  REQUIRE(stamps.of_strokes.front().size() == places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    INFO(i);
    CHECK((ink[i].position - on_sketch(view, places[i])).norm() < 1e-9);
    const auto since_press = static_cast<double>(stamps.of_strokes.front()[i] - stamps.of_strokes.front().front());
    CHECK(ink[i].time == Approx(1e-3 * since_press).margin(1e-9));
    CHECK(ink[i].time >= ink[i == 0 ? 0 : i - 1].time);
  }
  CHECK(ink.back().time > 0);
  hand.settle();
  REQUIRE(hand.studio().drawing().strokes.size() == 1);
  CHECK(hand.studio().drawing().strokes.front().closed);
  CHECK(hand.studio().solid() != nullptr);
}

TEST_CASE("a knot drawn with a mouse at the speed of a hand becomes a solid", "[hand]") {
  draw_by_hand(test::trefoil_sketch());
}

TEST_CASE("an animal drawn with a mouse at the speed of a hand becomes solids", "[hand]") {
  draw_by_hand(test::dog_sketch());
}

TEST_CASE("samples have the times of their events, whenever these are handled", "[ink]") {
  StudioFixture hand;
  Viewport& view = hand.viewport();
  const DrawnInk drawn(view);
  const std::vector<QPoint> places = circle_of_pixels(view, 100, 60);
  constexpr quint64 start = 7'000'000;
  send_stamped(view, QEvent::MouseButtonPress, places.front(), true, start);
  for (std::size_t i = 1; i < places.size(); ++i) {
    if (i % 20 == 0) QThread::msleep(60);  // the window is busy
    send_stamped(view, QEvent::MouseMove, places[i], true, start + 3 * i);
  }
  send_stamped(view, QEvent::MouseButtonRelease, places.back(), false, start + 3 * places.size());
  REQUIRE(drawn.strokes.size() == 1);
  REQUIRE(drawn.strokes.front().size() == places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    CHECK(drawn.strokes.front()[i].time == Approx(0.003 * static_cast<double>(i)).margin(1e-9));
  }
}

TEST_CASE("events without a stamp follow those that have one", "[ink]") {
  app::EventClock clock;
  CHECK(clock.time_of(5000, 100) == 5);
  CHECK(clock.lag() == 0);
  CHECK(clock.time_of(5100, 100.4) == Approx(5.1));
  CHECK(clock.lag() == Approx(0.3).margin(1e-3));
  CHECK(clock.time_of(0, 100.5) == Approx(5.2));
  CHECK(clock.time_of(0, 100.7) == Approx(5.4));
  CHECK(clock.lag() == 0);
  // The server counts from 0 again.
  CHECK(clock.time_of(1, 4'000'000) == Approx(0.001));
  CHECK(clock.lag() == 0);
}

TEST_CASE("while a stroke is under way only the rectangle of its newest ink is drawn", "[ink]") {
  StudioFixture hand;
  Viewport& view = hand.viewport();
  hand.look_at({-200, -200}, {200, 200});
  hand.draw(arc(120, 0, 6.28, 60));
  hand.settle();
  hand.begin_stroke(arc(60, 0, 1, 20));
  const QRectF sketch = view.pane(Viewport::SketchView).rect;
  const QRectF solid = view.pane(Viewport::PerspectiveView).rect;
  hand.picture();
  paint_over(view);
  REQUIRE(painted_over(view, sketch) == 1);

  hand.continue_stroke({20, 60});
  hand.continue_stroke({10, 60});
  view.pane(Viewport::PerspectiveView).camera.eye.x += 100;
  emit view.views().changed();
  hand.studio().set_parameter(hand.studio().solid_node(), "resolution", 7.0, false);
  hand.settle();
  CHECK(painted_over(view, solid) == 1);
  CHECK(painted_over(view, sketch) > 0.97);
  const QPointF ink = app::sketch_to_widget(view.views(), {15, 60});
  CHECK(painted_over(view, QRectF(ink - QPointF(2, 2), QSizeF(4, 4))) == 0);

  hand.end_stroke({10, 60});
  hand.settle();
  CHECK(painted_over(view, solid) == 0);
  CHECK(painted_over(view, sketch) == 0);
}

TEST_CASE("ink that came piece by piece looks like ink drawn at once", "[ink][scale]") {
  StudioFixture hand;
  hand.look_at({-200, -200}, {200, 200});
  hand.draw(arc(150, 0, 6.28, 60));
  hand.settle();
  const std::vector<Vec2> spiral = arc(90, 0, 5, 50);
  hand.begin_stroke({spiral.front()});
  for (const Vec2& place : spiral) {
    hand.continue_stroke(place);
    QApplication::processEvents();
  }
  const QImage pieces = hand.picture();
  hand.viewport().views().layout.arrange(app::Arrangement::SketchAndSolid);  // all is drawn again
  const QImage whole = hand.picture();
  CHECK(largest_difference(pieces, whole) <= 3);
  hand.end_stroke(spiral.back());
}

TEST_CASE("what is computed while a stroke is under way is shown when it has ended", "[ink]") {
  StudioFixture hand;
  Viewport& view = hand.viewport();
  hand.look_at({-200, -200}, {200, 200});
  int reports = 0;
  QObject::connect(&hand.studio(), &app::Studio::result_changed, [&] { ++reports; });
  hand.draw(arc(120, 0, 1.5, 60));
  hand.sketch().tool().set({"stroke 1", silhouette::StrokeKind::Contour});  // an error, when it is computed
  hand.begin_stroke(arc(120, 4.5, 5, 10));
  reports = 0;
  hand.settle();
  CHECK(!hand.studio().busy());
  CHECK(reports == 0);
  CHECK(hand.sketch().scene().finding_marks().empty());
  CHECK(!app::help_of(view.views()).contains("stroke"));
  hand.act("deselect");  // gives the stroke up
  CHECK(reports > 0);
  CHECK(!hand.sketch().scene().finding_marks().empty());
}

TEST_CASE("of moves that waited for a busy window only the newest is looked at, unless they draw", "[ink]") {
  StudioFixture hand;
  Viewport& view = hand.viewport();
  hand.open_cage("mug");
  hand.act("vertex-mode");
  hand.settle();
  int changes = 0;
  QObject::connect(&hand.mesh(), &app::Tool::changed, [&] { ++changes; });
  const WorkObject* mug = hand.studio().active();
  REQUIRE(mug != nullptr);
  const QPointF vertex = app::model_to_widget(view.views(), mug->shown()->positions.front(), Viewport::PerspectiveView);
  const QPointF nothing = view.pane(Viewport::PerspectiveView).rect.topLeft() + QPointF(30, 60);
  constexpr quint64 start = 1'000'000;
  constexpr int moves = 40;
  const auto sweep = [&](quint64 first) {
    for (int k = 0; k < moves; ++k) {
      send_stamped(view, QEvent::MouseMove, k % 2 == 0 ? nothing : vertex, false, first + static_cast<quint64>(k) / 8);
    }
    QApplication::processEvents();
  };
  sweep(start);
  CHECK(changes >= moves - 1);
  QThread::msleep(200);
  changes = 0;
  sweep(start + 10);
  CHECK(changes <= 1);
  CHECK(hand.mesh().tool().preview().hovered.has_value());
}
