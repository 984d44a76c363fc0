// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QApplication>
#include <QFile>
#include <QSlider>
#include <QTest>
#include <QTreeWidget>
#include <cmath>
#include <fstream>

#include <catch2/catch.hpp>

#include "app/panels/lists.h"
#include "app/replay/replay_player.h"
#include "app/start/gallery.h"
#include "app/studio_fixture.h"
#include "app/tools/subdivision/subdivision_tool.h"
#include "app/window/theme.h"
#include "croquis/document/content_hash.h"
#include "croquis/io/file.h"
#include "croquis/io/mesh_file.h"
#include "croquis/tools/all_steps.h"
#include "support/sketches/sketch_gallery.h"

using namespace croquis;
using app::Viewport;
using croquis::test::StudioFixture;

namespace {

const Vec3 collar_edge(-1, 0, 0);  // the middle of one of the four edges where the bolt's shank meets its head

bool is_like(const QColor& c, const QColor& wanted) {
  return std::abs(c.red() - wanted.red()) + std::abs(c.green() - wanted.green()) + std::abs(c.blue() - wanted.blue()) <
         60;
}

const ComponentSelection& selected(StudioFixture& hand) { return hand.studio().session().components(); }

/// The bolt from where its collar is seen, smooth, its edges to be picked.
void show_collar(StudioFixture& hand) {
  hand.open_cage("bolt");
  CameraMotion motion;
  motion.delta = Vec2(400, -100);
  hand.viewport().pane(Viewport::PerspectiveView).move(motion);
  hand.act("show-both");
  hand.act("frame-all");
  hand.act("edge-mode");
  hand.settle();
}

std::size_t faces_shown(StudioFixture& hand) { return hand.studio().active()->shown()->face_count(); }

/// Those that open dialogs or end the program are left out.
void trigger_every_action(bool on_meshes) {
  StudioFixture hand;
  hand.window().set_unattended();
  const auto may_run = [](const QString& name) {
    return !name.startsWith("open") && name != "import" && name != "quit" && !name.startsWith("save") &&
           !name.startsWith("export");
  };
  hand.window().start_with();
  for (QAction* action : hand.window().actions()) {
    if (!may_run(action->objectName())) continue;
    INFO(action->objectName().toStdString());
    if (on_meshes && hand.studio().active() == nullptr) {
      hand.window().files().start_sample("cube_corner");
      app::show_views(hand.window());
    }
    if (on_meshes) {
      hand.act("face-mode");
      hand.act("select-all");
    }
    if (action->isEnabled()) action->trigger();
    QApplication::processEvents();
    CHECK(hand.window().action(action->objectName()) == action);
  }
  hand.settle();
}

}  // namespace

TEST_CASE("a collar's loop is picked with a double click and made sharp and smooth again", "[meshes]") {
  StudioFixture hand;
  show_collar(hand);
  hand.click_model(collar_edge, Viewport::PerspectiveView, 2);
  REQUIRE(selected(hand).kind == ComponentKind::Edge);
  CHECK(selected(hand).elements.size() == 4);
  const QRectF view = hand.viewport().pane(Viewport::PerspectiveView).rect;
  CHECK(test::share_of_pixels(hand.picture(), view, [](const QColor& c) { return is_like(c, app::colors::accent); }) >
        0.0005);
  hand.act("smooth");
  hand.settle();
  CHECK(hand.studio().active()->cage_mesh->tags.creases.empty());
  CHECK(faces_shown(hand) == 226);
  hand.act("sharp");
  hand.act("finer");
  hand.settle();
  CHECK(hand.studio().active()->cage_mesh->tags.creases.size() == 4);
  CHECK(faces_shown(hand) == 674);
  auto* chains = hand.window().findChild<app::ChainTable*>("chains");
  REQUIRE(chains->rowCount() == 1);
  CHECK(chains->item(0, 3)->text() == "90°");
  hand.act("deselect");
  CHECK(selected(hand).empty());
  emit chains->cellClicked(0, 0);
  CHECK(selected(hand).elements.size() == 4);
  hand.act("undo");
  hand.act("undo");
  hand.settle();
  CHECK(faces_shown(hand) == 226);
}

