// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QTest>
#include <QTimer>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <vector>

#include <malloc.h>

#include "app/studio_fixture.h"
#include "bench/peak_memory.h"
#include "bench/studio_waiting.h"
#include "support/random.h"
#include "support/sketches/sketch_gallery.h"

namespace croquis::bench {
namespace {

constexpr int half = 400;
constexpr int pause_ms = 100;  // results of an event are computed until the next one

const char* const keys[] = {"D",      "Q",      "X",       "W",     "E",      "R",      "S",          "1",
                            "2",      "3",      "4",       "5",     "6",      "F",      "A",          "H",
                            "P",      "J",      "F8",      "F9",    "F10",    "F11",    "PgUp",       "PgDown",
                            "Delete", "Escape", "Return",  "Space", "Ctrl+A", "Ctrl+Z", "Ctrl+Z",     "Ctrl+Shift+Z",
                            "Ctrl+D", "Ctrl+I", "Shift+E", "I",     "L",      "O",      "Shift+Space"};

/// What opens, saves, leaves, or begins anew.
bool is_about_files(const QString& action) {
  return action.startsWith("new") || action.startsWith("open") || action.startsWith("save") ||
         action.startsWith("export") || action == "quit" || action == "start-page" || action.startsWith("panel-");
}

class RandomHand {
  template <class Choices>
  auto one_of(const Choices& choices) {
    return choices[random_.below(static_cast<std::uint32_t>(std::size(choices)))];
  }

 public:
  RandomHand(test::StudioFixture& hand, std::uint64_t seed) : hand_(hand), random_(seed) {
    for (QAction* action : hand.window().actions()) {
      if (!is_about_files(action->objectName())) actions_.push_back(action);
    }
  }

  void act() {
    const double kind = random_.unit();
    if (kind < 0.25) {
      draw();
    } else if (kind < 0.6) {
      drag();
    } else if (kind < 0.85) {
      QTest::keySequence(&hand_.viewport(), QKeySequence(QString(one_of(keys))));
    } else {
      QAction* action = one_of(actions_);
      if (action->isEnabled()) action->trigger();
    }
    QTest::qWait(pause_ms);
  }

 private:
  QPointF place() {
    return {random_.between(0, hand_.viewport().width()), random_.between(0, hand_.viewport().height())};
  }

  void draw() {
    std::vector<Vec2> places;
    const Vec2 middle(random_.between(-200, 200), random_.between(-200, 200));
    const double radius = random_.between(20, 120);
    const double turn = random_.unit() < 0.5 ? 6.3 : random_.between(2, 6);
    for (double angle = 0; angle < turn; angle += 0.15) {
      places.push_back(middle + radius * Vec2(std::cos(angle), 0.8 * std::sin(angle)));
    }
    hand_.draw(places);
  }

  void drag() {
    constexpr Qt::MouseButton buttons[] = {Qt::LeftButton, Qt::LeftButton, Qt::LeftButton, Qt::MiddleButton,
                                           Qt::RightButton};
    constexpr Qt::KeyboardModifier modifiers[] = {Qt::NoModifier,  Qt::NoModifier,    Qt::NoModifier,
                                                  Qt::AltModifier, Qt::ShiftModifier, Qt::ControlModifier};
    const QPointF from = place();
    const QPointF to = random_.unit() < 0.3 ? from : place();
    hand_.drag_pixels(from, to, one_of(buttons), one_of(modifiers));
  }

  test::StudioFixture& hand_;
  test::Random random_;
  std::vector<QAction*> actions_;
};

double mebibytes(std::size_t bytes) { return static_cast<double>(bytes) / (1 << 20); }

void print_memory(const char* when, test::StudioFixture& hand) {
  hand.wait_for([&] { return hand.window().settled(); });
  const auto allocated = mallinfo2();
  const auto& studio = hand.studio();
  std::printf("| %s | %.0f | %.0f | %.0f | %.0f | %.0f |\n", when, PeakMemory::mebibytes("VmRSS:"),
              PeakMemory::mebibytes("VmHWM:"), mebibytes(allocated.uordblks + allocated.hblkhd),
              mebibytes(studio.result_bytes()), mebibytes(studio.session().history_bytes()));
  std::fflush(stdout);
}

}  // namespace

void bench_memory(std::uint64_t seed) {
  std::printf("## Memory of random events, MiB, seed %llu\n\n", static_cast<unsigned long long>(seed));
  std::printf("| after | resident | at most | allocated | kept results | history |\n|---|---|---|---|---|---|\n");
  // Whatever asks is sent away.
  QTimer closes;
  QObject::connect(&closes, &QTimer::timeout, [] {
    if (QWidget* asked = QApplication::activeModalWidget()) asked->close();
    if (QWidget* menu = QApplication::activePopupWidget()) menu->close();
  });
  closes.start(pause_ms / 2);
  test::StudioFixture hand;
  hand.window().set_unattended();
  print_memory("opening the window", hand);
  hand.draw(test::dog_sketch());
  hand.open_cage("mug");
  print_memory("a dog and a mug", hand);
  RandomHand random(hand, seed);
  for (int event = 1; event <= 2 * half; ++event) {
    random.act();
    if (event % half == 0) print_memory(event == half ? "400 events" : "800 events", hand);
  }
}

}  // namespace croquis::bench
