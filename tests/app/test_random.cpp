// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever people do, in whatever order: the window goes on, and every state is reached again by undo and redo.
#include <QAction>
#include <QDialog>
#include <QMessageBox>
#include <QTest>
#include <QTimer>
#include <random>

#include <catch2/catch.hpp>

#include "app/hole_scans.h"
#include "app/views/marking_menu.h"
#include "croquis/document/content_hash.h"
#include "support/sample_count.h"
#include "support/sketches/sketch_gallery.h"

using namespace croquis;
using namespace croquis::test;

namespace {

constexpr int steps_each = 60;
constexpr std::size_t most_faces = 30'000;  // what makes more isn't done any more: that takes long

/// A hand that does anything with the window.
class AnyHand {
 public:
  AnyHand(StudioFixture& hand, unsigned seed) : hand_(hand), random_(seed) {
    hand_.window().set_unattended();
    QObject::connect(&closing_, &QTimer::timeout, [this] { close_questions(); });
    closing_.start(20);
  }

  void do_anything() {
    if (!hand_.window().shows_views()) app::show_views(hand_.window());
    switch (below(5)) {
      case 0: point(); break;
      case 1: draw(); break;
      default: act(); break;
    }
    close_questions();
    for (QDialog* dialog : hand_.window().findChildren<QDialog*>()) dialog->close();
    QApplication::processEvents();
  }

  const std::string& done() const { return done_; }
  int errors() const { return errors_; }

 private:
  int below(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }

  QPointF place() { return {1.0 * below(hand_.viewport().width()), 1.0 * below(hand_.viewport().height())}; }

  void act() {
    std::size_t faces = 0;
    for (const WorkObject& object : hand_.studio().objects())
      faces += object.shown() ? object.shown()->face_count() : 0;
    QList<QAction*> able;
    for (QAction* action : hand_.window().actions()) {
      const QString name = action->objectName();
      // Another document is begun now and then alone: the old one's history ends there.
      const bool begins = name.startsWith("new") || name == "start-page" || name == "help-examples";
      const bool goes_back = name == "undo" || name == "delete" || name == "new";
      if (!action->isEnabled() || !action->isVisible() || name == "quit" || name == "help-whats-this") continue;
      if ((faces < most_faces || goes_back) && (!begins || below(20) == 0)) able << action;
    }
    QAction* chosen = able[below(static_cast<int>(able.size()))];
    done_ += chosen->objectName().toStdString() + ' ';
    chosen->trigger();
  }

  /// A click or a drag, with any button.
  void point() {
    const QPointF from = place();
    const QPointF to = below(2) == 0 ? from : place();
    const Qt::MouseButton button = below(4) == 0 ? Qt::RightButton : Qt::LeftButton;
    const std::vector<Qt::KeyboardModifier> keys{Qt::NoModifier, Qt::ShiftModifier, Qt::ControlModifier,
                                                 Qt::AltModifier};
    const Qt::KeyboardModifier key = keys[static_cast<std::size_t>(below(4))];
    done_ += "mouse " + std::to_string(from.x()) + ',' + std::to_string(from.y()) + ' ';
    hand_.drag_pixels(from, to, button, key);
    hand_.viewport().marking_menu().dismiss();
  }

  void draw() {
    std::vector<Vec2> stroke;
    Vec2 at(below(400) - 200, below(400) - 200);
    Vec2 step(below(21) - 10, below(21) - 10);
    for (int i = 0; i < 30; ++i) {
      stroke.push_back(at);
      at += step;
      step = Eigen::Rotation2Dd(0.05 * below(8)) * step;
    }
    done_ += "stroke ";
    hand_.draw(stroke);
  }

  void close_questions() {
    if (QWidget* menu = QApplication::activePopupWidget()) menu->close();
    QWidget* asked = QApplication::activeModalWidget();
    if (asked == nullptr) return;
    const auto* message = qobject_cast<QMessageBox*>(asked);
    if (message != nullptr && message->icon() == QMessageBox::Critical) ++errors_;
    asked->close();
  }

