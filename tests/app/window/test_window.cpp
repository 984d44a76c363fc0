// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QMenu>
#include <QProcess>
#include <QPushButton>
#include <QScreen>
#include <QSettings>
#include <QStatusBar>
#include <QTest>
#include <QToolBar>
#include <QToolButton>
#include <chrono>
#include <ctime>
#include <future>

#include <catch2/catch.hpp>

#include "app/dialogs.h"
#include "app/readable.h"
#include "app/start/start_page.h"
#include "app/studio_fixture.h"
#include "app/views/offscreen_pictures.h"
#include "app/window/help_line.h"
#include "croquis/document/content_hash.h"
#include "support/meshes/mesh_shapes.h"
#include "support/sketches/sketch_gallery.h"

using namespace croquis;
using namespace croquis::test;

namespace {

QDockWidget* dock(app::MainWindow& window, const char* name) { return window.findChild<QDockWidget*>(name); }

ContentHash hash_of(StudioFixture& hand) { return content_hash(hand.studio().session().document()); }

/// What a menu's row differs from its background, summed over its pixels.
double ink_of(const QImage& picture, const QRect& row) {
  const QColor background = picture.pixelColor(row.right() - 2, row.center().y());
  double ink = 0;
  for (int y = row.top(); y <= row.bottom(); ++y) {
    for (int x = row.left(); x <= row.right(); ++x) {
      ink += std::abs(picture.pixelColor(x, y).lightnessF() - background.lightnessF());
    }
  }
  return ink;
}

constexpr int kathmandu_offset = (5 * 60 + 45) * 60;  // seconds

/// The time zone of the process; the earlier one again at the end.
class TimeZone {
 public:
  explicit TimeZone(const char* name) : had_(qEnvironmentVariableIsSet("TZ")), before_(qgetenv("TZ")) {
    qputenv("TZ", name);
    tzset();
  }
  ~TimeZone() {
    had_ ? qputenv("TZ", before_) : qunsetenv("TZ");
    tzset();
  }
  TimeZone(const TimeZone&) = delete;
  TimeZone& operator=(const TimeZone&) = delete;

 private:
  bool had_;
  QByteArray before_;
};

}  // namespace

TEST_CASE("the start page has a way back, and nothing acts on what it hides", "[start-page]") {
  StudioFixture hand;
  hand.draw(linked_rings_sketch());
  hand.settle();
  const ContentHash drawn = hash_of(hand);
  const std::size_t steps = hand.studio().session().undo_labels().size();
  auto& window = hand.window();
  auto* back = window.findChild<QPushButton*>("back");
  const std::vector<std::function<void()>> ways{[&] { back->click(); }, [&] { hand.act("start-page"); },
                                                [&] { QTest::keyClick(&window, Qt::Key_Escape); },
                                                [&] { QTest::keyClick(window.focusWidget(), Qt::Key_Escape); }};
  for (const auto& go_back : ways) {
    hand.act("start-page");
    REQUIRE(!window.shows_views());
    CHECK(back->isVisible());
    for (const QAction* action : window.actions()) {
      INFO(action->objectName().toStdString());
      const QStringList free{"new",  "new-perspective", "new-surface", "open",       "import", "start-page",
                             "quit", "reset-layout",    "palette",     "preferences"};
      const bool helps = action->objectName().startsWith("help");
      CHECK(action->isEnabled() == (helps || free.contains(action->objectName())));
    }
    QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier);
    QTest::keyClick(&window, Qt::Key_Z);
    QTest::keyClick(&window, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClick(&window, Qt::Key_Delete);
    CHECK(hand.studio().session().undo_labels().size() == steps);
    go_back();
    QApplication::processEvents();
    if (!window.shows_views()) back->click();
    CHECK(window.shows_views());
    CHECK(hash_of(hand) == drawn);
    CHECK(window.action("undo")->isEnabled());
    CHECK(!window.action("redo")->isEnabled());
    CHECK(dock(window, "objects-dock")->isVisible());
  }
}

TEST_CASE("the first start page has nothing to go back to", "[start-page]") {
  const QTemporaryDir folder;
  app::MainWindow window(folder.path());
  window.show();
  CHECK(!window.shows_views());
  CHECK(!window.findChild<QPushButton*>("back")->isVisible());
  window.action("start-page")->trigger();
  CHECK(!window.shows_views());
}

TEST_CASE("new and recovered work never takes the place of unsaved work without a question", "[start-page]") {
  StudioFixture hand;
  hand.draw(linked_rings_sketch());
  hand.crash_and_restart();
  hand.window().start_with();
  hand.settle();
  draw_ring(hand);
  const ContentHash drawn = hash_of(hand);
  int asked = 0;
  const auto cancel = [&](QMessageBox& question) {
    ++asked;
    question.button(QMessageBox::Cancel)->click();
  };
  for (const char* button : {"new-sketch", "recover", "sketch-chain"}) {
    INFO(button);
    if (hand.window().shows_views()) hand.act("start-page");
    const int before = asked;
    in_dialog<QMessageBox>(cancel);
    auto* wanted = hand.window().findChild<QAbstractButton*>(button);
    REQUIRE(wanted != nullptr);
    wanted->click();
    CHECK(asked == before + 1);
    CHECK(hash_of(hand) == drawn);
  }
}

