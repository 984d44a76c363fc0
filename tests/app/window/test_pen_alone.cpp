// SPDX-License-Identifier: GPL-3.0-or-later
// The five journeys with a pen and nothing else: no key, no mouse. What isn't drawn is tapped: buttons, menus, dialogs.
#include <QAction>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QMenu>
#include <QMenuBar>
#include <QPointingDevice>
#include <QProcess>
#include <QPushButton>
#include <QTabletEvent>
#include <QTimer>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <functional>

#include <catch2/catch.hpp>

#include "app/hole_scans.h"
#include "app/tools/surface/surface_drawing_tool.h"
#include "support/perspective/solid_drawing.h"

using namespace croquis;
using namespace croquis::test;

namespace {

/// What a pen does in a window: what no widget takes becomes the event of a mouse, as Qt makes it of real pens.
class PenAlone : public StudioFixture {
 public:
  PenAlone() {
    window().set_unattended();
    window().parts().folder = folder();
  }

  void touch(QWidget& widget, QEvent::Type type, const QPointF& at) {
    const bool down = type != QEvent::TabletRelease;
    const Qt::MouseButton changed = type == QEvent::TabletMove ? Qt::NoButton : Qt::LeftButton;
    const Qt::MouseButtons held = down ? Qt::LeftButton : Qt::NoButton;
    const QPointF global = widget.mapToGlobal(at);
    QTabletEvent event(type, &pen_, at, global, down ? 0.6 : 0, 0, 0, 0, 0, 0, {}, changed, held);
    event.ignore();
    QApplication::sendEvent(&widget, &event);
    if (event.isAccepted()) return;
    const QEvent::Type as = type == QEvent::TabletPress  ? QEvent::MouseButtonPress
                            : type == QEvent::TabletMove ? QEvent::MouseMove
                                                         : QEvent::MouseButtonRelease;
    QMouseEvent mouse(as, at, global, changed, held, {});
    QApplication::sendEvent(&widget, &mouse);
  }

  void tap(QWidget& widget, const QPointF& at) {
    REQUIRE(wait_for([&] { return widget.isVisible(); }));  // menus within menus take their time
    for (const auto type : {QEvent::TabletPress, QEvent::TabletRelease}) touch(widget, type, at);
    QApplication::processEvents();
  }
  void tap(QWidget& widget) { tap(widget, widget.rect().center()); }

  /// Through places of the views.
  void stroke(const std::vector<QPointF>& places) {
    touch(viewport(), QEvent::TabletPress, places.front());
    for (std::size_t k = 1; k < places.size(); ++k) {
      for (int part = 1; part <= 8; ++part)
        touch(viewport(), QEvent::TabletMove, places[k - 1] + (places[k] - places[k - 1]) * (part / 8.0));
    }
    touch(viewport(), QEvent::TabletRelease, places.back());
    settle();
  }
  void double_tap(const QPointF& at) {
    for (int k = 0; k < 2; ++k) tap(viewport(), at);
    settle();
  }

  void drag_button(const char* name, const QPointF& by) {
    auto& button = *window().findChild<QToolButton*>(name);
    REQUIRE(button.isVisible());
    const QPointF from = button.rect().center();
    touch(button, QEvent::TabletPress, from);
    for (int part = 1; part <= 8; ++part) touch(button, QEvent::TabletMove, from + by * (part / 8.0));
    touch(button, QEvent::TabletRelease, from + by);
    settle();
  }

  /// By its button where there is one in sight, else through the menus.
  void command(const QString& name) {
    QAction* action = window().action(name);
    REQUIRE(action != nullptr);
    INFO(name.toStdString());
    for (auto* button : window().findChildren<QToolButton*>()) {
      if (button->defaultAction() == action && button->isVisible()) {
        tap(*button);
        return settle();
      }
    }
    REQUIRE(choose(*window().menuBar(), *action));
    settle();
  }

