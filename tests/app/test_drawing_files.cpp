// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QListWidget>
#include <QToolButton>
#include <cmath>

#include <catch2/catch.hpp>

#include "app/studio_fixture.h"
#include "app/tools/perspective/perspective_drawing_tool.h"
#include "croquis/io/camera_file.h"
#include "croquis/io/perspective_drawing_file.h"
#include "support/perspective/solid_drawing.h"

namespace croquis::test {
namespace {

QString written(StudioFixture& hand, const QString& name, const std::string& bytes) {
  QFile file(hand.folder() + "/" + name);
  REQUIRE(file.open(QIODevice::WriteOnly));
  file.write(bytes.data(), static_cast<qint64>(bytes.size()));
  return file.fileName();
}

app::Sheet& sheet_in(StudioFixture& hand) { return hand.window().tool<app::PerspectiveDrawingTool>().sheet(); }

/// The names of the strokes that the panel says something of that code about, in its order.
std::vector<std::string> listed(StudioFixture& hand, const QString& code) {
  const auto& panel = *hand.window().findChild<QListWidget*>("findings");
  std::vector<std::string> strokes;
  for (int row = 0; row < panel.count(); ++row) {
    if (panel.item(row)->toolTip() == code)
      strokes.push_back(panel.item(row)->text().section('\'', 1, 1).toStdString());
  }
  return strokes;
}

const std::string plain_svg =
    R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 400 300">
<path id="a" stroke="#F28C00" fill="none" d="M 10 10 L 200 30"/><path id="b" stroke="#F28C00" fill="none" d="M 10 90 L 200 80"/></svg>)";

}  // namespace

TEST_CASE("perspective drawings open as SVG and as JSON, and become the same solid", "[drawing-files]") {
  const SolidDrawing truth = drawn(box(), three_point_views()[1]);
  for (const bool json : {false, true}) {
    StudioFixture hand;
    const QString path = json ? written(hand, "box.json", write_perspective_json(truth.drawing))
                              : written(hand, "box.svg", write_perspective_svg(truth.drawing));
    REQUIRE(hand.window().open(path));
    hand.settle();
    REQUIRE(sheet_in(hand).result() != nullptr);
    CHECK(sheet_in(hand).result()->closed);
    CHECK(sheet_in(hand).result()->faces.size() == 6);
    CHECK(hand.studio().active()->name == "box");
  }
}

TEST_CASE("an SVG file that doesn't say what it is opens as what is being worked on", "[drawing-files]") {
  StudioFixture hand;
  hand.window().set_unattended();
  const QString path = written(hand, "plain.svg", plain_svg);
  REQUIRE(hand.window().open(path));
  CHECK(hand.studio().sheet_node() == 0);
  CHECK(hand.studio().drawing().strokes.size() == 2);
  hand.act("new-perspective");
  REQUIRE(hand.window().open(path));
  REQUIRE(hand.studio().sheet_node() != 0);
  CHECK(sheet_in(hand).drawing().image_size == Vec2(400, 300));
  CHECK(sheet_in(hand).drawing().strokes.size() == 2);
  CHECK(sheet_in(hand).drawing().strokes[0].group == StrokeGroup::ParallelX);
}

TEST_CASE("what was found in a drawing's file is reported of strokes as they were read, not of changed ones",
          "[drawing-files]") {
  using Names = std::vector<std::string>;
  SolidDrawing truth = drawn(box(), three_point_views()[1]);
  Names names;
  for (PerspectiveStroke& stroke : truth.drawing.strokes) {
    if (stroke.role != StrokeRole::Edge || stroke.group != StrokeGroup::ParallelY) continue;
    names.push_back(stroke.id);
    stroke.colour = colour_of_group(names.size() == 1 ? StrokeGroup::ParallelY : StrokeGroup::ParallelZ);
    if (names.size() == 1) stroke.group = StrokeGroup::ParallelX;
  }
  REQUIRE(names.size() == 4);
  StudioFixture hand;
  hand.window().set_unattended();
  REQUIRE(hand.window().open(written(hand, "box.svg", write_perspective_svg(truth.drawing))));
  hand.settle();
  CHECK(listed(hand, "GROUP_COLOUR") == names);
  hand.picture();
  hand.viewport().findChild<QToolButton*>("perspective-fix-chip")->click();
  hand.settle();
  REQUIRE(find_stroke(sheet_in(hand).drawing(), names[0])->group == StrokeGroup::ParallelY);
  CHECK(listed(hand, "GROUP_COLOUR") == Names(names.begin() + 1, names.end()));
  sheet_in(hand).tool.take(recorded::SheetDelete{{names[3]}});
  CHECK(listed(hand, "GROUP_COLOUR") == Names{names[1], names[2]});
  hand.act("undo");
  hand.act("undo");
  CHECK(listed(hand, "GROUP_COLOUR") == names);
}