TEST_CASE("work of several crashes is listed with local times and discarded at once", "[start-page]") {
  StudioFixture hand;
  for (int crash = 0; crash < 3; ++crash) {
    if (crash > 0) hand.window().start_with();
    hand.settle();
    draw_ring(hand);
    REQUIRE(hand.studio().session().modified());
    hand.crash_and_restart();
  }
  auto* page = hand.window().findChild<app::StartPage*>("start-page");
  const auto cards = page->findChildren<QLabel*>("recovery-text");
  REQUIRE(cards.size() == 3);
  const QString today = QLocale().toString(QDate::currentDate(), QLocale::ShortFormat);
  for (const QLabel* card : cards) {
    INFO(card->text().toStdString());
    CHECK(card->text().contains(today));
    CHECK(!card->text().contains("Z"));
  }
  page->findChild<QPushButton*>("discard-all")->click();
  CHECK(hand.window().files().recoverable().empty());
  CHECK(page->findChildren<QLabel*>("recovery-text").isEmpty());
}

TEST_CASE("cards of unsaved work show the time of the place, and are discarded one by one", "[start-page]") {
  const TimeZone kathmandu("Asia/Kathmandu");
  REQUIRE(QDateTime::currentDateTime().offsetFromUtc() == kathmandu_offset);
  StudioFixture hand;
  const QDateTime before = QDateTime::currentDateTimeUtc().addSecs(-1);
  for (int crash = 0; crash < 3; ++crash) {
    if (crash > 0) hand.window().start_with();
    hand.settle();
    draw_ring(hand);
    hand.crash_and_restart();
  }
  const auto left = [&] {
    QStringList files;
    for (const app::RecoveryOffer& offer : hand.window().files().recoverable()) files << offer.file;
    return files;
  };
  auto* page = hand.window().findChild<app::StartPage*>("start-page");
  const auto texts = [&] {
    QStringList found;
    for (const QLabel* card : page->findChildren<QLabel*>("recovery-text")) found << card->text();
    return found;
  };
  const auto offers = hand.window().files().recoverable();
  const QStringList shown = texts();
  REQUIRE(offers.size() == 3);
  REQUIRE(shown.size() == 3);
  for (int card = 0; card < 3; ++card) {
    const QDateTime made = offers[static_cast<std::size_t>(card)].time.toUTC();
    CHECK(made >= before);
    CHECK(made <= QDateTime::currentDateTimeUtc());
    const auto words = [](const QDateTime& time) { return QLocale().toString(time, QLocale::ShortFormat); };
    INFO(shown[card].toStdString());
    CHECK(shown[card].contains(words(made.addSecs(kathmandu_offset))));
    CHECK(!shown[card].contains(words(made)));
  }
  QStringList files = left();
  QStringList expected = shown;
  for (const int place : {1, 1, 0}) {
    const auto buttons = page->findChildren<QPushButton*>("discard");
    REQUIRE(buttons.size() == files.size());
    QTest::mouseClick(buttons[place], Qt::LeftButton);
    files.removeAt(place);
    expected.removeAt(place);
    CHECK(left() == files);
    CHECK(texts() == expected);
  }
}

TEST_CASE("a new sketch has the pen in the hand, whatever was in it before", "[window]") {
  for (const char* tool : {"erase", "select", "move", "rotate", "scale", "sharpen"}) {
    INFO(tool);
    StudioFixture hand;
    const bool of_meshes = QString(tool) != "erase";
    if (of_meshes) hand.open_cage("mug");
    hand.act(tool);
    hand.act("new");
    CHECK(hand.viewport().views().mode == app::first_mode);
    CHECK(hand.window().action("draw")->isChecked());
    CHECK(hand.viewport().pane(app::Viewport::SketchView).visible());
    draw_ring(hand);
    CHECK(hand.studio().drawing().strokes.size() == 1);
  }
}