  /// Answers the next file dialog, however long the menus take until then.
  void in_file_dialog(std::function<void(QFileDialog&)> answer) {
    constexpr int again_ms = 50;
    QTimer::singleShot(again_ms, qApp, [this, answer = std::move(answer)]() mutable {
      if (auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget())) return answer(*dialog);
      in_file_dialog(std::move(answer));
    });
  }

  /// Opens the file of that name through the dialog of File > Open.
  void open(const QString& path) {
    in_file_dialog([&](QFileDialog& dialog) {
      dialog.selectFile(path);
      tap(*dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Open));
    });
    command("open");
  }

  /// Saves under the name that the dialog proposes. @return the file
  QString exported() {
    QString path;
    window().parts().folder = folder();
    in_file_dialog([&](QFileDialog& dialog) {
      path = dialog.selectedFiles().value(0);
      tap(*dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Save));
    });
    command("export-solid");
    return path;
  }

  QPointF at(const Vec3& place) { return app::model_to_widget(viewport().views(), place, app::PerspectiveView); }

 private:
  /// Opens the menus on the way to an action one after the other, then taps it.
  template <class Bar>
  bool choose(Bar& bar, const QAction& wanted) {
    for (QAction* entry : bar.actions()) {
      const bool leads = entry == &wanted || (entry->menu() != nullptr && has(*entry->menu(), wanted));
      if (!leads) continue;
      tap(bar, bar.actionGeometry(entry).center());
      return entry == &wanted || choose(*entry->menu(), wanted);
    }
    return false;
  }
  static bool has(const QMenu& menu, const QAction& wanted) {
    return std::ranges::any_of(menu.actions(), [&](const QAction* entry) {
      return entry == &wanted || (entry->menu() != nullptr && has(*entry->menu(), wanted));
    });
  }

  QPointingDevice pen_{"pen",
                       1,
                       QInputDevice::DeviceType::Stylus,
                       QPointingDevice::PointerType::Pen,
                       QInputDevice::Capability::Position | QInputDevice::Capability::Pressure,
                       1,
                       1};
};

std::vector<QPointF> oval(const QPointF& middle, double wide, double high) {
  std::vector<QPointF> places;
  for (int k = 0; k <= 40; ++k)
    places.push_back(middle + QPointF(wide * std::cos(k * 0.157079632679), high * std::sin(k * 0.157079632679)));
  return places;
}

bool is_sound(const QString& file) { return QProcess::execute(CROQUIS_CLI, {"check", file, "--quiet"}) == 0; }

}  // namespace

TEST_CASE("with the pen alone a character is drawn, undone, turned round and exported", "[pen-alone]") {
  PenAlone hand;
  hand.command("new");
  const QPointF middle = hand.viewport().pane(app::SketchView).rect.center();
  hand.stroke(oval(middle, 90, 60));
  hand.stroke(oval(middle - QPointF(95, 60), 45, 40));
  hand.command("undo");
  CHECK(hand.studio().drawing().strokes.size() == 1);
  hand.command("redo");
  REQUIRE(hand.studio().drawing().strokes.size() == 2);
  const QRectF view = hand.viewport().pane(app::PerspectiveView).rect;
  const auto eye = [&] { return hand.viewport().pane(app::PerspectiveView).camera.eye; };
  const glm::dvec3 before = eye();
  hand.stroke({view.center() + QPointF(0, 150), view.center() + QPointF(80, 150)});
  CHECK(glm::length(eye() - before) > 0.1 * glm::length(before));
  CHECK(is_sound(hand.exported()));
}

