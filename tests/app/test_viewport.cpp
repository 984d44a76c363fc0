// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QTest>
#include <QToolButton>
#include <QWheelEvent>

#include <catch2/catch.hpp>

#include "app/studio_fixture.h"
#include "app/window/theme.h"
#include "support/sketches/sketch_gallery.h"

using namespace croquis;
using app::Viewport;
using croquis::test::StudioFixture;

namespace {

QPointF middle(Viewport& viewport, Viewport::View view) { return viewport.pane(view).rect.center(); }

bool is_orange(const QColor& c) { return c.red() > 190 && c.green() > 90 && c.green() < 190 && c.blue() < 110; }

}  // namespace

TEST_CASE("ink is seen while the pen is down, before anything is fitted", "[viewport][scale]") {
  StudioFixture hand;
  Viewport& view = hand.viewport();
  std::vector<StrokeSample> half;
  const QRectF pane = view.pane(Viewport::SketchView).rect;
  const auto dark = [](const QColor& c) { return c.lightness() < 90; };
  const double before = test::share_of_pixels(hand.picture(), pane, dark);
  hand.begin_stroke({{-100, 0}, {-50, 60}, {0, 80}, {60, 40}});
  CHECK(hand.studio().drawing().strokes.empty());
  CHECK(test::share_of_pixels(hand.picture(), pane, dark) > before + 0.0005);
}

TEST_CASE("both views are drawn and nothing else; selected strokes are orange", "[viewport][scale]") {
  StudioFixture hand;
  hand.draw(test::snake_sketch());
  hand.settle();
  hand.act("select-all");
  const QImage picture = hand.picture();
  const QRectF sketch = hand.viewport().pane(Viewport::SketchView).rect;
  CHECK(test::share_of_pixels(picture, sketch, is_orange) > 0.001);
  CHECK(test::share_of_pixels(picture, sketch, [](const QColor& c) { return c.lightness() > 235; }) > 0.8);
  CHECK(!test::box_of_solid(hand).isEmpty());
}

TEST_CASE("a view that would look as before isn't drawn again, ink that was given up goes", "[viewport]") {
  StudioFixture hand;
  hand.draw(test::circle_sketch());
  Viewport& view = hand.viewport();
  const QImage before = hand.picture();
  const int sketches = view.pictures().state(Viewport::SketchView).drawn_count;
  const int solids = view.pictures().state(Viewport::PerspectiveView).drawn_count;
  emit view.views().changed();
  hand.settle();
  CHECK(view.pictures().state(Viewport::PerspectiveView).drawn_count == solids);
  CHECK(view.pictures().state(Viewport::SketchView).drawn_count == sketches);
  hand.begin_stroke({{-100, 0}, {-50, 60}, {0, 80}, {60, 40}});
  hand.settle();
  hand.act("deselect");
  CHECK(hand.picture() == before);
  CHECK(view.pictures().state(Viewport::PerspectiveView).drawn_count == solids);
  CHECK(view.pictures().state(Viewport::SketchView).drawn_count == sketches + 1);
  app::move_camera(view.views(), Viewport::PerspectiveView, CameraMotion{CameraMotion::Kind::Tumble, {40, 10}});
  emit view.views().changed();
  hand.settle();
  CHECK(view.pictures().state(Viewport::PerspectiveView).drawn_count > solids);
}

