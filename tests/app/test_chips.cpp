// SPDX-License-Identifier: GPL-3.0-or-later
// The small things that stand over the views, and what is said of a drawing that isn't done.
#include <QApplication>
#include <QLabel>
#include <QRegularExpression>
#include <QTest>
#include <QToolButton>
#include <QToolTip>

#include <catch2/catch.hpp>

#include "app/panels/lists.h"
#include "app/studio_fixture.h"
#include "app/views/view_chips.h"
#include "support/random.h"
#include "support/sketches/sketch_gallery.h"

using namespace croquis;
using app::Viewport;
using croquis::test::StudioFixture;

namespace {

std::vector<QWidget*> chips_of(Viewport& viewport) {
  std::vector<QWidget*> chips;
  for (QWidget* child : viewport.findChildren<QWidget*>(Qt::FindDirectChildrenOnly)) {
    const bool chip = qobject_cast<QLabel*>(child) != nullptr || qobject_cast<QToolButton*>(child) != nullptr ||
                      child->objectName().endsWith("-legend");
    if (chip && child->isVisible()) chips.push_back(child);
  }
  return chips;
}

void check_apart(Viewport& viewport) {
  const std::vector<QWidget*> chips = chips_of(viewport);
  CHECK(chips.size() >= 2);
  for (std::size_t i = 0; i < chips.size(); ++i) {
    CHECK(viewport.rect().contains(chips[i]->geometry()));
    for (std::size_t k = 0; k < i; ++k) {
      INFO(chips[i]->objectName().toStdString() << " over " << chips[k]->objectName().toStdString());
      CHECK(!chips[i]->geometry().intersects(chips[k]->geometry()));
    }
  }
}

/// Lines that people leave behind half way: open, crossing each other, touching themselves.
std::vector<std::vector<Vec2>> unfinished_lines(std::uint64_t seed) {
  test::Random random(seed);
  std::vector<std::vector<Vec2>> lines;
  const int count = 1 + static_cast<int>(random.below(5));
  for (int line = 0; line < count; ++line) {
    const Vec2 middle(random.between(-120, 120), random.between(-120, 120));
    const double radius = random.between(30, 120);
    const double from = random.between(0, 6);
    const double turn = random.between(2, 8);
    std::vector<Vec2> places;
    for (int k = 0; k <= 40; ++k) {
      const double angle = from + turn * k / 40;
      const double wide = radius * (1 + 0.3 * std::sin(3 * angle));
      places.emplace_back(middle + wide * Vec2(std::cos(angle), std::sin(angle)));
    }
    lines.push_back(std::move(places));
  }
  return lines;
}

/// Around the pixels of the errors' colour in a square of the widget; logical pixels.
QRectF box_of_red(const QImage& picture, const QPointF& middle, double side) {
  const double ratio = picture.devicePixelRatio();
  const QRectF square(middle - QPointF(side, side) / 2, QSizeF(side, side));
  const QRect pixels = QRectF(square.topLeft() * ratio, square.size() * ratio).toRect().intersected(picture.rect());
  QRect box;
  for (int y = pixels.top(); y <= pixels.bottom(); ++y) {
    for (int x = pixels.left(); x <= pixels.right(); ++x) {
      const QColor c = picture.pixelColor(x, y);
      if (c.red() > 150 && c.green() < 130 && c.blue() < 130) box |= QRect(x, y, 1, 1);
    }
  }
  return {QPointF(box.topLeft()) / ratio, QSizeF(box.size()) / ratio};
}

bool has_coordinates(const QString& sentence) {
  static const QRegularExpression place(R"(\(-?\d[^()]*,)");
  return sentence.contains(place);
}

}  // namespace

TEST_CASE("chips take the nearest free places, one beside the other", "[chips]") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    test::Random random(seed);
    const QRect bounds(10, 20, 300, 200);
    app::ChipSpace space;
    std::vector<QRect> taken;
    for (int k = 0; k < 25; ++k) {
      const auto up_to = [&](std::uint32_t count) { return static_cast<int>(random.below(count)); };
      const QRect wanted(up_to(340), up_to(240), 10 + up_to(60), 10 + up_to(20));
      const auto place = space.take(wanted, bounds);
      if (!place) continue;
      CHECK(place->size() == wanted.size());
      CHECK(bounds.contains(*place));
      bool free = bounds.contains(wanted);
      for (const QRect& other : taken) {
        CHECK(!other.intersects(*place));
        free = free && !other.adjusted(-2, -2, 2, 2).intersects(wanted);
      }
      if (free) CHECK(*place == wanted);
      taken.push_back(*place);
    }
    CHECK(taken.size() > 8);
    CHECK(!space.take(QRect(0, 0, 301, 10), bounds));
  }
}

