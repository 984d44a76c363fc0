// SPDX-License-Identifier: GPL-3.0-or-later
// How long the studio's hands wait: a program of its own, since it needs a window.
#include <QApplication>
#include <QElapsedTimer>
#include <QProcess>
#include <QSurfaceFormat>
#include <QTemporaryFile>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <vector>

#include "app/studio_fixture.h"
#include "app/theme.h"
#include "support/sketch_gallery.h"

namespace {

using namespace croquis;
using app::Viewport;

struct Times {
  double median = 0;
  double p95 = 0;
};

Times spread(std::vector<double> ms) {
  std::sort(ms.begin(), ms.end());
  return {ms[ms.size() / 2], ms[ms.size() * 95 / 100]};
}

void print(const char* what, const Times& times, const char* remark) {
  std::printf("| %s | %.0f | %.0f | %s |\n", what, times.median, times.p95, remark);
}

double ms_until(test::StudioFixture& hand, const QElapsedTimer& watch, const std::function<bool()>& condition) {
  hand.wait_for(condition);
  return static_cast<double>(watch.nsecsElapsed()) * 1e-6;
}

/// The whole process, from its start to the first frame and a clean end.
Times start_up() {
  QTemporaryFile nothing;
  nothing.open();
  std::vector<double> ms;
  for (int run = 0; run < 7; ++run) {
    QElapsedTimer watch;
    watch.start();
    QProcess::execute(CROQUIS_STUDIO, {"--new", "silhouette", "--replay", nothing.fileName()});
    ms.push_back(static_cast<double>(watch.elapsed()));
  }
  return spread(ms);
}

struct StrokeTimes {
  std::vector<double> draft, settled;
};

/// From lifting the pen at a sketch's last stroke to its solid on screen.
StrokeTimes stroke_to_solid(const test::Sketch& sketch) {
  StrokeTimes times;
  for (int run = 0; run < 5; ++run) {
    test::StudioFixture hand;
    auto strokes = test::hand_strokes(sketch);
    hand.draw(sketch);
    hand.settle();
    hand.act("undo");
    hand.settle();
    const auto before = hand.studio().result();
    hand.begin_stroke(strokes.back());
    QElapsedTimer watch;
    watch.start();
    hand.end_stroke(strokes.back().back());
    times.draft.push_back(ms_until(hand, watch, [&] { return hand.studio().result() != before; }));
    times.settled.push_back(ms_until(hand, watch, [&] { return hand.studio().settled(); }));
  }
  return times;
}

/// An anchor is dragged in small steps; each waits for the solid that belongs to it.
Times drag_to_solid(const test::Sketch& sketch) {
  test::StudioFixture hand;
  hand.draw(sketch);
  hand.settle();
  hand.act("select-all");
  hand.act("select");
  const std::string name = hand.studio().drawing().strokes.front().id;
  const StrokeFit* fit = hand.viewport().tool().fit(name);
  const std::size_t anchor = fit->anchors.size() / 2;
  std::vector<double> ms;
  for (int step = 0; step < 20; ++step) {
    const auto before = hand.studio().result();
    QElapsedTimer watch;
    watch.start();
    hand.viewport().tool().drag(name, anchor, Vec2(step % 2 == 0 ? 1 : -1, 0));
    ms.push_back(ms_until(hand, watch, [&] { return hand.studio().result() != before; }));
    hand.settle();
  }
  return spread(ms);
}

/// From a pen event to the end of the frame that shows its ink.
Times event_to_frame() {
  test::StudioFixture hand;
  hand.draw(test::snake_sketch());
  hand.settle();
  std::vector<double> ms;
  hand.begin_stroke({{0, 0}});
  for (int k = 0; k < 200; ++k) {
    const int frames = hand.viewport().frames();
    hand.continue_stroke({30.0 * std::cos(0.1 * k), 30.0 * std::sin(0.1 * k)});
    hand.wait_for([&] { return hand.viewport().frames() > frames; });
    ms.push_back(hand.viewport().last_latency_ms());
  }
  return spread(ms);
}

}  // namespace

int main(int argc, char** argv) {
  QSurfaceFormat format;
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  QSurfaceFormat::setDefaultFormat(format);
  QApplication application(argc, argv);
  app::apply_theme(application);
  std::printf("## Studio: milliseconds, median and 95th percentile\n\n| what | median | p95 | |\n|---|---|---|---|\n");
  print("start-up", start_up(), "the whole process to its first frame and end");
  const test::Sketch chain = test::chain_sketch(5);
  for (const auto& [name, sketch] : {std::pair{"snake", test::snake_sketch()}, std::pair{"chain of 5", chain}}) {
    const StrokeTimes times = stroke_to_solid(sketch);
    print((std::string("stroke to draft, ") + name).c_str(), spread(times.draft), "");
    print((std::string("stroke to final, ") + name).c_str(), spread(times.settled), "");
  }
  print("drag to draft, chain of 5 (16 strokes)", drag_to_solid(chain), "");
  print("pen event to frame", event_to_frame(), "1440 x 900");
  return 0;
}
