// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFile>
#include <QFileDialog>
#include <QLabel>

#include <catch2/catch.hpp>

#include "app/dialogs.h"
#include "app/panels/lists.h"
#include "app/studio_fixture.h"
#include "croquis/io/mesh_file.h"
#include "support/meshes/mesh_shapes.h"
#include "support/sketches/sketch_gallery.h"

using namespace croquis;
using namespace croquis::test;

namespace {

void open_mesh(StudioFixture& hand, const PolyMesh& mesh, const QString& name) {
  Progress progress;
  const std::string bytes = write_mesh(mesh, MeshFormat::Obj, {}, progress).bytes;
  QFile file(hand.folder() + "/" + name + ".obj");
  REQUIRE(file.open(QIODevice::WriteOnly));
  file.write(bytes.data(), static_cast<qint64>(bytes.size()));
  file.close();
  REQUIRE(hand.window().open(file.fileName()));
  hand.settle();
}

QStringList findings_shown(StudioFixture& hand) {
  QStringList texts;
  for (const QListWidgetItem* row : rows_of(*hand.window().findChild<app::FindingsList*>("findings"))) {
    texts << row->text();
  }
  return texts;
}

}  // namespace

TEST_CASE("meshes are listed by names that people would give, and keep those of their files", "[names]") {
  CHECK(readable_name("hex_bolt") == "Hex bolt");
  CHECK(readable_name("pumpkin__scan_2") == "Pumpkin scan 2");
  for (const char* name : {"bolt", "Hex bolt", "_", "cup 2", ""}) CHECK(readable_name(name) == name);

  StudioFixture hand;
  open_mesh(hand, cube(), "hex_bolt");
  auto* list = hand.window().findChild<app::ObjectList*>("objects");
  CHECK(list->topLevelItem(0)->text(0) == "Hex bolt");
  CHECK(hand.window().findChild<QLabel*>("counts")->text().startsWith("Hex bolt: 6 faces"));
  CHECK(hand.studio().objects()[0].name == "hex_bolt");
  // The eye alone renames nothing.
  list->topLevelItem(0)->setCheckState(0, Qt::Unchecked);
  CHECK(hand.wait_for([&] { return !hand.studio().objects()[0].visible; }));
  CHECK(hand.studio().objects()[0].name == "hex_bolt");
  list->topLevelItem(0)->setText(0, "Screw");
  CHECK(hand.wait_for([&] { return hand.studio().objects()[0].name == "Screw"; }));
}

TEST_CASE("the bodies of a sketch have numbers, not the names of strokes and operations", "[names]") {
  StudioFixture hand;
  hand.draw(linked_rings_sketch());
  hand.settle();
  const auto rows = part_rows(hand);
  REQUIRE(rows.size() == 2);
  for (std::size_t row = 0; row < 2; ++row) {
    CHECK(rows[row]->text(0) == "Body " + QString::number(row + 1));
    CHECK(rows[row]->toolTip(0).contains("stroke"));
  }
  CHECK(hand.window().findChild<QLabel*>("counts")->text().startsWith("Sketch: "));
  for (const auto& [action, file] : {std::pair{"export-solid", "Sketch.obj"}, {"save", "Sketch.croq"}}) {
    QString proposed;
    in_dialog<QFileDialog>([&](QFileDialog& dialog) {
      proposed = dialog.selectedFiles().value(0);
      dialog.reject();
    });
    hand.act(action);
    CHECK(proposed.endsWith(file));
  }
}

TEST_CASE("findings name their object where there are several, and only there", "[names]") {
  StudioFixture hand;
  open_mesh(hand, tetrahedra_sharing_edge(), "bad_part");
  hand.act("show-smooth");
  hand.settle();
  REQUIRE(!findings_shown(hand).isEmpty());
  for (const QString& text : findings_shown(hand)) CHECK(!text.startsWith("Bad part:"));
  open_mesh(hand, cube(), "good_part");
  for (const QString& text : findings_shown(hand)) {
    INFO(text.toStdString());
    CHECK(text.startsWith("Bad part: "));
  }
}