TEST_CASE("nothing over the views lies over anything else, whatever is drawn", "[chips]") {
  StudioFixture hand;
  Viewport& view = hand.viewport();
  check_apart(view);
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    hand.window().start_with();
    hand.look_at({-250, -250}, {250, 250});
    for (const auto& line : unfinished_lines(seed)) hand.draw(line);
    hand.settle();
    INFO(seed);
    check_apart(view);
    hand.studio().session().mark_saved();
  }
  for (const char* sample : {"dog", "octopus", "duck"}) {
    hand.window().files().start_sample(sample);
    app::show_views(hand.window());
    hand.settle();
    INFO(sample);
    check_apart(view);
    view.pane(Viewport::SketchView).camera.height *= 8;  // joints come near each other
    emit view.views().changed();
    hand.settle();
    check_apart(view);
  }
  hand.window().resize(700, 420);
  hand.settle();
  check_apart(view);
}

TEST_CASE("what is wrong with a drawing is a small mark, its sentence is shown where the pointer comes to it",
          "[chips]") {
  StudioFixture hand;
  Viewport& view = hand.viewport();
  for (std::uint64_t seed = 10; seed < 14; ++seed) {
    hand.window().start_with();
    hand.look_at({-250, -250}, {250, 250});
    for (const auto& line : unfinished_lines(seed)) hand.draw(line);
    hand.settle();
    INFO(seed);
    const auto& marks = hand.sketch().scene().finding_marks();
    for (const QWidget* chip : chips_of(view)) {
      const auto* label = qobject_cast<const QLabel*>(chip);
      if (chip->windowType() == Qt::ToolTip) continue;  // shown where the pointer was before
      for (const app::FindingMark& mark : marks) CHECK((label == nullptr || label->text() != mark.sentence));
    }
    CHECK(!has_coordinates(app::help_of(view.views())));
    const auto* list = hand.window().findChild<app::FindingsList*>("findings");
    for (int row = 0; row < list->count(); ++row) CHECK(!has_coordinates(list->item(row)->text()));
    for (const app::FindingMark& mark : marks) {
      CHECK(!mark.sentence.isEmpty());
      const QPointF at = app::sketch_to_widget(view.views(), mark.at.head<2>());
      if (!view.pane(Viewport::SketchView).rect.contains(at)) continue;
      hand.send_mouse(QEvent::MouseMove, at, Qt::NoButton, Qt::NoModifier);
      CHECK(hand.sketch().words().tooltip.contains(mark.sentence));
    }
    hand.studio().session().mark_saved();
  }
}

TEST_CASE("a mark is small, and its sentence is shown while the pointer is on it", "[chips]") {
  StudioFixture hand;
  Viewport& view = hand.viewport();
  hand.look_at({-250, -250}, {250, 250});
  hand.draw({{-150, -40}, {-50, 0}, {60, 10}, {150, 60}});
  hand.sketch().tool().set({"stroke 1", silhouette::StrokeKind::Contour});  // which it can't be
  hand.settle();
  const QImage picture = hand.picture();
  const auto move_to = [&](const QPointF& place) {
    hand.send_mouse(QEvent::MouseMove, place, Qt::NoButton, Qt::NoModifier);
  };
  const auto& marks = hand.sketch().scene().finding_marks();
  REQUIRE(!marks.empty());
  for (const app::FindingMark& mark : marks) {
    INFO(mark.sentence.toStdString());
    REQUIRE(mark.error);
    const QPointF at = app::sketch_to_widget(view.views(), mark.at.head<2>());
    const QRectF red = box_of_red(picture, at, 60);
    INFO(red.width() << " x " << red.height());
    CHECK(red.width() > 5);
    CHECK(red.width() <= 22);
    CHECK(red.height() <= 22);
    CHECK(red.contains(at));
    const QPointF beside = at + QPointF(0, 40);
    for (const QPointF& away : {beside, view.pane(Viewport::PerspectiveView).rect.center()}) {
      CHECK(!QToolTip::isVisible());
      move_to(at);
      CHECK(QToolTip::isVisible());
      CHECK(QToolTip::text().contains(mark.sentence));
      move_to(away);
      // Long before it would go by itself.
      CHECK(QTest::qWaitFor([] { return !QToolTip::isVisible(); }, 2000));
    }
  }
}