  StudioFixture& hand_;
  std::mt19937 random_;
  QTimer closing_;
  std::string done_;
  int errors_ = 0;
};

/// Without drawing each state.
void trigger(StudioFixture& hand, const char* name) {
  QAction* action = hand.window().action(name);
  REQUIRE(action->isEnabled());
  action->trigger();
}

ContentHash hash_of(StudioFixture& hand) { return content_hash(hand.studio().session().document()); }

/// All states from the newest back to the first.
std::vector<ContentHash> undone(StudioFixture& hand) {
  std::vector<ContentHash> states{hash_of(hand)};
  while (hand.studio().session().can_undo()) {
    trigger(hand, "undo");
    states.push_back(hash_of(hand));
  }
  return states;
}

void check_there_and_back(StudioFixture& hand) {
  while (hand.studio().session().can_redo()) trigger(hand, "redo");
  const std::vector<ContentHash> states = undone(hand);
  for (auto state = states.rbegin() + 1; state != states.rend(); ++state) {
    trigger(hand, "redo");
    CHECK(hash_of(hand) == *state);
  }
  CHECK(!hand.studio().session().can_redo());
}

/// What is there can be saved, and opens as it is.
void check_saved(StudioFixture& hand) {
  const ContentHash done = hash_of(hand);
  const QString project = hand.folder() + "/random.croq";
  CHECK(hand.window().attempt([&] { hand.window().files().save(project); }));
  CHECK(hand.window().open(project));
  CHECK(hash_of(hand) == done);
}

void do_anything_with(const std::function<void(StudioFixture&)>& begin, unsigned first_seed) {
  const int seeds = sample_count(1, 5);
  const char* given = std::getenv("CROQUIS_SEEDS");  // to see one again: the first of them
  const unsigned first = given == nullptr ? first_seed : static_cast<unsigned>(std::atoi(given));
  for (unsigned seed = first; seed < first + static_cast<unsigned>(seeds); ++seed) {
    StudioFixture hand;
    AnyHand any(hand, seed);
    begin(hand);
    std::string findings;
    for (int step = 0; step < steps_each; ++step) {
      any.do_anything();
      for (const Finding& finding : hand.window().last_findings()) {
        INFO("seed " << seed << ": " << any.done() << ": " << finding.message);
        CHECK(finding.code != "E_INTERNAL");
      }
      if (step % 10 == 9) hand.settle();
    }
    INFO("seed " << seed << ": " << any.done());
    CHECK(any.errors() == 0);
    if (!hand.window().shows_views()) app::show_views(hand.window());
    check_there_and_back(hand);
    check_saved(hand);
  }
}

}  // namespace

TEST_CASE("anything can be done with a sketch", "[random]") {
  do_anything_with([](StudioFixture& hand) { hand.draw(linked_rings_sketch()); }, 100);
}

TEST_CASE("anything can be done with a drawing in perspective", "[random]") {
  do_anything_with(
      [](StudioFixture& hand) {
        hand.window().open(CROQUIS_SOURCE_DIR "/examples/data/perspective/soap.svg");
        hand.settle();
      },
      200);
}

TEST_CASE("anything can be done with a cage", "[random]") {
  do_anything_with(
      [](StudioFixture& hand) {
        hand.open_cage("cube_corner");
        hand.act("show-smooth");
        hand.act("face-mode");
        hand.act("select-all");
      },
      300);
}

TEST_CASE("anything can be done with a scan", "[random]") {
  do_anything_with([](StudioFixture& hand) { open_scan(hand, ball_with_holes(3)); }, 400);
}

TEST_CASE("anything can be done with a surface", "[random]") {
  do_anything_with(
      [](StudioFixture& hand) {
        hand.window().files().start_sample("bowl");
        app::show_views(hand.window());
        hand.settle();
      },
      500);
}
