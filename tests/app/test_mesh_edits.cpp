// SPDX-License-Identifier: GPL-3.0-or-later
// Edits from the menu, with numbers in a panel; and edits of a sketch's solid.
#include <QAction>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QToolBar>
#include <functional>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "app/hand_on_meshes.h"
#include "app/panels/attribute_panel.h"
#include "croquis/document/content_hash.h"
#include "croquis/tools/recording/recording.h"
#include "support/sketches/sketch_gallery.h"

using namespace croquis;
using croquis::test::cage;
using croquis::test::centred_cube;
using croquis::test::open_mesh;
using croquis::test::StudioFixture;

namespace {

QAction& action(StudioFixture& hand, const char* name) { return *hand.window().findChild<QAction*>(name); }

ContentHash document_hash(StudioFixture& hand) { return content_hash(hand.studio().session().document()); }

void pick_faces(StudioFixture& hand, const Elements& faces) {
  hand.act("face-mode");
  hand.mesh().act([&](MeshTool& tool) { return tool.selection().pick(ComponentKind::Face, faces); });
  hand.settle();
}

/// What the work on meshes records.
std::vector<std::string> recorded_by(StudioFixture& hand, const std::function<void()>& work) {
  std::vector<std::string> lines;
  const auto connection = QObject::connect(&hand.mesh(), &app::Tool::committed,
                                           [&](const auto& step) { lines.push_back(recorded::to_line(step)); });
  work();
  QObject::disconnect(connection);
  return lines;
}

}  // namespace

TEST_CASE("an edit of the menu begins with numbers, which its panel changes, in one step of the history",
          "[mesh-edits]") {
  StudioFixture hand;
  open_mesh(hand, centred_cube(), "box");
  QAction& inset = action(hand, "edit-inset");
  CHECK_FALSE(inset.isEnabled());
  hand.act("vertex-mode");
  hand.mesh().act([](MeshTool& tool) { return tool.selection().select_all(); });
  CHECK_FALSE(inset.isEnabled());  // it takes faces
  pick_faces(hand, {1, 2});
  CHECK(inset.isEnabled());
  auto* dock = hand.window().findChild<QDockWidget*>("last-edit-dock");
  REQUIRE(dock != nullptr);
  CHECK_FALSE(dock->isVisible());
  const ContentHash before = document_hash(hand);
  const std::size_t steps = hand.studio().session().undo_labels().size();

  auto lines = recorded_by(hand, [&] { hand.act("edit-inset"); });
  hand.settle();
  CHECK(cage(hand).face_count() > 6);
  REQUIRE(lines.size() == 1);
  CHECK(lines.front().find("\"line\":\"inset faces=1-2 width=0.") != std::string::npos);
  CHECK(hand.studio().session().components().elements.size() == 2);
  CHECK(dock->isVisible());
  CHECK(dock->findChild<QLabel*>("last-edit-title")->text() == "Inset 2 faces");

  auto* field = dock->findChild<app::ParameterField*>("width");
  REQUIRE(field != nullptr);
  auto* box = field->findChild<QDoubleSpinBox*>();
  CHECK(box->value() > 0);
  lines = recorded_by(hand, [&] { box->setValue(0.125); });
  CHECK(lines ==
        std::vector<std::string>{R"({"do":"edit","node":"box","line":"inset faces=1-2 width=0.125","again":true})"});
  CHECK(hand.studio().session().undo_labels().size() == steps + 1);
  CHECK(hand.studio().session().undo_labels().back() == "Inset 2 faces");
  box->setValue(50);  // there is no room for that
  CHECK(box->value() == 0.125);
  CHECK(hand.studio().session().undo_labels().size() == steps + 1);
  CHECK(dock->isVisible());

  hand.act("undo");
  hand.settle();
  CHECK(document_hash(hand) == before);
  CHECK_FALSE(dock->isVisible());
}

TEST_CASE("faces of a sketch's solid are picked and extruded, and undo gives the plain solid back", "[mesh-edits]") {
  StudioFixture hand;
  hand.draw(test::snake_sketch());
  hand.settle();
  auto* bar = hand.window().findChild<QToolBar*>("mesh-tools");
  REQUIRE(bar != nullptr);
  CHECK_FALSE(bar->isVisible());
  CHECK_FALSE(action(hand, "extrude").isEnabled());
  CHECK(hand.studio().active()->cage == 0);
  const ContentHash before = document_hash(hand);
  const std::size_t faces = hand.studio().solid()->face_count();

  pick_faces(hand, {10});
  CHECK(bar->isVisible());
  CHECK(action(hand, "extrude").isEnabled());
  CHECK(document_hash(hand) == before);
  const auto lines = recorded_by(hand, [&] { hand.act("extrude"); });
  CHECK(lines.size() == 1);
  hand.settle();
  CHECK(hand.studio().active()->mesh->face_count() > faces);
  CHECK(hand.studio().solid()->face_count() == faces);
  CHECK(hand.studio().session().components().elements.size() == 1);
  hand.mesh().act([](MeshTool& tool) { return tool.take(recorded::Move{.by = {0, 0, 0.5}}); });
  hand.settle();
  CHECK(hand.studio().session().document().nodes().size() == 3);

  hand.act("undo");
  hand.act("undo");
  hand.settle();
  CHECK(document_hash(hand) == before);
  CHECK(hand.studio().active()->mesh->face_count() == faces);
  hand.act("object-mode");
  CHECK(hand.studio().active()->cage == 0);
  CHECK_FALSE(action(hand, "extrude").isEnabled());
}
