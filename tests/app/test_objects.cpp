// SPDX-License-Identifier: GPL-3.0-or-later
// Whole objects in the window: moved, sized by numbers, copied, grouped, isolated, exported together.
#include <QDoubleSpinBox>
#include <QMessageBox>
#include <QPushButton>
#include <QTest>

#include <catch2/catch.hpp>

#include "app/dialogs.h"
#include "app/hand_on_meshes.h"
#include "app/panels/lists.h"
#include "app/views/viewport.h"
#include "croquis/geometry/bounds.h"
#include "croquis/io/file.h"

namespace croquis::test {
namespace {

void type(StudioFixture& hand, const char* box, double value) {
  auto* field = hand.window().findChild<QDoubleSpinBox*>(box);
  REQUIRE(field != nullptr);
  REQUIRE(field->isEnabled());
  field->setValue(value);
  QApplication::processEvents();
}

std::array<Vec3, 2> box_of(StudioFixture& hand, const char* name) {
  for (const WorkObject& object : hand.studio().objects()) {
    if (object.name == name) return *placed_bounds(hand.studio(), object);
  }
  FAIL("there is no object " << name);
  return {};
}

NodeId node_of(StudioFixture& hand, const char* name) {
  for (const WorkObject& object : hand.studio().objects()) {
    if (object.name == name) return object.node;
  }
  return 0;
}

QPointF widget_place(StudioFixture& hand, const Vec3& place) {
  return app::model_to_widget(hand.viewport().views(), place, app::Viewport::PerspectiveView);
}

/// Pulls the arrow of that axis of the manipulator in the middle of what is picked by so many pixels along itself.
void pull_arrow_of(StudioFixture& hand, const Vec3& pivot, int axis, double pixels) {
  const double unit = app::frame_of(hand.viewport().views(), app::Viewport::PerspectiveView).units_per_pixel(pivot);
  const QPointF from = widget_place(hand, pivot + 60 * unit * Vec3::Unit(axis));
  const QPointF along = from - widget_place(hand, pivot);
  const double length = std::hypot(along.x(), along.y());
  hand.drag_pixels(from, from + along * (pixels / length), Qt::LeftButton, Qt::NoModifier);
  hand.settle();
}

bool same_box(const std::array<Vec3, 2>& box, const Vec3& low, const Vec3& high, double tolerance = 1e-9) {
  return (box[0] - low).norm() + (box[1] - high).norm() < tolerance;
}

void open_two(StudioFixture& hand) {
  open_mesh(hand, centred_cube(), "cube");
  open_mesh(hand, translated(centred_cube(), {6, 0, 0}), "brick");
}

}  // namespace

TEST_CASE("objects: two stand side by side, sized by numbers, in one file in millimetres", "[objects]") {
  StudioFixture hand;
  open_two(hand);
  app::select_nodes(hand.studio(), {node_of(hand, "cube")});
  const auto steps = hand.studio().session().undo_labels().size();
  type(hand, "size-x", 40);
  type(hand, "size-y", 20);
  type(hand, "size-z", 10);
  type(hand, "position-y", 10);
  app::select_nodes(hand.studio(), {node_of(hand, "brick")});
  type(hand, "rotation-z", 90);
  type(hand, "size-x", 20);  // along its own x, which points along y now
  type(hand, "position-x", 30.5);
  type(hand, "position-y", 10);
  CHECK(hand.studio().session().undo_labels().size() == steps + 8);
  CHECK(same_box(box_of(hand, "cube"), {-20, 0, -5}, {20, 20, 5}));
  CHECK(same_box(box_of(hand, "brick"), {29.5, 0, -1}, {31.5, 20, 1}));
  hand.act("export-unit-cm");  // a document without units counts as in millimetres
  const QString file = hand.folder() + "/both.obj";
  app::export_solid(hand.studio(), file, {app::MeshExport::Objects::All, "cm"});
  Progress progress;
  const PolyMesh centimetres = read_mesh(read_file(file.toStdString()), MeshFormat::Obj, "both.obj", progress).mesh;
  CHECK(same_box(*bounds_of(centimetres), {-2, 0, -0.5}, {3.15, 2, 0.5}));
  CHECK(centimetres.channel("object", Domain::Face)->labels == std::vector<std::string>{"cube", "brick"});
  app::export_solid(hand.studio(), file, {app::MeshExport::Objects::All, "mm"});
  const PolyMesh millimetres = read_mesh(read_file(file.toStdString()), MeshFormat::Obj, "both.obj", progress).mesh;
  CHECK(same_box(*bounds_of(millimetres), {-20, 0, -5}, {31.5, 20, 5}));

  // Saved, opened again and taken back.
  hand.window().files().save(hand.folder() + "/both.croq");
  StudioFixture other;
  REQUIRE(other.window().open(hand.folder() + "/both.croq"));
  other.settle();
  CHECK(same_box(box_of(other, "brick"), {29.5, 0, -1}, {31.5, 20, 1}));
  for (int k = 0; k < 8; ++k) hand.act("undo");
  CHECK(same_box(box_of(hand, "cube"), {-1, -1, -1}, {1, 1, 1}));
}

TEST_CASE("objects: W shows a manipulator for meshes and for solids of sketches; a drag moves what is picked",
          "[objects]") {
  StudioFixture hand;
  hand.window().start_with();
  draw_ring(hand);
  hand.settle();
  const NodeId solid = hand.studio().objects().front().node;
  const auto mesh = hand.studio().solid();
  hand.act("perspective-alone");
  hand.act("select");
  app::select_nodes(hand.studio(), {solid});
  REQUIRE(hand.window().action("move")->isEnabled());
  hand.act("move");
  const auto before = *placed_bounds(hand.studio(), *hand.studio().object(solid));
  const QImage plain = hand.picture();
  QTest::qWait(250);  // later than any mouse copy of the pen's events
  pull_arrow_of(hand, (before[0] + before[1]) / 2, 0, 80);
  const auto after = *placed_bounds(hand.studio(), *hand.studio().object(solid));
  CHECK(after[0].x() > before[0].x() + 1);
  CHECK((after[0] - before[0]).tail<2>().norm() < 1e-9);
  CHECK(hand.studio().solid() == mesh);  // nothing was computed again
  CHECK(hand.picture() != plain);
  REQUIRE(!hand.studio().session().undo_labels().empty());
  CHECK(hand.studio().session().undo_labels().back().rfind("Move ", 0) == 0);
  // The drawing stays on its sheet, and goes on being drawn.
  const auto strokes = hand.studio().drawing().strokes;
  CHECK(strokes.front().samples.front().position.norm() < 150);
  hand.act("undo");
  CHECK(hand.studio().object(solid)->placement == Placement());
}

TEST_CASE("objects: elements of a placed mesh are picked and moved where they are seen", "[objects]") {
  StudioFixture hand;
  open_mesh(hand, centred_cube(), "cube");
  place_objects(hand.studio(), {{node_of(hand, "cube"), {{7, 0, 0}, {0, 0, 90}, {2, 1, 1}}}});
  hand.settle();
  hand.act("frame-all");
  hand.act("face-mode");
  hand.click_model({7, 0, 1}, app::Viewport::PerspectiveView);  // the face that looks along z
  REQUIRE(hand.studio().session().components().elements.size() == 1);
  const auto face = cage(hand).face(hand.studio().session().components().elements.front());
  for (const Index vertex : face) CHECK(cage(hand).positions[vertex].z() == 1);
  hand.act("move");
  pull_arrow_of(hand, {7, 0, 1}, 2, 50);
  CHECK(box_of(hand, "cube")[1].z() > 1.2);
  CHECK(box_of(hand, "cube")[0].z() == Approx(-1));
  CHECK(hand.studio().active()->placement == Placement{{7, 0, 0}, {0, 0, 90}, {2, 1, 1}});
}

TEST_CASE("objects: copies step aside; clicks, Shift and Ctrl pick several; a group is one row", "[objects]") {
  StudioFixture hand;
  open_two(hand);
  hand.act("frame-all");
  hand.click_model({0, 0, 1}, app::Viewport::PerspectiveView);
  CHECK(picked(hand.studio()) == std::vector<NodeId>{node_of(hand, "cube")});
  hand.click_model({6, 0, 1}, app::Viewport::PerspectiveView, 1, Qt::ShiftModifier);
  CHECK(picked(hand.studio()).size() == 2);
  hand.click_model({0, 0, 1}, app::Viewport::PerspectiveView, 1, Qt::ControlModifier);
  CHECK(picked(hand.studio()) == std::vector<NodeId>{node_of(hand, "brick")});
  hand.act("duplicate-object");
  hand.settle();
  CHECK(same_box(box_of(hand, "brick 2"), {7.2, -1, -1}, {9.2, 1, 1}));
  app::select_nodes(hand.studio(), {node_of(hand, "brick"), node_of(hand, "brick 2")});
  hand.act("group");
  auto* list = hand.window().findChild<app::ObjectList*>("objects");
  REQUIRE(list->topLevelItemCount() == 2);
  CHECK(list->topLevelItem(1)->text(0) == "Group");
  CHECK(list->topLevelItem(1)->childCount() == 2);
  app::select_nodes(hand.studio(), {});
  hand.click_model({6, 0, 1}, app::Viewport::PerspectiveView);
  CHECK(picked(hand.studio()).size() == 2);
  list->topLevelItem(1)->setCheckState(0, Qt::Unchecked);
  QApplication::processEvents();
  CHECK_FALSE(hand.studio().object(node_of(hand, "brick 2"))->visible);
  CHECK(hand.studio().object(node_of(hand, "cube"))->visible);
  hand.act("show-all");
  app::select_nodes(hand.studio(), {node_of(hand, "cube")});
  hand.act("isolate");
  CHECK(hand.viewport().objects().surfaces().size() == 1);
  hand.act("isolate");
  CHECK(hand.viewport().objects().surfaces().size() == 3);
  app::select_nodes(hand.studio(), {node_of(hand, "brick"), node_of(hand, "brick 2")});
  hand.act("ungroup");
  CHECK(list->topLevelItemCount() == 3);
  // The same key makes crease sets of edges.
  CHECK(hand.window().action("group")->isEnabled());
  CHECK_FALSE(hand.window().action("crease-set")->isEnabled());
  hand.act("edge-mode");
  CHECK_FALSE(hand.window().action("group")->isEnabled());
  CHECK(hand.window().action("crease-set")->isEnabled());
}

TEST_CASE("objects: opening a mesh beside others asks whether it replaces them", "[objects]") {
  StudioFixture hand;
  open_mesh(hand, centred_cube(), "cube");
  Progress progress;
  const QString file = hand.folder() + "/ball.obj";
  std::ofstream(file.toStdString()) << write_mesh(uv_sphere(8, 6), MeshFormat::Obj, {}, progress).bytes;
  const auto answer = [&](const QString& wanted) {
    in_dialog<QMessageBox>([wanted](QMessageBox& box) {
      CHECK(box.objectName() == "open-question");
      CHECK(box.text().contains("ball.obj"));
      for (QAbstractButton* button : box.buttons()) {
        if (button->text().remove('&') == wanted) return button->click();
      }
      FAIL("no such button");
    });
    app::begin_open(hand.window(), {file});
    REQUIRE(hand.wait_for([&] { return hand.window().settled(); }));
  };
  answer("Cancel");
  CHECK(hand.studio().objects().size() == 1);
  answer("Add");
  CHECK(hand.studio().objects().size() == 2);
  const std::array<Vec3, 2> kept = *bounds_of(uv_sphere(8, 6));  // coordinates of files are kept
  CHECK(same_box(box_of(hand, "ball"), kept[0], kept[1]));
  hand.studio().session().mark_saved();
  answer("Replace");
  REQUIRE(hand.studio().objects().size() == 1);
  CHECK(hand.studio().objects().front().name == "ball");
  CHECK_FALSE(hand.studio().session().can_undo());
  app::import_files(hand.window(), {file});
  REQUIRE(hand.wait_for([&] { return hand.window().settled(); }));
  CHECK(hand.studio().objects().size() == 2);
}

}  // namespace croquis::test