TEST_CASE("a dragged cage point moves the smooth surface while the button is down, in one step", "[meshes]") {
  StudioFixture hand;
  show_collar(hand);
  hand.act("vertex-mode");
  const Vec3 corner(-1, 1, -3);
  hand.click_model(corner, Viewport::PerspectiveView);
  REQUIRE(selected(hand).elements.size() == 1);
  hand.act("move");
  const QImage before = hand.picture();
  const auto mesh_before = hand.studio().active()->mesh;
  const std::size_t steps = hand.studio().session().undo_labels().size();
  const QPointF at = app::model_to_widget(hand.viewport().views(), corner, Viewport::PerspectiveView);
  hand.send_mouse(QEvent::MouseButtonPress, at, Qt::LeftButton, Qt::NoModifier);
  for (int k = 1; k <= 5; ++k) {
    hand.send_mouse(QEvent::MouseMove, at - QPointF(12 * k, 10 * k), Qt::LeftButton, Qt::NoModifier);
  }
  CHECK(hand.wait_for([&] { return hand.studio().active()->mesh != mesh_before; }));
  CHECK(hand.picture() != before);
  hand.send_mouse(QEvent::MouseButtonRelease, at - QPointF(60, 50), Qt::LeftButton, Qt::NoModifier);
  hand.settle();
  CHECK(hand.studio().session().undo_labels().size() == steps + 1);
  CHECK((hand.studio().active()->cage_mesh->positions[15] - corner).norm() > 0.2);
  hand.act("undo");
  CHECK((hand.studio().active()->cage_mesh->positions[15] - corner).norm() == 0);
}

TEST_CASE("what is under the pointer lights up, and a tagged edge shows its sharpness", "[meshes]") {
  StudioFixture hand;
  show_collar(hand);
  const QPointF at = app::model_to_widget(hand.viewport().views(), collar_edge, Viewport::PerspectiveView);
  hand.send_mouse(QEvent::MouseMove, QPointF(30, 300), Qt::NoButton, Qt::NoModifier);
  const auto blue = [](const QColor& c) { return is_like(c, app::colors::hover); };
  const QRectF around(at - QPointF(60, 60), QSizeF(120, 120));
  const double before = test::share_of_pixels(hand.picture(), around, blue);
  hand.send_mouse(QEvent::MouseMove, at, Qt::NoButton, Qt::NoModifier);
  CHECK(test::share_of_pixels(hand.picture(), around, blue) > before + 0.01);
  auto* value = hand.viewport().findChild<QLabel*>("pointer-value");
  CHECK(value->isVisible());
  CHECK(value->text() == "∞");
}

TEST_CASE("the marking menu works by direction alone", "[mesh-views]") {
  CHECK(app::MarkingMenu::place_towards({0, -50}) == 0);
  CHECK(app::MarkingMenu::place_towards({40, -40}) == 1);
  CHECK(app::MarkingMenu::place_towards({50, 3}) == 2);
  CHECK(app::MarkingMenu::place_towards({-50, 3}) == 6);
  CHECK(app::MarkingMenu::place_towards({-40, -40}) == 7);
  CHECK(app::MarkingMenu::place_towards({3, 3}) == -1);
  StudioFixture hand;
  show_collar(hand);
  hand.click_model(collar_edge, Viewport::PerspectiveView, 2);
  const QPointF at(300, 300);
  const auto stroke = [&](const QPointF& way) { hand.drag_pixels(at, at + way, Qt::RightButton, Qt::NoModifier); };
  stroke({-60, 0});
  CHECK(hand.studio().active()->cage_mesh->tags.creases.empty());
  stroke({60, 0});
  CHECK(hand.studio().active()->cage_mesh->tags.creases.size() == 4);
  stroke({0, -60});
  CHECK(hand.mesh().tool().selection().mode() == MeshMode::Vertex);
  stroke({0, 60});
  CHECK(hand.mesh().tool().selection().mode() == MeshMode::Object);
}

TEST_CASE("four views look along the axes, never turn when flat, and Space shows one alone", "[mesh-views]") {
  StudioFixture hand;
  hand.open_cage("l_bracket");
  Viewport& view = hand.viewport();
  CHECK(view.views().layout.alone() == Viewport::PerspectiveView);
  hand.act("layout");
  hand.settle();
  const auto not_plain = [](const QColor& c) { return c.saturation() > 25 && c.lightness() > 90; };
  for (const int v : {Viewport::SketchView, Viewport::PerspectiveView, Viewport::TopView, Viewport::SideView}) {
    INFO(v);
    REQUIRE(view.pane(v).visible());
    CHECK(test::share_of_pixels(hand.picture(), view.pane(v).rect, not_plain) > 0.05);
  }
  const QPointF top = view.pane(Viewport::TopView).rect.center();
  const render::Camera before = view.pane(Viewport::TopView).camera;
  hand.drag_pixels(top, top + QPointF(50, 20), Qt::LeftButton, Qt::AltModifier);
  const render::Camera after = view.pane(Viewport::TopView).camera;
  CHECK(glm::length(glm::normalize(after.target - after.eye) - glm::normalize(before.target - before.eye)) < 1e-9);
  CHECK(glm::length(after.target - before.target) > 1e-3);
  QTest::mouseMove(&view, top.toPoint());
  hand.act("layout");
  CHECK(view.views().layout.alone() == Viewport::TopView);
  hand.act("layout");
  CHECK(view.views().layout.shown().size() == 4);
}

