// SPDX-License-Identifier: GPL-3.0-or-later
// Other readings of a sketch, as pictures at the lower edge of its view.
#include <QFrame>
#include <QTest>
#include <QToolButton>
#include <cmath>

#include <catch2/catch.hpp>

#include "app/studio_fixture.h"
#include "croquis/operators/inflate_result.h"
#include "croquis/silhouette/stroke_data.h"

namespace croquis::test {
namespace {

std::vector<Vec2> circle(double radius) {
  std::vector<Vec2> places;
  for (int k = 0; k <= 80; ++k) {
    const double angle = 0.7 + 2 * 3.14159265358979 * 1.01 * k / 80;
    places.push_back(radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return places;
}

QToolButton* button(StudioFixture& hand, const char* name) { return hand.viewport().findChild<QToolButton*>(name); }

bool has_readings(StudioFixture& hand, std::size_t least) {
  const std::string name = "reading-" + std::to_string(least);
  bool found = false;  // each is a whole solid: a busy machine takes longer
  for (int k = 0; k < 4 && !found; ++k) found = hand.wait_for([&] { return button(hand, name.c_str()) != nullptr; });
  return found;
}

QString kind_of_inner(StudioFixture& hand) {
  const auto& data = hand.studio().drawing().strokes.at(1).data;
  const auto kind = data.find(silhouette::kind_key);
  return kind == data.end() ? QString() : QString::fromStdString(kind->second);
}

void draw_ring(StudioFixture& hand) {
  hand.window().set_unattended();
  hand.look_at({-150, -150}, {150, 150});
  hand.draw(circle(120));
  hand.draw(circle(70));
  hand.settle();
  hand.viewport().setFocus();
}

TEST_CASE("Tab shows other readings, and a click chooses one as one step", "[readings-strip]") {
  StudioFixture hand;
  draw_ring(hand);
  const std::size_t steps = hand.studio().session().undo_labels().size();
  QTest::keyClick(&hand.viewport(), Qt::Key_Tab);
  REQUIRE(has_readings(hand, 2));
  CHECK(button(hand, "reading-1")->isVisible());
  CHECK_FALSE(button(hand, "reading-2")->icon().isNull());
  hand.picture();
  const auto* strip = hand.viewport().findChild<QFrame*>("readings");
  CHECK(hand.viewport().pane(app::SketchView).rect.contains(QRectF(strip->geometry())));
  const QString words = button(hand, "reading-2")->toolTip();
  CHECK_FALSE(words.isEmpty());
  QTest::mouseClick(button(hand, "reading-2"), Qt::LeftButton);
  CHECK(hand.studio().session().undo_labels().size() == steps + 1);
  const QString chosen = kind_of_inner(hand);
  CHECK_FALSE(chosen.isEmpty());
  CHECK(hand.wait_for([&] { return button(hand, "reading-1") == nullptr; }));
  hand.settle();
  hand.act("undo");
  CHECK(kind_of_inner(hand).isEmpty());
  hand.act("redo");
  CHECK(kind_of_inner(hand) == chosen);
}

TEST_CASE("keys go through the readings, Return chooses and Escape closes", "[readings-strip]") {
  StudioFixture hand;
  draw_ring(hand);
  const std::size_t steps = hand.studio().session().undo_labels().size();
  QTest::keyClick(&hand.viewport(), Qt::Key_Tab);
  REQUIRE(has_readings(hand, 2));
  QTest::keyClick(button(hand, "reading-1"), Qt::Key_Escape);
  CHECK(hand.wait_for([&] { return button(hand, "reading-1") == nullptr; }));
  CHECK(hand.studio().session().undo_labels().size() == steps);

  QTest::keyClick(&hand.viewport(), Qt::Key_Tab);
  REQUIRE(has_readings(hand, 2));
  button(hand, "reading-1")->setFocus();
  QTest::keyClick(button(hand, "reading-1"), Qt::Key_Tab);
  CHECK(hand.window().focusWidget() == button(hand, "reading-2"));
  QTest::keyClick(button(hand, "reading-2"), Qt::Key_Return);
  CHECK(hand.studio().session().undo_labels().size() == steps + 1);
  CHECK_FALSE(kind_of_inner(hand).isEmpty());
}

TEST_CASE("without a sketch Tab goes to the next field", "[readings-strip]") {
  StudioFixture hand;
  hand.window().set_unattended();
  hand.viewport().setFocus();
  QTest::keyClick(&hand.viewport(), Qt::Key_Tab);
  CHECK(button(hand, "reading-1") == nullptr);
  CHECK_FALSE(hand.viewport().hasFocus());
}

}  // namespace
}  // namespace croquis::test