TEST_CASE("the wheel keeps the place under the pointer, Alt drags turn, shift and near", "[viewport][scale]") {
  StudioFixture hand;
  hand.draw(test::snake_sketch());
  hand.settle();
  Viewport& view = hand.viewport();
  const QPointF at = middle(view, Viewport::SketchView) + QPointF(60, 40);
  const auto place = [&] {
    const app::ViewPane& pane = view.pane(Viewport::SketchView);
    const QPointF in_pane = at - pane.rect.topLeft();
    return pane.sketch_frame().to_sketch({in_pane.x(), in_pane.y()});
  };
  const Vec2 before = place();
  const double height = view.pane(Viewport::SketchView).camera.height;
  QWheelEvent wheel(at, view.mapToGlobal(at), {}, {0, 240}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
  QApplication::sendEvent(&view, &wheel);
  CHECK(view.pane(Viewport::SketchView).camera.height < height);
  CHECK((place() - before).norm() < 1e-6);

  const render::Camera start = view.pane(Viewport::PerspectiveView).camera;
  const QPointF solid = middle(view, Viewport::PerspectiveView);
  hand.drag_pixels(solid, solid + QPointF(80, 30), Qt::LeftButton, Qt::AltModifier);
  const render::Camera turned = view.pane(Viewport::PerspectiveView).camera;
  CHECK(glm::length(turned.eye - start.eye) > 1);
  CHECK(glm::length(turned.target - start.target) < 1e-9);
  CHECK(glm::length(turned.eye - turned.target) == Approx(glm::length(start.eye - start.target)));
  hand.drag_pixels(solid, solid + QPointF(40, 0), Qt::MiddleButton, Qt::AltModifier);
  CHECK(glm::length(view.pane(Viewport::PerspectiveView).camera.target - turned.target) > 1);
  const render::Camera moved = view.pane(Viewport::PerspectiveView).camera;
  hand.drag_pixels(solid, solid + QPointF(60, 0), Qt::RightButton, Qt::AltModifier);
  const render::Camera neared = view.pane(Viewport::PerspectiveView).camera;
  CHECK(glm::length(neared.eye - neared.target) < glm::length(moved.eye - moved.target));
  // Navigation is no edit.
  CHECK(hand.studio().session().undo_labels().size() == 2);
}

TEST_CASE("a joint is offered where a limb meets the body: clicks take it apart, rest it and join it", "[viewport]") {
  StudioFixture hand;
  hand.act("start-page");
  hand.window().files().start_sample("dog");
  app::show_views(hand.window());
  hand.settle();
  auto* joint = hand.viewport().findChild<QToolButton*>("joint-0");
  REQUIRE(joint != nullptr);
  REQUIRE(joint->isVisible());
  const auto parts = [&] {
    const auto details = hand.studio().result()->outputs.at("details").as<Report>();
    return details->at("shells").as_array().size();
  };
  const std::size_t whole = parts();
  CHECK(joint->toolTip().startsWith("Joined"));  // a limb of a sketch that is opened
  joint->click();
  hand.settle();
  CHECK(parts() == whole + 1);
  CHECK(joint->toolTip().startsWith("Apart"));
  joint->click();
  hand.settle();
  CHECK(parts() == whole + 1);
  CHECK(joint->toolTip().startsWith("Resting"));
  joint->click();
  hand.settle();
  CHECK(parts() == whole);
  CHECK(joint->toolTip().startsWith("Joined"));
  joint->click();
  hand.act("join-limbs");
  hand.settle();
  CHECK(parts() == 1);
  for (int step = 0; step < 5; ++step) hand.act("undo");
  hand.settle();
  CHECK(parts() == whole);
  CHECK(joint->toolTip().startsWith("Joined"));
}

TEST_CASE("the sentence about a swallowed Alt goes once something else is done", "[viewport]") {
  StudioFixture hand;
  Viewport& view = hand.viewport();
  auto* line = hand.window().findChild<QLabel*>("help-line");
  const auto swallow = [&] {
    for (const QEvent::Type type : {QEvent::KeyRelease, QEvent::KeyPress}) {
      // As the window system has them: before the event.
      QKeyEvent key(type, Qt::Key_Alt, type == QEvent::KeyPress ? Qt::NoModifier : Qt::AltModifier);
      QApplication::sendEvent(&view, &key);
    }
    app::note_window_moved(view.views());
    REQUIRE(line->text().contains("uses Alt"));
  };
  swallow();
  hand.begin_stroke({{-50, 0}, {0, 60}});
  CHECK(!line->text().contains("uses Alt"));
  hand.act("deselect");
  swallow();
  hand.act("select");
  CHECK(!line->text().contains("uses Alt"));
  swallow();
  QTest::keyClick(&view, Qt::Key_F);
  CHECK(!line->text().contains("uses Alt"));
}

TEST_CASE("two fingers shift and near the sketch, one finger draws nothing", "[viewport]") {
  StudioFixture hand;
  hand.draw(test::snake_sketch());
  hand.settle();
  QTest::qWait(700);  // fingers this soon after a pen are the palm
  Viewport& view = hand.viewport();
  const std::size_t strokes = hand.studio().drawing().strokes.size();
  const double height = view.pane(Viewport::SketchView).camera.height;
  const QPoint middle_of_sketch = middle(view, Viewport::SketchView).toPoint();
  QPointingDevice* screen = QTest::createTouchDevice();
  QTest::touchEvent(&view, screen).press(0, middle_of_sketch - QPoint(40, 0), &view);
  QTest::touchEvent(&view, screen).move(0, middle_of_sketch - QPoint(60, 30), &view);
  QTest::touchEvent(&view, screen).release(0, middle_of_sketch - QPoint(60, 30), &view);
  CHECK(hand.studio().drawing().strokes.size() == strokes);
  QTest::touchEvent(&view, screen).press(0, middle_of_sketch - QPoint(40, 0), &view);
  QTest::touchEvent(&view, screen).stationary(0).press(1, middle_of_sketch + QPoint(40, 0), &view);
  for (int k = 1; k <= 6; ++k) {
    QTest::touchEvent(&view, screen)
        .move(0, middle_of_sketch - QPoint(40 + 10 * k, 0), &view)
        .move(1, middle_of_sketch + QPoint(40 + 10 * k, 0), &view);
  }
  QTest::touchEvent(&view, screen)
      .release(0, middle_of_sketch - QPoint(100, 0), &view)
      .release(1, middle_of_sketch + QPoint(100, 0), &view);
  CHECK(view.pane(Viewport::SketchView).camera.height < 0.7 * height);
  CHECK(hand.studio().drawing().strokes.size() == strokes);
}

TEST_CASE("space shows the view under the pointer alone and both again", "[viewport]") {
  StudioFixture hand;
  hand.draw(test::snake_sketch());
  Viewport& view = hand.viewport();
  QTest::mouseMove(&view, middle(view, Viewport::PerspectiveView).toPoint());
  hand.act("layout");
  CHECK(!view.pane(Viewport::SketchView).visible());
  CHECK(view.pane(Viewport::PerspectiveView).rect.width() == Approx(view.width()));
  hand.act("layout");
  CHECK(view.pane(Viewport::SketchView).visible());
}

TEST_CASE("strokes are erased, deleted and given up with Escape", "[viewport]") {
  StudioFixture hand;
  hand.draw(test::linked_rings_sketch());
  hand.settle();
  const std::size_t all = hand.studio().drawing().strokes.size();
  hand.begin_stroke({{0, 0}, {30, 30}});
  hand.act("deselect");
  CHECK(hand.studio().drawing().strokes.size() == all);
  hand.end_stroke({30, 30});
  CHECK(hand.studio().drawing().strokes.size() == all);

  hand.act("erase");
  const Stroke stroke = hand.studio().drawing().strokes.front();
  const Vec2 on_stroke = stroke.samples[stroke.samples.size() / 2].position;
  hand.drag(on_stroke - Vec2(4, 4), on_stroke + Vec2(4, 4));
  CHECK(hand.studio().drawing().strokes.front().samples.size() < stroke.samples.size());
  hand.act("undo");
  hand.act("select-all");
  hand.act("delete");
  CHECK(hand.studio().drawing().strokes.empty());
  hand.act("undo");
  CHECK(hand.studio().drawing().strokes.size() == all);
}

TEST_CASE("a fast pen loses nothing: three thousand events, three thousand samples", "[viewport]") {
  StudioFixture hand;
  hand.look_at({-300, -300}, {300, 300});
  std::vector<Vec2> spiral;
  for (int k = 0; k < 3000; ++k) {
    const double angle = 0.02 * k;
    spiral.emplace_back((40 + 0.06 * k) * std::cos(angle), (40 + 0.06 * k) * std::sin(angle));
  }
  hand.draw(spiral);
  REQUIRE(hand.studio().drawing().strokes.size() == 1);
  CHECK(hand.studio().drawing().strokes.front().samples.size() >= 3000);
}

TEST_CASE("the window answers while a solid is computed, and cancel keeps the last one", "[viewport]") {
  StudioFixture hand;
  hand.draw(test::octopus_sketch());
  hand.settle();
  const auto shown = hand.studio().solid();
  REQUIRE(shown != nullptr);
  hand.studio().set_parameter(hand.studio().solid_node(), "resolution", 2.0, false);
  CHECK(hand.studio().busy());
  hand.studio().cancel();
  hand.wait_for([&] { return !hand.studio().busy(); });
  CHECK(hand.studio().solid() != nullptr);
}
