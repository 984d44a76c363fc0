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
#include "app/window/theme.h"
#include "bench/studio_waiting.h"
#include "bench/wavy_sheet.h"
#include "croquis/document/memo.h"
#include "croquis/io/mesh_file.h"
#include "croquis/operators/all_operations.h"
#include "support/sketches/sketch_gallery.h"

namespace {

using namespace croquis;
using app::Viewport;
using bench::wavy_sheet;

struct Times {
  double median = 0;
  double p95 = 0;
};

Times spread(std::vector<double> ms) {
  std::sort(ms.begin(), ms.end());
  return {ms[ms.size() / 2], ms[ms.size() * 95 / 100]};
}

void print(const std::string& what, const Times& times, const Times& peer) {
  std::printf("| %s | %.0f | %.0f | %.1f | %.2f |\n", what.c_str(), times.median, times.p95, peer.median,
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
    const int frames = hand.viewport().pictures().frames;
    QElapsedTimer watch;
    watch.start();
    app::frame_all(hand.viewport().views());
    ms.push_back(ms_until(hand, watch, [&] { return hand.viewport().pictures().frames > frames; }));
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
  const StrokeFit* fit = hand.sketch().tool().fit(hand.studio().drawing().strokes.front().id);
  const Vec2 anchor = fit->anchors[fit->anchors.size() / 2].position;
  const QPointF start = app::sketch_to_widget(hand.viewport().views(), anchor);
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
    const int frames = hand.viewport().pictures().frames;
    hand.continue_stroke({30.0 * std::cos(0.1 * k), 30.0 * std::sin(0.1 * k)});
    hand.wait_for([&] { return hand.viewport().pictures().frames > frames; });
    ms.push_back(hand.viewport().last_latency_ms());
  }
  print("pen event to frame, 1440 x 900 (a frame without news)", spread(ms), peer);
}

/// Peer of the drag: the operation alone, its plan at hand as it is while a point moves.
Times subdivide_again(const PolyMesh& cage) {
  const Registry registry = all_operations();
  Memo memo;
  std::vector<double> ms;
  for (int run = 0; run < 6; ++run) {
    auto moved = std::make_shared<PolyMesh>(cage);
    moved->positions[moved->vertex_count() / 2].z() += 0.1 * run;
    Progress progress;
    Context context{progress, Quality::Final, &memo};
    QElapsedTimer watch;
    watch.start();
    croquis::run(*registry.find("subdivide"), {{"cage", std::shared_ptr<const PolyMesh>(moved)}},
                 {{"levels", std::int64_t{2}}}, context);
    if (run > 0) ms.push_back(static_cast<double>(watch.nsecsElapsed()) * 1e-6);
  }
  return spread(ms);
}

/// One vertex of a cage of 10,000 faces is dragged at level 2; each move waits for the surface that belongs to it.
void drag_of_cage() {
  const PolyMesh cage = wavy_sheet(100);
  test::StudioFixture hand;
  hand.studio().add_mesh("sheet", std::make_shared<const PolyMesh>(cage));
  hand.act("show-both");
  hand.act("frame-all");
  hand.act("vertex-mode");
  hand.act("move");
  hand.settle();
  const Index vertex = static_cast<Index>(cage.vertex_count() / 2);
  hand.mesh().act([&](MeshTool& tool) { return tool.selection().pick(ComponentKind::Vertex, {vertex}); });
  const QPointF start =
      app::model_to_widget(hand.viewport().views(), cage.positions[vertex], Viewport::PerspectiveView);
  hand.send_mouse(QEvent::MouseButtonPress, start, Qt::LeftButton, Qt::NoModifier);
  std::vector<double> to_result, to_frame;
  for (int step = 0; step < 20; ++step) {
    const auto before = hand.studio().active()->mesh;
    const int frames = hand.viewport().pictures().frames;
    QElapsedTimer watch;
    watch.start();
    hand.send_mouse(QEvent::MouseMove, start - QPointF(0, 3 * (step + 1)), Qt::LeftButton, Qt::NoModifier);
    to_frame.push_back(ms_until(hand, watch, [&] { return hand.viewport().pictures().frames > frames; }));
    to_result.push_back(ms_until(hand, watch, [&] { return hand.studio().active()->mesh != before; }));
  }
  hand.send_mouse(QEvent::MouseButtonRelease, start, Qt::LeftButton, Qt::NoModifier);
  const Times peer = subdivide_again(cage);
  print("drag to surface, cage of 10,000 faces at level 2 (the operation alone)", spread(to_result), peer);
  print("drag to frame, the same (the operation alone)", spread(to_frame), peer);
}

/// From opening a mesh of a million faces to its first whole picture, and a click on it.
void million_faces() {
  Progress progress;
  const PolyMesh mesh = wavy_sheet(1000);
  QTemporaryFile file("XXXXXX.ply");
  file.open();
  const std::string bytes = write_mesh(mesh, MeshFormat::Ply, {}, progress).bytes;
  file.write(bytes.data(), static_cast<qint64>(bytes.size()));
  file.flush();
  QElapsedTimer alone;
  alone.start();
  read_mesh(bytes, MeshFormat::Ply, "sheet.ply", progress);
  const double reading = static_cast<double>(alone.nsecsElapsed()) * 1e-6;
  test::StudioFixture hand;
  QElapsedTimer watch;
  watch.start();
  app::begin_open(hand.window(), {file.fileName()});
  const double loaded = ms_until(hand, watch, [&] { return !hand.studio().objects().empty(); });
  const double shown = ms_until(hand, watch, [&] { return !hand.viewport().objects().surfaces().empty(); });
  const double whole = ms_until(hand, watch, [&] { return hand.window().settled(); });
  hand.act("face-mode");
  const Vec3 place = mesh.positions[mesh.vertex_count() / 2];
  std::vector<double> picks;
  for (int run = 0; run < 5; ++run) {
    QTest::qWait(700);  // two clicks soon after one another pick all that is connected
    watch.start();
    hand.click_model(place + Vec3(0.3 + run, 0.4, 0), Viewport::PerspectiveView);
    picks.push_back(static_cast<double>(watch.nsecsElapsed()) * 1e-6);
  }
  const Times peer{reading, reading};
  print("a million faces: read (the reader alone)", {loaded, loaded}, peer);
  print("a million faces: ready to be drawn (the reader alone)", {shown, shown}, peer);
  print("a million faces: first whole picture (the reader alone)", {whole, whole}, peer);
  print("a million faces: first click (later ones)", {picks.front(), picks.front()},
        spread({picks[1], picks[2], picks[3], picks[4]}));
}

/// A mesh of 320,000 faces is rotated by the mouse, each move after the picture of the one before.
void orbit() {
  test::StudioFixture hand;
  hand.studio().add_mesh("sheet", std::make_shared<const PolyMesh>(wavy_sheet(566)));
  hand.act("show-both");
  hand.act("frame-all");
  hand.settle();
  Viewport& viewport = hand.viewport();
  constexpr int view = Viewport::PerspectiveView;
  // Peer: pictures with every triangle, as they were while the camera moved before there were reduced surfaces.
  const Times peer = plain_frame(hand);
  hand.settle();
  const QPointF middle = viewport.pane(view).rect.center();
  hand.send_mouse(QEvent::MouseButtonPress, middle, Qt::LeftButton, Qt::AltModifier);
  std::vector<double> ms;
  for (int k = 0; k < 40; ++k) {
    const int frames = viewport.pictures().frames;
    QElapsedTimer watch;
    watch.start();
    hand.send_mouse(QEvent::MouseMove, middle + QPointF(6 * k + 6, 2 * k), Qt::LeftButton, Qt::AltModifier);
    ms.push_back(ms_until(hand, watch, [&] { return viewport.pictures().frames > frames; }));
  }
  const std::size_t drawn = viewport.pictures().state(view).triangles;
  hand.send_mouse(QEvent::MouseButtonRelease, middle, Qt::LeftButton, Qt::AltModifier);
  print("a picture while rotating 320,000 faces, " + std::to_string(drawn) + " triangles (all triangles drawn)",
        spread(ms), peer);
}

void bench_hands() {
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
  drag_of_cage();
  orbit();
  million_faces();
}

/// The same figures by a program built earlier, and by this one: both in processes of their own.
int compare(const QString& earlier, const QStringList& words) {
  std::printf("# By %s\n\n", qPrintable(earlier));
  std::fflush(stdout);
  const int failed = QProcess::execute(earlier, words);
  std::printf("# By this program\n\n");
  std::fflush(stdout);
  return failed + QProcess::execute(QCoreApplication::applicationFilePath(), words);
}

}  // namespace

/// [--against PROGRAM] [hands] [waiting] [memory] [SEED …]
int main(int argc, char** argv) {
  QSurfaceFormat format;
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  QSurfaceFormat::setDefaultFormat(format);
  bench::WatchedApplication application(argc, argv);
  app::apply_theme(application);
  QStringList words = QApplication::arguments().mid(1);
  if (words.size() > 1 && words.front() == "--against") return compare(words[1], words.mid(2));
  if (words.isEmpty()) words = QStringList{"hands", "waiting", "memory"};
  if (words.contains("hands")) bench_hands();
  if (words.contains("waiting")) bench::bench_waiting(application);
  if (words.contains("memory")) bench::bench_memory(words.back().toULongLong());
  return 0;
}