TEST_CASE("the window fits into the screen, whatever the scale", "[window]") {
  for (const char* scale : {"1", "1.25", "1.5"}) {
    const QTemporaryDir folder;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("QT_SCALE_FACTOR", scale);
    environment.insert("XDG_STATE_HOME", folder.path());
    QProcess process;
    process.setProcessEnvironment(environment);
    process.start(CROQUIS_STUDIO, {"--new", "silhouette", "--screenshot", folder.filePath("window.png")});
    REQUIRE(process.waitForFinished(60'000));
    const QImage picture(folder.filePath("window.png"));
    const QSize screen =
        QGuiApplication::primaryScreen()->size() * QGuiApplication::primaryScreen()->devicePixelRatio();
    INFO(scale << " " << picture.width() << " x " << picture.height());
    CHECK(picture.width() > 1000);
    // Points that are no whole pixels are rounded, by one pixel at most.
    CHECK(picture.width() <= screen.width() + 1);
    CHECK(picture.height() <= screen.height() + 1);
  }
}

TEST_CASE("nothing is clipped in a small window", "[small-window]") {
  constexpr QSize small(1024, 640);
  StudioFixture hand;
  auto& window = hand.window();
  const auto check = [&](const char* state) {
    window.resize(small);
    QApplication::processEvents();
    QApplication::processEvents();
    INFO(state);
    CHECK(window.size() == small);
    check_not_clipped<QPushButton>(window);
    check_not_clipped<QToolButton>(window);
    check_not_clipped<QComboBox>(window);
    for (const auto* more : window.findChildren<QToolButton*>("qt_toolbar_ext_button")) CHECK(!more->isVisible());
  };
  check("sketch");
  hand.act("start-page");
  check("start page");
  hand.open_cage("mug");
  check("cage");
  hand.act("show-smooth");
  hand.settle();
  check("smooth");
  hand.window().open(CROQUIS_SOURCE_DIR "/examples/data/pumpkin_scan.ply");
  hand.act("holes");
  hand.settle();
  check("holes");
}

TEST_CASE("panels are closed, come back, and the layout is remembered until it is reset", "[window]") {
  QSettings().clear();
  const QTemporaryDir folder;
  const auto open_window = [&] {
    auto window = std::make_unique<app::MainWindow>(folder.path());
    window->set_unattended();
    app::remember_layout(*window);
    window->show();
    (void)QTest::qWaitForWindowExposed(window.get());
    window->start_with();
    QApplication::processEvents();
    return window;
  };
  auto window = open_window();
  const QSize first = window->size();
  dock(*window, "history-dock")->close();
  CHECK(!window->action("panel-history")->isChecked());
  window->resize(1180, 720);
  window->viewport().views().layout.set_shares({0.3, 0.6});
  window->resizeDocks({dock(*window, "objects-dock")}, {380}, Qt::Horizontal);
  QApplication::processEvents();
  const int width = dock(*window, "objects-dock")->width();
  CHECK(width > 340);
  window->action("start-page")->trigger();
  window->action("start-page")->trigger();
  CHECK(!dock(*window, "history-dock")->isVisible());
  CHECK(dock(*window, "objects-dock")->width() == width);
  window->close();

  window = open_window();
  CHECK(window->size() == QSize(1180, 720));
  CHECK(!dock(*window, "history-dock")->isVisible());
  CHECK(dock(*window, "objects-dock")->isVisible());
  CHECK(std::abs(dock(*window, "objects-dock")->width() - width) <= 2);
  CHECK(window->viewport().views().layout.shares() == QPointF(0.3, 0.6));
  window->action("panel-history")->trigger();
  CHECK(dock(*window, "history-dock")->isVisible());
  dock(*window, "findings-dock")->close();
  window->action("reset-layout")->trigger();
  QApplication::processEvents();
  CHECK(window->size() == first);
  CHECK(window->viewport().views().layout.shares() == QPointF(0.5, 0.5));
  for (const char* name : {"objects-dock", "attributes-dock", "findings-dock", "history-dock"}) {
    CHECK(dock(*window, name)->isVisible());
  }
  window->close();
  QSettings().clear();
}

TEST_CASE("a sentence that doesn't fit ends in dots and is whole under the pointer", "[window]") {
  StudioFixture hand;
  auto* line = hand.window().findChild<app::HelpLine*>();
  auto* help = hand.window().findChild<app::ElidedLabel*>("help-line");
  auto* message = hand.window().findChild<app::ElidedLabel*>("message");
  const QString longest = QString("every word of this counts ").repeated(12).trimmed();
  for (const int width : {1024, 1120, 1400}) {
    hand.window().resize(width, 640);
    line->clear();
    line->show_help(longest);
    QApplication::processEvents();
    CHECK(help->seen().endsWith("…"));
    CHECK(help->toolTip() == longest);
    CHECK(help->geometry().right() < line->width());
    line->say(longest);
    QApplication::processEvents();
    CHECK(!help->isVisible());
    CHECK(message->seen().endsWith("…"));
    CHECK(message->toolTip() == longest);
    line->show_help("short");
    line->say("shorter");
    QApplication::processEvents();
    CHECK(help->seen() == "short");
    CHECK(message->seen() == "shorter");
    CHECK(help->isVisible());
  }
}

TEST_CASE("disabled entries of menus are fainter than enabled ones", "[window]") {
  QMenu menu;
  const QAction* enabled = menu.addAction("Export picture");
  QAction* disabled = menu.addAction("Export picture");
  disabled->setEnabled(false);
  menu.ensurePolished();
  menu.resize(menu.sizeHint());
  const QImage picture = menu.grab().toImage();
  const double plain = ink_of(picture, menu.actionGeometry(const_cast<QAction*>(enabled)));
  const double faint = ink_of(picture, menu.actionGeometry(disabled));
  INFO(plain << " " << faint);
  CHECK(plain > 0);
  CHECK(faint > 0);
  CHECK(faint < 0.6 * plain);
}

TEST_CASE("pictures without a window are drawn while the window's thread is held up", "[pictures]") {
  app::OffscreenPictures pictures;
  const std::vector<render::Shown<render::MeshItem>> items{render::make_mesh_item(test::cube())};
  const auto drawn = [&] { return pictures.draw_small(items, render::NamedView::Perspective, {64, 48}); };
  std::future<QImage> other = std::async(std::launch::async, drawn);
  REQUIRE(other.wait_for(std::chrono::seconds(10)) == std::future_status::ready);  // no event is handled meanwhile
  const QImage picture = other.get();
  CHECK(picture.size() == QSize(64, 48));
  CHECK(picture.pixelColor(32, 24) != picture.pixelColor(0, 24));
  CHECK(drawn() == picture);
}

// Mesa's software driver of Debian 12 looks into the frames of every context on a display, also those of other threads.
TEST_CASE("pictures without a window are drawn beside the views", "[pictures]") {
  StudioFixture hand;
  hand.open_cage("mug");
  app::OffscreenPictures pictures;
  const std::vector<render::Shown<render::MeshItem>> items{render::make_mesh_item(test::uv_sphere(24, 16))};
  const auto drawn = [&] { return pictures.draw_small(items, render::NamedView::Perspective, {320, 240}); };
  const QImage expected = drawn();
  std::future<int> others = std::async(std::launch::async, [&] {
    int same = 0;
    for (int k = 0; k < 40; ++k) same += drawn() == expected ? 1 : 0;
    return same;
  });
  const QPointF middle = hand.viewport().pane(app::PerspectiveView).rect.center();
  for (int k = 0; others.wait_for(std::chrono::seconds(0)) != std::future_status::ready; ++k) {
    hand.drag_pixels(middle, middle + QPointF(k % 2 == 0 ? 40 : -40, 0), Qt::LeftButton, Qt::AltModifier);
    QTest::qWait(1);
  }
  CHECK(others.get() == 40);
}

TEST_CASE("a new sketch frees what the old one took", "[window]") {
  StudioFixture hand;
  hand.open_cage("mug");
  hand.act("show-smooth");
  hand.settle();
  std::vector<std::weak_ptr<const PolyMesh>> meshes;
  for (const WorkObject& object : hand.studio().objects()) {
    meshes.emplace_back(object.cage_mesh);
    meshes.emplace_back(object.mesh);
  }
  REQUIRE(meshes.size() == 2);
  CHECK(!meshes[0].expired());
  CHECK(hand.studio().evaluator().bytes() > 0);
  hand.studio().session().mark_saved();
  hand.act("new");
  hand.settle();
  CHECK(hand.studio().session().history_bytes() == 0);
  CHECK(hand.studio().evaluator().bytes() == 0);
  CHECK(hand.wait_for([&] { return meshes[0].expired() && meshes[1].expired(); }));
}

TEST_CASE("undo and results share one cap", "[window]") {
  CHECK(app::Studio::history_cap < app::Studio::memory_cap);
  StudioFixture hand;
  hand.open_cage("mug");
  hand.act("show-smooth");
  hand.settle();
  // Steps that each keep a large mesh alive leave less room for results.
  const auto large = [](double x) {
    auto mesh = std::make_shared<PolyMesh>();
    mesh->positions.reserve(12'000'000);  // counts, and isn't touched
    mesh->positions.emplace_back(x, 0, 0);
    return Value(std::shared_ptr<const PolyMesh>(mesh));
  };
  const std::size_t bytes_each = 12'000'000 * sizeof(Vec3);
  Session& session = hand.studio().session();
  Node node;
  node.name = "large";
  node.visible = false;
  node.source = large(0);
  session.edit("Add", session.document().with(node));
  node.id = session.document().nodes().back()->id;
  for (int step = 1; step <= 4; ++step) {
    node.source = large(step);
    session.edit("Change", session.document().with(node));
    CHECK(session.history_bytes() + hand.studio().evaluator().bytes() <= app::Studio::memory_cap);
    CHECK(session.history_bytes() <= app::Studio::history_cap);
  }
  CHECK(session.history_bytes() / bytes_each == app::Studio::history_cap / bytes_each);
}
