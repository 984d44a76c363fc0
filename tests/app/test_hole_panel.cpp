// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QComboBox>
#include <QFile>
#include <QFileInfo>
#include <QPushButton>
#include <QSpinBox>
#include <QTest>

#include "app/hole_scans.h"
#include "app/replay/replay_player.h"
#include "app/tools/holes/hole_table.h"
#include "croquis/document/content_hash.h"
#include "croquis/io/file.h"
#include "support/meshes/mesh_shapes.h"

using namespace croquis;
using namespace croquis::test;

namespace {

template <typename Widget>
Widget& child(StudioFixture& hand, const char* name) {
  return *hand.window().findChild<Widget*>(name);
}

void choose(QComboBox& box, const char* value) {
  box.setCurrentIndex(box.findData(QString(value)));
  emit box.activated(box.currentIndex());
}

void slide_to(StudioFixture& hand, double diameter) {
  app::SizeSlider& sizes = child<app::SizeSlider>(hand, "size-slider");
  sizes.set_diameter(diameter);
  emit sizes.moved(diameter);
}

std::vector<Index> by_width(StudioFixture& hand) {
  std::vector<HoleRow> rows = holes(hand).rows;
  std::sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.diameter < b.diameter; });
  std::vector<Index> ids;
  for (const HoleRow& row : rows) ids.push_back(row.id);
  return ids;
}

double width_of(StudioFixture& hand, Index hole) { return holes(hand).row(hole)->diameter * (1 + 1e-9); }

bool is_enabled(StudioFixture& hand, const char* action) { return hand.window().action(action)->isEnabled(); }

}  // namespace

TEST_CASE("a preset is chosen beside the ways of patches, for all holes, and recorded", "[hole-panel]") {
  StudioFixture hand;
  const QString recording = hand.folder() + "/session.jsonl";
  hand.window().record_to(recording);
  open_scan(hand, ball_with_holes(2));
  auto& presets = child<QComboBox>(hand, "hole-preset");
  CHECK(presets.currentData().toString() == "auto");
  for (const char* preset : {"auto", "standard", "sharp", "noisy", "paper"})
    CHECK(presets.findData(QString(preset)) >= 0);
  choose(presets, "noisy");
  hand.settle();
  CHECK(last_step(hand) == "Preset noisy of all holes");
  CHECK(app::text_parameter(holes(hand), "preset") == "noisy");
  const std::size_t steps = hand.studio().session().undo_labels().size();
  choose(presets, "noisy");
  CHECK(hand.studio().session().undo_labels().size() == steps);
  CHECK(read_file(recording.toStdString()).find(R"("parameter":"preset","value":"noisy")") != std::string::npos);
  hand.act("undo");
  hand.settle();
  CHECK(presets.currentData().toString() == "auto");
}

TEST_CASE("filling up to a size fills the open holes alone, opens none, and says why it can't", "[hole-panel]") {
  StudioFixture hand;
  open_scan(hand, ball_with_holes());
  auto& button = child<QPushButton>(hand, "fill-sizes");
  CHECK(!button.isEnabled());
  CHECK(button.toolTip().startsWith("Drag the slider"));
  const std::vector<Index> holes_by_width = by_width(hand);
  holes(hand).select({holes_by_width[0], holes_by_width[5]});
  hand.act("fill-selected");
  hand.settle();
  const double limit = width_of(hand, holes_by_width[2]);
  slide_to(hand, limit);
  CHECK(holes(hand).selected() == app::open_up_to(holes(hand), limit));
  CHECK(holes(hand).selected().size() == 2);
  CHECK(button.text().startsWith("Fill 2 up to"));
  button.click();
  hand.settle();
  CHECK(count(hand, FillAction::Fill) == 4);
  CHECK(holes(hand).row(holes_by_width[5])->state == FillAction::Fill);  // wider than that, and filled before
  CHECK(!button.isEnabled());
  CHECK(button.toolTip() == "No hole that small is open");
  slide_to(hand, width_of(hand, holes_by_width[3]));
  CHECK(button.isEnabled());
  CHECK(button.text().startsWith("Fill 1 up to"));
}