TEST_CASE("with the pen alone a box is drawn in perspective, looked through and exported", "[pen-alone]") {
  PenAlone hand;
  hand.command("new-perspective");
  SolidDrawingOptions options;
  options.vertex_ids = false;
  options.known = false;
  options.construction_lines = 0;
  const PerspectiveDrawing drawing = drawn(box(), three_point_views()[1], options).drawing;
  Eigen::AlignedBox2d bounds;
  for (const PerspectiveStroke& stroke : drawing.strokes) bounds.extend(stroke.start()).extend(stroke.end());
  const QRectF view = hand.viewport().pane(app::SketchView).rect;
  const double size = 0.6 * std::min(view.width(), view.height()) / bounds.sizes().maxCoeff();
  const auto shown = [&](const Vec2& place) {
    const Vec2 from_middle = size * (place - bounds.center());
    return view.center() + QPointF(from_middle.x(), from_middle.y());
  };
  for (const PerspectiveStroke& stroke : drawing.strokes) {
    if (stroke.role == StrokeRole::Edge) hand.stroke({shown(stroke.start()), shown(stroke.end())});
  }
  INFO(hand.studio().session().undo_labels().size());
  if (hand.viewport().views().through == 0) hand.command("look-through");
  CHECK(hand.viewport().views().through != 0);
  CHECK(is_sound(hand.exported()));
}

TEST_CASE("with the pen alone four curves become a patch that is pulled and exported", "[pen-alone]") {
  PenAlone hand;
  hand.command("new-surface");
  const QPointF middle = hand.viewport().pane(app::PerspectiveView).rect.center();
  const std::vector<QPointF> corners{{-150, 0}, {80, -80}, {240, 0}, {0, 90}};
  for (std::size_t k = 0; k < 4; ++k) hand.stroke({middle + corners[k], middle + corners[(k + 1) % 4]});
  hand.command("patch");
  hand.tap(hand.viewport(), middle);
  hand.settle();
  hand.command("surface-point");
  hand.stroke({middle, middle - QPointF(0, 60)});
  const auto& network = hand.window().tool<app::SurfaceDrawingTool>().network().network();
  REQUIRE(network.faces.size() == 1);
  CHECK(network.points.size() == 1);
  CHECK(QFile::exists(hand.exported()));
}

TEST_CASE("with the pen alone a loop of edges becomes sharp on a smooth bolt", "[pen-alone]") {
  PenAlone hand;
  hand.open(CROQUIS_SOURCE_DIR "/examples/data/bolt.obj");
  hand.command("show-both");
  hand.command("edge-mode");
  hand.command("select");
  const QRectF view = hand.viewport().pane(app::PerspectiveView).rect;
  hand.stroke(
      {view.bottomRight() - QPointF(120, 60), view.bottomRight() - QPointF(20, 60)});  // a box with nothing in it
  CHECK(hand.studio().session().components().empty());
  // The head hides its collar: the view is turned by the button that a pen drags.
  hand.drag_button("rotate-view", {400, -100});
  hand.command("frame-all");
  hand.double_tap(hand.at({-1, 0, 0}));  // where the shank meets the head
  REQUIRE(hand.studio().session().components().kind == ComponentKind::Edge);
  CHECK(hand.studio().session().components().elements.size() == 4);
  hand.command("sharp");
  CHECK(hand.studio().active()->cage_mesh->tags.creases.size() == 4);
  const auto faces = [&] { return hand.studio().active()->mesh->face_count(); };
  const std::size_t before = faces();
  hand.command("finer");
  CHECK(faces() > 2 * before);
  CHECK(is_sound(hand.exported()));
}

TEST_CASE("with the pen alone holes of a scan are filled and the scan is exported", "[pen-alone]") {
  PenAlone hand;
  const QString file = hand.folder() + "/ball.ply";
  Progress progress;
  std::ofstream(file.toStdString(), std::ios::binary)
      << write_mesh(ball_with_holes(), MeshFormat::Ply, {}, progress).bytes;
  hand.open(file);
  hand.command("holes");
  const std::size_t holes = hand.holes().rows.size();
  hand.command("fill-inner");
  CHECK(count(hand, FillAction::Fill) + 1 >= holes);
  CHECK(QFile::exists(hand.exported()));
}