TEST_CASE("several meshes are listed, hidden, renamed, deleted, and brought back", "[mesh-views]") {
  StudioFixture hand;
  hand.open_cage("bolt");
  hand.open_cage("mug");
  auto* list = hand.window().findChild<app::ObjectList*>("objects");
  REQUIRE(list->topLevelItemCount() == 2);
  CHECK(list->topLevelItem(0)->text(0) == "bolt");
  CHECK(list->topLevelItem(1)->text(1).contains("80"));
  CHECK(hand.studio().active()->name == "mug");
  list->topLevelItem(0)->setCheckState(0, Qt::Unchecked);
  CHECK(hand.wait_for([&] { return !hand.studio().objects()[0].visible; }));
  CHECK(hand.viewport().objects().surfaces().size() == 1);
  list->topLevelItem(1)->setText(0, "cup");
  CHECK(hand.wait_for([&] { return hand.studio().objects()[1].name == "cup"; }));
  emit list->objects_chosen({hand.studio().objects()[1].node});
  hand.act("delete-object");
  CHECK(hand.studio().objects().size() == 1);
  hand.act("undo");
  CHECK(hand.studio().objects().size() == 2);
  CHECK(hand.studio().objects()[1].name == "cup");
  hand.act("undo");
  hand.act("undo");
  CHECK(hand.studio().objects()[0].visible);
}

TEST_CASE("keys 1, 2, 3 and levels change what is seen and lose nothing", "[mesh-views]") {
  StudioFixture hand;
  hand.open_cage("cube_corner");
  hand.act("show-smooth");
  hand.settle();
  CHECK(app::shown_level(hand.studio()) == 2);
  const std::size_t smooth = faces_shown(hand);
  CHECK(smooth > 50);
  hand.act("show-cage");
  CHECK(faces_shown(hand) == 6);
  hand.act("show-both");
  hand.settle();
  CHECK(faces_shown(hand) == smooth);
  for (int k = 0; k < 9; ++k) hand.act("coarser");
  hand.settle();
  CHECK(faces_shown(hand) == 6);
  hand.act("finer");
  hand.act("compare");
  hand.settle();
  CHECK(hand.viewport().pane(Viewport::ComparisonView).visible());
  CHECK(hand.window().tool<app::SubdivisionTool>().comparison().item() != nullptr);
  hand.act("compare");
  hand.act("freeze");
  hand.settle();
  REQUIRE(hand.studio().objects().size() == 2);
  CHECK(hand.studio().active()->is_source());
  CHECK(hand.studio().active()->cage_mesh->tags.creases.size() == 6);
  hand.act("undo");
  CHECK(hand.studio().objects().size() == 1);
  CHECK(hand.studio().objects()[0].visible);
}

TEST_CASE("an exported cage keeps its tags", "[mesh-views]") {
  StudioFixture hand;
  hand.open_cage("bolt_pinned_square");
  const MeshTags tags = hand.studio().active()->cage_mesh->tags;
  REQUIRE(tags.pins.size() == 4);
  const QString file = hand.folder() + "/square.obj";
  CHECK(app::export_solid(hand.studio(), file).empty());
  Progress progress;
  const PolyMesh back = read_mesh(read_file(file.toStdString()), MeshFormat::Obj, "square.obj", progress).mesh;
  CHECK(back.tags.creases.size() == tags.creases.size());
  CHECK(back.tags.pins == tags.pins);
}

TEST_CASE("a cage that can't be refined is reported in words that lead to its elements", "[meshes]") {
  StudioFixture hand;
  const QString file = hand.folder() + "/fan.obj";
  std::ofstream(file.toStdString()) << "v 0 0 0\nv 0 0 1\nv 1 0 0\nv 0 1 0\nv -1 0 0\n"
                                       "f 1 2 3\nf 1 2 4\nf 1 2 5\n";
  REQUIRE(hand.window().open(file));
  hand.act("show-smooth");
  hand.settle();
  const auto findings = findings_of(hand.studio());
  REQUIRE(!findings.empty());
  CHECK(hand.studio().active()->shown() == hand.studio().active()->cage_mesh);  // it is still seen
  CHECK(!hand.viewport().objects().surfaces().empty());
  auto* list = hand.window().findChild<app::FindingsList*>("findings");
  REQUIRE(list->count() >= 1);
  emit list->itemClicked(list->item(0));
  CHECK(!selected(hand).empty());
}

TEST_CASE("edges chosen by angle are counted and selected while one drags", "[meshes]") {
  StudioFixture hand;
  hand.open_cage("cube_corner");
  auto* slider = hand.window().findChild<QSlider*>("angle-slider");
  slider->setValue(80);
  CHECK(selected(hand).elements.size() == 12);
  CHECK(hand.window().findChild<QLabel*>("angle-count")->text() == "12");
  slider->setValue(100);
  CHECK(selected(hand).elements.empty());
}