TEST_CASE("what fills or opens all holes can be chosen where it would change something", "[hole-panel]") {
  StudioFixture hand;
  open_scan(hand, ball_with_holes(3));
  CHECK(is_enabled(hand, "fill-inner"));
  CHECK(is_enabled(hand, "fill-all-but-largest"));
  CHECK(!is_enabled(hand, "reopen-all"));
  hand.act("fill-all-but-largest");
  hand.settle();
  CHECK(!is_enabled(hand, "fill-all-but-largest"));
  CHECK(is_enabled(hand, "fill-inner"));
  hand.act("fill-inner");
  hand.settle();
  CHECK(!is_enabled(hand, "fill-inner"));
  CHECK(!is_enabled(hand, "fill-all"));
  CHECK(is_enabled(hand, "fill-all-but-largest"));
  CHECK(is_enabled(hand, "reopen-all"));
}

TEST_CASE("where a mesh has no holes nothing can be filled or opened", "[hole-panel]") {
  StudioFixture hand;
  open_scan(hand, test::round_sphere(3));
  REQUIRE(holes(hand).rows.empty());
  for (const char* name : {"fill-inner", "fill-all-but-largest", "fill-all", "reopen-all", "fill-selected"}) {
    INFO(name);
    CHECK(!is_enabled(hand, name));
  }
  CHECK(!hand.window().findChild<QPushButton*>("fill-inner-button")->isEnabled());
}

TEST_CASE("all holes are opened, also those whose patches were shaped or bridged", "[hole-panel]") {
  StudioFixture hand;
  const PolyMesh below = open_tube(1, 2, 16, 8);
  PolyMesh above = below;
  for (Vec3& place : above.positions) place.z() += 2.5;
  open_scan(hand, merged(below, above));
  std::vector<Index> facing;
  std::vector<Index> ends;
  for (const HoleRow& row : holes(hand).rows)
    (row.kind == hole_filling::HoleClass::Tunnel ? facing : ends).push_back(row.id);
  REQUIRE(facing.size() == 2);
  REQUIRE(ends.size() == 2);
  holes(hand).select(facing);
  hand.act("bridge-holes");
  holes(hand).select(ends);
  hand.act("fill-selected");
  hand.settle();
  REQUIRE(count(hand, FillAction::Fill) == 4);
  app::set_method(holes(hand), {.bulge = 0.3}, false);
  hand.settle();
  SECTION("reopen all") {
    hand.act("reopen-all");
    hand.settle();
    CHECK(count(hand, FillAction::Fill) == 0);
    hand.act("undo");
    hand.settle();
    CHECK(count(hand, FillAction::Fill) == 4);
  }
  SECTION("filling the inner ones opens no border") {
    holes(hand).select({facing[0]});
    hand.act("reopen-selected");
    hand.settle();
    hand.act("fill-inner");
    hand.settle();
    CHECK(count(hand, FillAction::Fill) == 4);
  }
}

TEST_CASE("where a bridge can't be made its rims are filled one by one", "[hole-panel]") {
  StudioFixture hand;
  PolyMesh ball = round_sphere(3);
  for (const double side : {1.0, -1.0}) ball = without_loose_vertices(cut(ball, Vec3(0, 0, side), 0.4).mesh);
  PolyMesh in_the_way = round_sphere(2);
  for (Vec3& place : in_the_way.positions) place *= 0.8;
  open_scan(hand, merged(ball, in_the_way));
  REQUIRE(holes(hand).rows.size() == 2);
  holes(hand).select({0, 1});
  hand.act("bridge-holes");
  hand.settle();
  REQUIRE(count(hand, FillAction::Failed) == 2);
  CHECK(label(hand, "help-line").startsWith("No method gave a valid patch here"));
  CHECK(is_enabled(hand, "fill-selected"));
  hand.act("fill-selected");
  hand.settle();
  CHECK(count(hand, FillAction::Fill) == 2);
  CHECK(!is_enabled(hand, "fill-selected"));
}

