// SPDX-License-Identifier: GPL-3.0-or-later
// Where the window lies on its screen, what it keeps of that, and what can be read where it is small.
#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QProcess>
#include <QScreen>
#include <QSettings>
#include <QTabBar>
#include <QTest>
#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>

#include <xcb/xcb.h>

#include <catch2/catch.hpp>

#include "app/hand_on_meshes.h"
#include "app/hole_scans.h"
#include "app/readable.h"
#include "app/window/language.h"
#include "app/window/panel_docks.h"

using namespace croquis;
using namespace croquis::test;

namespace {

void check_inside_of_screen(const QWidget& window, const char* state) {
  QApplication::processEvents();
  QApplication::processEvents();
  const QRect free = window.screen()->availableGeometry();
  const QRect outer = window.frameGeometry();
  INFO(state << ": " << outer.width() << " x " << outer.height() << " at " << outer.left() << ", " << outer.top());
  INFO("in " << free.width() << " x " << free.height());
  CHECK(free.contains(outer));
}

/// An answer of the X server, or null.
template <typename Reply>
std::unique_ptr<Reply, decltype(&std::free)> owned(Reply* reply) {
  return {reply, &std::free};
}

/// The real program, attended, with settings and a state of its own; its window as the X server has it.
class AttendedStudio {
 public:
  explicit AttendedStudio(const QString& folder) : connection_(xcb_connect(nullptr, nullptr)) {
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("XDG_CONFIG_HOME", folder);
    environment.insert("XDG_STATE_HOME", folder);
    process_.setProcessEnvironment(environment);
    QSettings(folder + "/croquis/croquis.conf", QSettings::IniFormat).setValue("first-start", true);  // was before
    process_.start(CROQUIS_STUDIO, {"--new", "silhouette"});
  }
  ~AttendedStudio() {
    process_.kill();
    process_.waitForFinished();
    xcb_disconnect(connection_);
  }