TEST_CASE("faces keep their shape or their outline on every level", "[mesh-views]") {
  StudioFixture hand;
  show_collar(hand);
  hand.act("keep-shape");  // no faces are selected: said in words, nothing is changed
  CHECK(hand.window().last_findings().at(0).code == "E_EMPTY");
  const NodeId cage = hand.studio().active()->cage;
  const auto tags = [&] { return hand.studio().active()->cage_mesh->tags; };
  const std::size_t creases = tags().creases.size();

  hand.act("face-mode");
  hand.studio().session().select_components({cage, ComponentKind::Face, {0}});  // the head's top, z = 1
  hand.act("keep-shape");
  CHECK(tags().pins.size() == 4);
  CHECK(tags().creases.size() == creases + 4);
  hand.settle();
  double top = 0;
  for (const Vec3& place : hand.studio().active()->mesh->positions) top += place.z() == 1 ? 1 : 0;
  CHECK(top >= 4);

  hand.act("undo");
  CHECK(tags().pins.empty());
  hand.studio().session().select_components({cage, ComponentKind::Face, {0}});
  hand.act("keep-outline");
  CHECK(tags().creases.size() == creases + 4);
  hand.act("undo");
}

TEST_CASE("crease sets are made, named, given a sharpness and taken away", "[meshes]") {
  StudioFixture hand;
  show_collar(hand);
  hand.click_model(collar_edge, Viewport::PerspectiveView, 2);
  hand.act("crease-set");
  auto* list = hand.window().findChild<QTreeWidget*>("crease-set-list");
  REQUIRE(list->topLevelItemCount() == 1);
  list->topLevelItem(0)->setText(0, "collar");
  const auto sets = [&] { return hand.studio().active()->cage_mesh->tags.sets; };
  CHECK(hand.wait_for([&] { return sets().size() == 1 && sets()[0].name == "collar"; }));
  hand.act("undo");
  CHECK(sets()[0].name != "collar");
  hand.act("undo");
  CHECK(sets().empty());
}

TEST_CASE("every action works by its name on meshes", "[actions]") { trigger_every_action(true); }

TEST_CASE("every action works by its name on a sketch", "[actions]") { trigger_every_action(false); }

TEST_CASE("a recorded session plays back to the same document", "[mesh-sessions]") {
  StudioFixture hand;
  const QString recording = hand.folder() + "/session.jsonl";
  hand.window().record_to(recording);
  show_collar(hand);
  hand.click_model(collar_edge, Viewport::PerspectiveView, 2);
  hand.act("smooth");
  hand.act("sharper");
  hand.act("face-mode");
  hand.act("select-all");
  hand.act("shrink");
  hand.act("select-all");
  hand.act("move");
  hand.act("to-vertices");
  hand.act("pin");
  hand.act("finer");
  hand.act("undo");
  hand.settle();
  const ContentHash done = content_hash(hand.studio().session().document());
  StudioFixture other;
  app::play(other.window(),
            recorded::parse(read_file(recording.toStdString()), "session.jsonl", recorded::all_steps()));
  CHECK(content_hash(other.studio().session().document()) == done);
}

TEST_CASE("a large mesh is read while the window goes on, and can be given up", "[mesh-views]") {
  StudioFixture hand;
  PolyMesh grid;
  constexpr Index side = 500;
  for (Index y = 0; y <= side; ++y) {
    for (Index x = 0; x <= side; ++x) grid.positions.emplace_back(x, y, 8 * std::sin(0.05 * x) * std::cos(0.05 * y));
  }
  for (Index y = 0; y < side; ++y) {
    for (Index x = 0; x < side; ++x) {
      const Index first = y * (side + 1) + x;
      grid.add_face(std::vector<Index>{first, first + 1, first + side + 2, first + side + 1});
    }
  }
  Progress progress;
  const QString file = hand.folder() + "/grid.obj";
  std::ofstream(file.toStdString()) << write_mesh(grid, MeshFormat::Obj, {}, progress).bytes;
  int ticks = 0;
  QTimer ticking;
  QObject::connect(&ticking, &QTimer::timeout, [&] { ++ticks; });
  ticking.start(5);
  app::begin_open(hand.window(), {file});
  CHECK(hand.window().files().reader().busy());
  CHECK(hand.wait_for([&] { return hand.window().settled(); }));
  CHECK(ticks > 0);
  CHECK(faces_shown(hand) == std::size_t{side} * side);
  CHECK(!hand.viewport().objects().surfaces().empty());
  app::import_files(hand.window(), {file});
  hand.window().files().reader().cancel();
  CHECK(hand.wait_for([&] { return !hand.window().files().reader().busy(); }));
  CHECK(hand.studio().objects().size() == 1);
}