TEST_CASE("patches are coloured too where rims were trimmed and where the model was made anew", "[hole-panel]") {
  StudioFixture hand;
  const Vec3 towards_eye = Vec3(1, 0.8, 1.2).normalized();
  open_scan(hand, without_loose_vertices(cut(round_sphere(4), towards_eye, 0.5).mesh));
  hand.act("fill-inner");
  const auto share_of_yellow = [&] {
    hand.settle();
    return share_of_pixels(hand.picture(), hand.viewport().pane(app::Viewport::PerspectiveView).rect,
                           [](const QColor& color) { return color.saturation() > 140 && color.hue() < 170; });
  };
  hand.act("tint-patches");
  const double tinted = share_of_yellow();
  CHECK(tinted > 0.02);
  app::set_method(holes(hand), {.trim_rim = 1});
  CHECK(share_of_yellow() > 0.8 * tinted);
  hand.act("tint-patches");
  CHECK(share_of_yellow() < 0.2 * tinted);
  hand.act("tint-patches");
  app::set_method(holes(hand), {.trim_rim = 0});
  app::set_mode(holes(hand), "remesh");
  CHECK(share_of_yellow() > 0.8 * tinted);
  CHECK(!child<QLabel>(hand, "remesh-estimate").isVisible());
}

TEST_CASE("a field of numbers leaves undo and the names of tools to the window", "[hole-panel]") {
  StudioFixture hand;
  open_scan(hand, ball_with_holes(2));
  auto& trim = child<QSpinBox>(hand, "trim-rim");
  const auto offered = [&trim](int key, Qt::KeyboardModifiers modifiers, const QString& text) {
    QKeyEvent event(QEvent::ShortcutOverride, key, modifiers, text);
    event.ignore();
    QApplication::sendEvent(&trim, &event);
    return !event.isAccepted();
  };
  trim.setFocus();
  trim.stepUp();
  CHECK(offered(Qt::Key_Z, Qt::ControlModifier, "\x1a"));
  CHECK(offered(Qt::Key_O, Qt::NoModifier, "o"));
  CHECK(offered(Qt::Key_F, Qt::ShiftModifier, "F"));
  CHECK(offered(Qt::Key_E, Qt::ControlModifier, "\x05"));
  CHECK(!offered(Qt::Key_2, Qt::NoModifier, "2"));
  CHECK(!offered(Qt::Key_C, Qt::ControlModifier, "\x03"));
  QTest::keyClick(&trim, Qt::Key_2);
  CHECK(!offered(Qt::Key_Z, Qt::ControlModifier, "\x1a"));  // takes back what was typed
}

TEST_CASE("the line below speaks of what is there: holes, and files that can't be read", "[hole-panel]") {
  StudioFixture hand;
  open_scan(hand, ball_with_holes(2));
  hand.act("fill-inner");
  hand.settle();
  for (const char* tool : {"select", "move", "rotate"}) {
    hand.act(tool);
    hand.mesh().set_mesh_mode(MeshMode::Object);
    CHECK(label(hand, "help-line").startsWith("O goes back to its holes"));
  }
  const QString damaged = hand.folder() + "/damaged.ply";
  QFile file(damaged);
  REQUIRE(file.open(QIODevice::WriteOnly));
  file.write("ply\nformat ascii 1.0\nelement vertex 40000000\nproperty float x\nend_header\n");
  file.close();
  const std::size_t objects = hand.studio().objects().size();
  app::import_files(hand.window(), {damaged});
  REQUIRE(hand.wait_for([&] { return label(hand, "message").contains("damaged.ply"); }));
  CHECK(!label(hand, "message").contains(hand.folder()));
  CHECK(hand.studio().objects().size() == objects);
  const auto& message = child<QLabel>(hand, "message");
  CHECK(hand.wait_for([&] { return message.fontMetrics().horizontalAdvance(message.text()) <= message.width(); }));
  hand.drag_pixels({300, 300}, {300, 300}, Qt::LeftButton, Qt::NoModifier);
  CHECK(label(hand, "message").isEmpty());
}