  bool wait_for_window() {
    return process_.waitForStarted() && QTest::qWaitFor([this] { return find_window(); }, 20'000);
  }

  QSize window_size() const {
    const auto found = owned(xcb_get_geometry_reply(connection_, xcb_get_geometry(connection_, window_), nullptr));
    return found ? QSize(found->width, found->height) : QSize();
  }

  void resize_window(const QSize& size) {
    const std::array<std::uint32_t, 2> values = {static_cast<std::uint32_t>(size.width()),
                                                 static_cast<std::uint32_t>(size.height())};
    xcb_configure_window(connection_, window_, XCB_CONFIG_WINDOW_WIDTH | XCB_CONFIG_WINDOW_HEIGHT, values.data());
    xcb_flush(connection_);
  }

  /// As the close button of its frame does. @return whether the program ended
  bool close_window() {
    xcb_client_message_event_t event{};
    event.response_type = XCB_CLIENT_MESSAGE;
    event.format = 32;
    event.window = window_;
    event.type = atom("WM_PROTOCOLS");
    event.data.data32[0] = atom("WM_DELETE_WINDOW");
    xcb_send_event(connection_, 0, window_, XCB_EVENT_MASK_NO_EVENT, reinterpret_cast<const char*>(&event));
    xcb_flush(connection_);
    return process_.waitForFinished(20'000) && process_.exitStatus() == QProcess::NormalExit;
  }

 private:
  xcb_atom_t atom(const QByteArray& name) const {
    const auto cookie = xcb_intern_atom(connection_, 0, static_cast<std::uint16_t>(name.size()), name.constData());
    const auto found = owned(xcb_intern_atom_reply(connection_, cookie, nullptr));
    return found ? found->atom : static_cast<xcb_atom_t>(XCB_ATOM_NONE);
  }

  bool belongs_to_process(xcb_window_t window) const {
    const auto cookie = xcb_get_property(connection_, 0, window, atom("_NET_WM_PID"), XCB_ATOM_CARDINAL, 0, 1);
    const auto found = owned(xcb_get_property_reply(connection_, cookie, nullptr));
    return found && xcb_get_property_value_length(found.get()) == 4 &&
           *static_cast<std::uint32_t*>(xcb_get_property_value(found.get())) == process_.processId();
  }

  /// Without a window manager its parent is the root.
  bool find_window() {
    const xcb_window_t root = xcb_setup_roots_iterator(xcb_get_setup(connection_)).data->root;
    const auto tree = owned(xcb_query_tree_reply(connection_, xcb_query_tree(connection_, root), nullptr));
    for (int place = 0; tree && place < xcb_query_tree_children_length(tree.get()); ++place) {
      const xcb_window_t window = xcb_query_tree_children(tree.get())[place];
      const auto cookie = xcb_get_window_attributes(connection_, window);
      const auto found = owned(xcb_get_window_attributes_reply(connection_, cookie, nullptr));
      if (!found || found->map_state != XCB_MAP_STATE_VIEWABLE || !belongs_to_process(window)) continue;
      window_ = window;
      return true;
    }
    return false;
  }

  QProcess process_;
  xcb_connection_t* connection_;
  xcb_window_t window_ = XCB_WINDOW_NONE;
};

QMenu* menu_titled(const app::MainWindow& window, const QString& title) {
  for (const QAction* entry : window.menuBar()->actions()) {
    if (entry->menu() != nullptr && entry->text().remove('&') == title) return entry->menu();
  }
  return nullptr;
}

/// At the least size of a window, everything that is to be read is seen, and no view is too small to work in.
void check_readable(StudioFixture& hand, const std::string& state) {
  constexpr QSize least(1024, 640);
  auto& window = hand.window();
  window.resize(least);
  QApplication::processEvents();
  QApplication::processEvents();
  INFO(state);
  CHECK(window.size() == least);
  const auto* help = window.findChild<app::ElidedLabel*>("help-line");
  INFO(help->text().toStdString() << ": " << help->width() << " pixels wide");
  CHECK(help->isVisible());
  CHECK(!help->text().isEmpty());
  CHECK(help->seen().toStdString() == help->text().toStdString());
  check_labels_fit(window);
  if (!window.shows_views()) return;
  CHECK(help->text().toStdString() == app::help_of(hand.viewport().views()).toStdString());
  for (const int view : all_views) {
    const app::ViewPane& pane = hand.viewport().pane(view);
    if (!pane.visible()) continue;
    INFO("view " << view << ": " << pane.rect.width() << " x " << pane.rect.height());
    CHECK(pane.rect.width() >= 250);
    CHECK(pane.rect.height() >= 200);
  }
}

/// The same with the pointer in each view: help differs from one to the other.
void check_readable_everywhere(StudioFixture& hand, const std::string& state) {
  for (const int view : all_views) {
    const app::ViewPane& pane = hand.viewport().pane(view);
    if (!pane.visible()) continue;
    hand.send_mouse(QEvent::MouseMove, pane.rect.center(), Qt::NoButton, Qt::NoModifier);
    check_readable(hand, state + ", pointer in view " + std::to_string(view));
  }
}

}  // namespace

TEST_CASE("the window opens inside of its screen and stays there", "[window-layout][double-scale]") {
  const double scale = std::max(1.0, qEnvironmentVariable("QT_SCALE_FACTOR").toDouble());
  CHECK(QGuiApplication::primaryScreen()->devicePixelRatio() == scale);
  const QTemporaryDir folder;
  app::MainWindow window(folder.path());
  window.set_unattended();
  window.show();
  REQUIRE(QTest::qWaitForWindowExposed(&window));
  check_inside_of_screen(window, "start page");
  window.start_with();
  check_inside_of_screen(window, "sketch");
  window.action("reset-layout")->trigger();
  check_inside_of_screen(window, "layout reset");
}

TEST_CASE("a layout kept from a larger screen opens inside of this one", "[window-layout]") {
  QSettings().clear();
  QWidget large;
  large.setGeometry(2000, 900, 2880, 1804);
  app::keep_layout({large.saveGeometry(), {}, {}, {}, {0.5, 0.5}});
  const QTemporaryDir folder;
  app::MainWindow window(folder.path());
  app::remember_layout(window);
  check_inside_of_screen(window, "before it is shown");
  window.show();
  REQUIRE(QTest::qWaitForWindowExposed(&window));
  check_inside_of_screen(window, "shown");
  window.start_with();
  check_inside_of_screen(window, "sketch");
  QSettings().clear();
}

TEST_CASE("the program keeps its layout when its window is closed, and opens with it", "[window-layout]") {
  constexpr QSize size(1180, 720);
  const QTemporaryDir folder;
  const auto kept = [&] {
    return QSettings(folder.filePath("croquis/croquis.conf"), QSettings::IniFormat).contains("window/geometry");
  };
  {
    AttendedStudio first(folder.path());
    REQUIRE(first.wait_for_window());
    CHECK(first.window_size() != size);
    CHECK(!kept());
    first.resize_window(size);
    CHECK(first.close_window());
    CHECK(kept());
  }
  AttendedStudio second(folder.path());
  REQUIRE(second.wait_for_window());
  CHECK(second.window_size() == size);
  CHECK(second.close_window());
}

TEST_CASE("the panel that people brought to the front is there when the window opens again", "[window-layout]") {
  QSettings().clear();
  const QTemporaryDir folder;
  const auto is_in_front = [](const app::MainWindow& window, const QString& title) {
    for (const QTabBar* bar : window.findChildren<QTabBar*>()) {
      if (bar->isVisible() && bar->tabText(bar->currentIndex()) == title) return true;
    }
    return false;
  };
  for (const bool first : {true, false}) {
    app::MainWindow window(folder.path());
    window.set_unattended();
    app::remember_layout(window);
    window.show();
    REQUIRE(QTest::qWaitForWindowExposed(&window));
    window.start_with();
    QApplication::processEvents();
    CHECK(is_in_front(window, first ? "History" : "Findings"));
    window.findChild<QDockWidget*>("findings-dock")->raise();
    QApplication::processEvents();
    window.close();
  }
  QSettings().clear();
}

TEST_CASE("panels lie as they last did for a scan and for a sketch, in the next window too", "[window-layout]") {
  QSettings().clear();
  const QTemporaryDir folder;
  const std::string scan_file = folder.filePath("scan.ply").toStdString();
  Progress progress;
  std::ofstream(scan_file, std::ios::binary) << write_mesh(ball_with_holes(3), MeshFormat::Ply, {}, progress).bytes;
  int sketch = 0, scan = 0;
  for (const bool first : {true, false}) {
    app::MainWindow window(folder.path());
    window.set_unattended();
    app::remember_layout(window);
    window.show();
    REQUIRE(QTest::qWaitForWindowExposed(&window));
    auto* dock = window.findChild<QDockWidget*>("objects-dock");
    const auto width_at = [&](const char* sight, int wider) {
      INFO(sight << (first ? " in the first window" : " in the next window"));
      window.wait_until_settled();
      if (wider != 0) window.resizeDocks({dock}, {dock->width() + wider}, Qt::Horizontal);
      QApplication::processEvents();
      return dock->width();
    };
    const auto open_scan_file = [&] {
      REQUIRE(window.open(QString::fromStdString(scan_file)));
      window.action("holes")->trigger();
    };
    window.start_with();
    const int first_sketch = width_at("sketch", first ? 60 : 0);
    open_scan_file();
    const int first_scan = width_at("scan", first ? 90 : 0);
    if (first) sketch = first_sketch, scan = first_scan;
    REQUIRE(scan > sketch + 20);
    CHECK(std::abs(first_sketch - sketch) <= 2);
    CHECK(std::abs(first_scan - scan) <= 2);
    window.start_with();
    CHECK(std::abs(width_at("sketch again", 0) - sketch) <= 2);
    open_scan_file();
    CHECK(std::abs(width_at("scan again", 0) - scan) <= 2);
    window.close();
  }
  QSettings().clear();
}

TEST_CASE("closed panels come back by the menu Window", "[window-layout]") {
  StudioFixture hand;
  auto& window = hand.window();
  QMenu* menu = menu_titled(window, "Window");
  REQUIRE(menu != nullptr);
  CHECK(menu->actions().contains(window.action("reset-layout")));
  const auto entry_of = [&](const QDockWidget& dock) -> QAction* {
    for (QAction* entry : menu->actions()) {
      if (entry->text().remove('&') == dock.windowTitle()) return entry;
    }
    return nullptr;
  };
  int closed = 0;
  for (auto* dock : window.findChildren<QDockWidget*>()) {
    INFO(dock->windowTitle().toStdString());
    QAction* entry = entry_of(*dock);
    REQUIRE(entry != nullptr);
    if (!dock->isVisible()) continue;
    QTest::mouseClick(dock->findChild<QWidget*>("qt_dockwidget_closebutton"), Qt::LeftButton);
    CHECK(!dock->isVisible());
    QTest::mouseClick(window.menuBar(), Qt::LeftButton, {},
                      window.menuBar()->actionGeometry(menu->menuAction()).center());
    REQUIRE(hand.wait_for([&] { return menu->isVisible(); }));
    QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(entry).center());
    CHECK(!menu->isVisible());
    CHECK(dock->isVisible());
    ++closed;
  }
  CHECK(closed >= 4);
}

TEST_CASE("a small window has room for its words and views: sketches", "[small-window]") {
  StudioFixture hand;
  const auto check_tools = [&](const std::string& state) {
    for (const char* tool : {"draw", "erase", "select"}) {
      hand.act(tool);
      for (const char* selection : {"deselect", "select-all"}) {
        hand.act(selection);
        hand.settle();
        check_readable_everywhere(hand, state + ", " + tool + ", " + selection);
      }
    }
  };
  check_readable_everywhere(hand, "nothing drawn");
  hand.look_at({-250, -250}, {250, 250});
  hand.draw({{-150, 0}, {0, 40}, {150, 0}});
  hand.settle();
  check_tools("unfinished");
  hand.act("select-all");
  hand.act("delete");
  hand.draw({{-100, -100}, {100, -100}, {100, 100}, {-100, 100}, {-100, -100}});
  hand.settle();
  check_tools("finished");
  hand.act("four-views");
  check_tools("four views");
  hand.act("two-views");
  hand.open_cage("mug");
  check_tools("beside a cage");
  hand.act("start-page");
  check_readable(hand, "start page");
}

TEST_CASE("a small window has room for its words and views: in Korean", "[small-window]") {
  app::use_language("ko");
  {
    StudioFixture hand;
    hand.window().set_unattended();
    check_readable(hand, "start page");
    for (const char* kind : {"new", "new-surface"}) {
      hand.act(kind);
      hand.settle();
      for (const char* tool : {"draw", "select"}) {
        hand.act(tool);
        check_readable_everywhere(hand, std::string(kind) + ", " + tool);
      }
    }
    hand.open_cage("mug");
    for (const char* mode : {"object-mode", "edge-mode"}) {
      hand.act(mode);
      check_readable_everywhere(hand, mode);
    }
    open_scan(hand, ball_with_holes(3));
    check_readable_everywhere(hand, "holes");
  }
  app::use_language("en");
}

TEST_CASE("a small window has room for its words and views: meshes", "[small-window]") {
  StudioFixture hand;
  hand.open_cage("mug");
  const auto check_modes = [&](const std::string& state, const std::vector<const char*>& tools) {
    hand.settle();
    hand.viewport().setUpdatesEnabled(false);  // what is drawn takes nearly all the time
    for (const char* mode : {"object-mode", "vertex-mode", "edge-mode", "face-mode"}) {
      hand.act(mode);
      for (const char* tool : tools) {
        hand.act(tool);
        for (const char* selection : {"deselect", "select-all"}) {
          hand.act(selection);
          check_readable(hand, state + ", " + mode + ", " + tool + ", " + selection);
        }
      }
    }
    hand.viewport().setUpdatesEnabled(true);
  };
  check_modes("cage", {"select", "move", "rotate", "scale", "sharpen"});
  hand.act("show-smooth");
  check_modes("smooth", {"select"});
  hand.act("four-views");
  check_modes("four views", {"sharpen"});
  hand.act("compare");
  check_modes("compared", {"move"});
  hand.act("edge-mode");
  hand.act("loop-cut");
  check_readable(hand, "loop cut");
}

TEST_CASE("a small window has room for its words and views: holes", "[small-window]") {
  StudioFixture hand;
  open_scan(hand, ball_with_holes());
  const auto check = [&](const std::string& state) {
    for (const char* views : {"perspective-alone", "two-views", "four-views"}) {
      hand.act(views);
      hand.settle();
      check_readable_everywhere(hand, state + ", " + views);
    }
  };
  check("none selected");
  holes(hand).select({0});
  check("an open one");
  hand.act("select-all");
  check("all");
  holes(hand).select({0});
  hand.act("fill-selected");
  hand.settle();
  check("filled");
  hand.act("deselect");
  check("one filled, none selected");
  hand.act("select");
  check_readable(hand, "out of the holes");
}
