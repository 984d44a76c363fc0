// SPDX-License-Identifier: GPL-3.0-or-later
// How long the studio's hands wait: a program of its own, since it needs a window.
#include <QApplication>
#include <QElapsedTimer>
#include <QProcess>
#include <QSurfaceFormat>
#include <QTemporaryFile>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/studio_fixture.h"
#include "app/theme.h"
#include "croquis/operators/all_operations.h"
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

void print(const std::string& what, const Times& times, const Times& peer) {
  std::printf("| %s | %.0f | %.0f | %.1f | %.1f |\n", what.c_str(), times.median, times.p95, peer.median,
              times.median / peer.median);
}

double ms_until(test::StudioFixture& hand, const QElapsedTimer& watch, const std::function<bool()>& condition) {
  hand.wait_for(condition);
  return static_cast<double>(watch.nsecsElapsed()) * 1e-6;
}

/// A whole process, from its start to its end.
Times process(const QStringList& arguments) {
  std::vector<double> ms;
  for (int run = 0; run < 7; ++run) {
    QProcess program;
    program.setStandardOutputFile(QProcess::nullDevice());
    QElapsedTimer watch;
    watch.start();
    program.start(CROQUIS_STUDIO, arguments);
    program.waitForFinished();
    ms.push_back(static_cast<double>(watch.nsecsElapsed()) * 1e-6);
  }
  return spread(ms);
}

/// Peer of everything that waits for a solid: the operation alone, without window, threads and caches.
Times operation_alone(const test::Sketch& sketch, Quality quality) {
  const Registry registry = all_operations();
  const Values inputs{{"drawing", std::make_shared<const Drawing>(sketch.drawing)}};
  std::vector<double> ms;
  for (int run = 0; run < 5; ++run) {
    Progress progress;
    Context context{progress, quality};
    QElapsedTimer watch;
    watch.start();
    croquis::run(*registry.find("inflate"), inputs, {}, context);
    ms.push_back(static_cast<double>(watch.nsecsElapsed()) * 1e-6);
  }
  return spread(ms);
}

/// Peer of a pen event's frame: a frame that shows nothing new.
Times plain_frame(test::StudioFixture& hand) {
  std::vector<double> ms;
  for (int run = 0; run < 50; ++run) {
    const int frames = hand.viewport().frames();
    QElapsedTimer watch;
    watch.start();
    hand.viewport().frame_all();
    ms.push_back(ms_until(hand, watch, [&] { return hand.viewport().frames() > frames; }));
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
    // Never the same line twice: what was made of it before would be shown at once.
    for (Vec2& place : strokes.back()) place += Vec2(0.2 * (run + 1), 0.1 * (run + 1));
    hand.draw(sketch);
    hand.settle();
    hand.act("undo");
    hand.settle();
    QTest::qWait(400);  // a hand draws one line after the other, not all at once
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

/// An anchor is dragged by the mouse; each move waits for the draft that belongs to it.
Times drag_to_solid(const test::Sketch& sketch) {
  test::StudioFixture hand;
  hand.draw(sketch);
  hand.settle();
  hand.act("select-all");
  hand.act("select");
  const StrokeFit* fit = hand.viewport().tool().fit(hand.studio().drawing().strokes.front().id);
  const Vec2 anchor = fit->anchors[fit->anchors.size() / 2].position;
  const QPointF start = hand.viewport().sketch_to_widget(anchor);
  hand.send_mouse(QEvent::MouseButtonPress, start, Qt::LeftButton, Qt::NoModifier);
  hand.send_mouse(QEvent::MouseMove, start + QPointF(6, 0), Qt::LeftButton, Qt::NoModifier);
  hand.settle();
  std::vector<double> ms;
  for (int step = 0; step < 30; ++step) {
    const auto before = hand.studio().result();
    const QPointF place = start + QPointF(6 + 0.25 * (step + 1), 0);
    QElapsedTimer watch;
    watch.start();
    hand.send_mouse(QEvent::MouseMove, place, Qt::LeftButton, Qt::NoModifier);
    ms.push_back(ms_until(hand, watch, [&] { return hand.studio().result() != before; }));
  }
  hand.send_mouse(QEvent::MouseButtonRelease, start, Qt::LeftButton, Qt::NoModifier);
  return spread(ms);
}

/// From a pen event to the end of the frame that shows its ink.
void event_to_frame() {
  test::StudioFixture hand;
  hand.draw(test::snake_sketch());
  hand.settle();
  const Times peer = plain_frame(hand);
  std::vector<double> ms;
  hand.begin_stroke({{0, 0}});
  for (int k = 0; k < 200; ++k) {
    const int frames = hand.viewport().frames();
    hand.continue_stroke({30.0 * std::cos(0.1 * k), 30.0 * std::sin(0.1 * k)});
    hand.wait_for([&] { return hand.viewport().frames() > frames; });
    ms.push_back(hand.viewport().last_latency_ms());
  }
  print("pen event to frame, 1440 x 900 (a frame without news)", spread(ms), peer);
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
  std::printf("## Studio: milliseconds; peers in brackets\n\n| what | median | p95 | peer | ratio |\n");
  std::printf("|---|---|---|---|---|\n");
  QTemporaryFile nothing;
  nothing.open();
  print("start-up to the first frame, and the end (--version)",
        process({"--new", "silhouette", "--replay", nothing.fileName()}), process({"--version"}));
  const test::Sketch chain = test::chain_sketch(5);
  for (const auto& [name, sketch] : {std::pair{"snake", test::snake_sketch()}, std::pair{"chain of 5", chain}}) {
    const StrokeTimes times = stroke_to_solid(sketch);
    print(std::string("stroke to draft, ") + name + " (the operation alone)", spread(times.draft),
          operation_alone(sketch, Quality::Draft));
    print(std::string("stroke to final, ") + name + " (the operation alone)", spread(times.settled),
          operation_alone(sketch, Quality::Final));
  }
  print("drag to draft, chain of 5, 16 strokes (the operation alone)", drag_to_solid(chain),
        operation_alone(chain, Quality::Draft));
  event_to_frame();
  return 0;
}