TEST_CASE("a camera file states the camera of the sheet, at the sheet's own size, or begins one", "[drawing-files]") {
  CameraFile file;
  file.camera.focal_length = 800;
  file.camera.image_size = {800, 600};
  file.camera.principal_point = {420, 280};
  StudioFixture hand;
  hand.crash_and_restart();  // to the start page
  const QString path = written(hand, "camera.json", write_camera_json(file));
  REQUIRE(hand.window().open(path));
  REQUIRE(hand.studio().sheet_node() != 0);
  CHECK(sheet_in(hand).drawing().image_size == Vec2(800, 600));
  CHECK(*sheet_in(hand).drawing().field_of_view == Approx(2 * std::atan(0.5)));
  CHECK((*sheet_in(hand).drawing().principal_point - Vec2(420, 280)).norm() < 1e-6);
  sheet_in(hand).tool.take(recorded::SheetSize{{1600, 1200}});
  REQUIRE(hand.window().open(path));
  CHECK((*sheet_in(hand).drawing().principal_point - Vec2(840, 560)).norm() < 1e-6);
  CHECK_FALSE(hand.window().open(written(hand, "broken.json", "{\"a\": 1}")));
}

TEST_CASE("the sheet takes other sizes and shapes, and strokes keep their places", "[drawing-files]") {
  StudioFixture hand;
  app::start_with(hand.studio(), drawn(box(), three_point_views()[1]).drawing);
  app::show_views(hand.window());
  hand.settle();
  const Vec2 place = sheet_in(hand).drawing().strokes[0].start();
  auto* width = hand.window().findChild<QDoubleSpinBox*>("sheet-width");
  REQUIRE(width != nullptr);
  width->setValue(1600);
  CHECK(sheet_in(hand).drawing().image_size.x() == 1600);
  auto* shape = hand.window().findChild<QComboBox*>("sheet-shape");
  shape->setCurrentIndex(5);
  emit shape->activated(5);
  const Vec2 portrait = sheet_in(hand).drawing().image_size;
  CHECK(portrait.y() > portrait.x());
  CHECK(std::abs(portrait.y() / portrait.x() - std::sqrt(2.0)) < 2e-3);
  CHECK(shape->currentIndex() == 5);
  CHECK(sheet_in(hand).drawing().strokes[0].start() == place);
  hand.act("undo");
  CHECK(sheet_in(hand).drawing().image_size.x() == 1600);
}

TEST_CASE("the camera of an object is a view of the scene, with any tool and beside other objects", "[drawing-files]") {
  StudioFixture hand;
  app::start_with(hand.studio(), drawn(bottle(), off_centre_view()).drawing);
  app::show_views(hand.window());
  hand.settle();
  QAction* camera = hand.window().action("camera-1");
  REQUIRE(camera->isVisible());
  CHECK(camera->isChecked());
  CHECK_FALSE(hand.window().action("camera-2")->isVisible());
  hand.act("camera-1");
  CHECK_FALSE(camera->isChecked());
  hand.open_cage("bolt");
  hand.studio().session().select({{hand.studio().objects().back().node, ""}});
  hand.act("camera-1");
  CHECK(hand.studio().sheet_node() == 0);
  hand.picture();
  const auto seen = app::looked_through(hand.viewport().views());
  REQUIRE(seen);
  const app::ViewPane& pane = hand.viewport().pane(app::PerspectiveView);
  const Vec3 vertex = hand.studio().objects().front().mesh->positions.front();
  const Vec2 on_sheet = seen->camera.project(vertex) - (seen->origin + seen->camera.image_size / 2);
  const double scale = 0.96 * std::min(pane.rect.width() / seen->camera.image_size.x(),
                                       pane.rect.height() / seen->camera.image_size.y());
  const QPointF at = app::model_to_widget(hand.viewport().views(), vertex, app::PerspectiveView) - pane.rect.center();
  CHECK(std::abs(at.x() - scale * on_sheet.x()) < 0.01);
  CHECK(std::abs(at.y() - scale * on_sheet.y()) < 0.01);
  const glm::dvec3 eye = pane.camera.eye;
  const QPointF middle = pane.rect.center();
  hand.drag_pixels(middle, middle + QPointF(1, 0), Qt::LeftButton, Qt::AltModifier);
  CHECK_FALSE(camera->isChecked());
  CHECK(glm::distance(pane.camera.eye, eye) < 0.05 * glm::distance(pane.camera.eye, pane.camera.target));
}

}  // namespace croquis::test
