// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/studio_waiting.h"

#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "app/studio_fixture.h"
#include "bench/statistics.h"
#include "bench/wavy_sheet.h"
#include "support/sketches/sketch_gallery.h"

namespace croquis::bench {
namespace {

constexpr int runs = 3;
constexpr double long_ms = 100;
constexpr int stroke_ms = 500;
constexpr int pause_ms = 300;  // between two strokes

/// The longest of one run.
struct Longest {
  double ms = 0, processor_ms = 0, handling_ms = 0;
  double count = 0;  ///< of those above 100 ms
};

/// Work of a hand between two looks at the clock. Tells by name what kept the window, where that was long.
Longest waits_during(WatchedApplication& application, const std::string& name, const std::function<void()>& work) {
  application.begin();
  work();
  Longest longest;
  for (const Wait& wait : application.waits()) {
    longest.ms = std::max(longest.ms, wait.ms);
    longest.processor_ms = std::max(longest.processor_ms, wait.processor_ms);
    longest.handling_ms = std::max(longest.handling_ms, wait.handling_ms);
    if (wait.ms <= long_ms) continue;
    ++longest.count;
    std::fprintf(stderr, "  %s: %.0f ms, %.0f of the processor, %.0f without pictures: %s\n", name.c_str(), wait.ms,
                 wait.processor_ms, wait.handling_ms, qPrintable(wait.longest));
  }
  return longest;
}

/// Everything that is measured, in the order of the first run.
class Table {
 public:
  explicit Table(WatchedApplication& application) : application_(application) {}

  void measure(const std::string& name, const std::function<void()>& work) {
    const Longest longest = waits_during(application_, name, work);
    const auto known = std::ranges::find(rows_, name, &Row::name);
    Row& row = known == rows_.end() ? rows_.emplace_back(Row{name, {}, {}, {}, {}}) : *known;
    row.ms.push_back(longest.ms);
    row.processor_ms.push_back(longest.processor_ms);
    row.handling_ms.push_back(longest.handling_ms);
    row.count.push_back(longest.count);
  }

  void print() const {
    std::printf("## Longest waits of the window's thread, milliseconds, medians of %d runs\n\n", runs);
    std::printf("| during | longest | its processor time | longest without pictures | above 100 ms |\n");
    std::printf("|---|---|---|---|---|\n");
    for (const Row& row : rows_) {
      std::printf("| %s | %.0f | %.0f | %.0f | %.0f |\n", row.name.c_str(), median(row.ms), median(row.processor_ms),
                  median(row.handling_ms), median(row.count));
    }
  }

 private:
  struct Row {
    std::string name;
    std::vector<double> ms, processor_ms, handling_ms, count;
  };

  WatchedApplication& application_;
  std::vector<Row> rows_;
};

void wait_settled(test::StudioFixture& hand) {
  hand.wait_for([&] { return hand.window().settled(); });
  QTest::qWait(pause_ms);
}

/// The start page with its pictures, until the last one is there.
void measure_start(Table& table) {
  const QTemporaryDir folder;
  app::MainWindow window(folder.path() + "/state");
  window.show();
  (void)QTest::qWaitForWindowExposed(&window);
  table.measure("start page", [&] {
    constexpr int patience_ms = 60'000;
    (void)QTest::qWaitFor([&] { return window.settled(); }, patience_ms);
  });
}

void draw_at_human_speed(test::StudioFixture& hand, const std::vector<Vec2>& stroke) {
  const int step_ms = std::max(1, stroke_ms / static_cast<int>(stroke.size()));
  hand.begin_stroke({stroke.front()});
  for (const Vec2& place : stroke) {
    hand.continue_stroke(place);
    QTest::qWait(step_ms);
  }
  hand.end_stroke(stroke.back());
  QTest::qWait(pause_ms);
}

void measure_strokes(Table& table, const std::string& name, const test::Sketch& sketch) {
  test::StudioFixture hand;
  hand.look_at({-250, -250}, {250, 250});
  table.measure(name, [&] {
    for (const auto& stroke : test::hand_strokes(sketch)) draw_at_human_speed(hand, stroke);
  });
  table.measure(name + ", until it is final", [&] { wait_settled(hand); });
}

void drag_box(test::StudioFixture& hand, double from, double to) {
  const QRectF view = hand.viewport().pane(app::Viewport::PerspectiveView).rect;
  const auto place = [&](double share) {
    return view.topLeft() + QPointF(share * view.width(), share * view.height());
  };
  hand.drag_pixels(place(from), place(to), Qt::LeftButton, Qt::NoModifier);
  QTest::qWait(pause_ms);
}

void measure_boxes(Table& table) {
  test::StudioFixture hand;
  hand.studio().add_mesh("sheet", std::make_shared<const PolyMesh>(wavy_sheet(150)));
  hand.act("frame-all");
  wait_settled(hand);
  for (const char* mode : {"vertex-mode", "edge-mode", "face-mode"}) {
    table.measure(std::string("22,500 faces, ") + mode, [&] {
      hand.act(mode);
      wait_settled(hand);
    });
    table.measure(std::string("box over 22,500 faces, ") + mode, [&] { drag_box(hand, 0.1, 0.9); });
    table.measure(std::string("smaller box, ") + mode, [&] { drag_box(hand, 0.4, 0.6); });
  }
}

void turn(test::StudioFixture& hand) {
  const QPointF middle = hand.viewport().pane(app::Viewport::PerspectiveView).rect.center();
  hand.drag_pixels(middle, middle + QPointF(120, 40), Qt::LeftButton, Qt::AltModifier);
  QTest::qWait(pause_ms);
}

void measure_subdivision(Table& table) {
  test::StudioFixture hand;
  hand.studio().add_mesh("sheet", std::make_shared<const PolyMesh>(wavy_sheet(141)));
  hand.act("frame-all");
  wait_settled(hand);
  table.measure("subdivided, 80,000 faces", [&] {
    hand.act("show-smooth");
    wait_settled(hand);
  });
  table.measure("subdivided, 320,000 faces", [&] {
    hand.act("finer");
    wait_settled(hand);
  });
  table.measure("first turn of it", [&] { turn(hand); });
  table.measure("second turn", [&] { turn(hand); });
  table.measure("click on it", [&] {
    hand.click_model({0, 0, 0}, app::Viewport::PerspectiveView);
    QTest::qWait(pause_ms);
  });
}

}  // namespace

void bench_waiting(WatchedApplication& application) {
  Table table(application);
  for (int run = 0; run < runs; ++run) {
    measure_start(table);
    measure_strokes(table, "strokes of a dog", test::dog_sketch());
    measure_strokes(table, "strokes of a chain", test::chain_sketch(5));
    measure_boxes(table);
    measure_subdivision(table);
  }
  table.print();
}

}  // namespace croquis::bench
