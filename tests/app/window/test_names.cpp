// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <map>
#include <set>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "app/dialogs.h"
#include "app/panels/lists.h"
#include "app/studio_fixture.h"
#include "app/tools/silhouette/part_names.h"
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

TEST_CASE("parts of a sketch that are no figure have numbers, not the names of strokes and operations", "[names]") {
  StudioFixture hand;
  hand.draw(linked_rings_sketch());
  hand.settle();
  const auto rows = part_rows(hand);
  REQUIRE(rows.size() == 2);
  for (std::size_t row = 0; row < 2; ++row) {
    CHECK(rows[row]->text(0) == "Part " + QString::number(row + 1));
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

namespace {

std::multiset<QString> names_in(StudioFixture& hand) {
  std::multiset<QString> names;
  for (const QTreeWidgetItem* row : part_rows(hand)) names.insert(row->text(0));
  return names;
}

/// A solid's parts by name, with where the middle of the first stroke's box is.
std::map<QString, Vec2> places_of_names(const Drawing& drawing, const InflateResult& inflated) {
  const std::vector<QString> names = app::part_names(drawing, inflated);
  std::map<QString, Vec2> places;
  for (std::size_t i = 0; i < names.size(); ++i) {
    Eigen::AlignedBox2d box;
    const Stroke& stroke = *find_stroke(drawing, inflated.objects[i].strokes.front());
    for (const StrokeSample& sample : stroke.samples) box.extend(sample.position);
    places[names[i]] = box.center();
  }
  return places;
}

}  // namespace

TEST_CASE("parts of an animal are named by their places, mirrored and scaled alike", "[names]") {
  StudioFixture hand;
  hand.window().set_unattended();
  REQUIRE(hand.window().open(CROQUIS_SOURCE_DIR "/examples/data/dog.svg"));
  hand.settle();
  const std::multiset<QString> dog{"Body", "Head", "Ear", "Leg 1", "Leg 2", "Leg 3", "Leg 4", "Tail"};
  CHECK(names_in(hand) == dog);
  const Drawing drawing = hand.studio().drawing();
  const auto evaluation = hand.studio().result();
  InflateResult inflated = *result_of<InflateResult>(evaluation.get());
  const auto as_drawn = places_of_names(drawing, inflated);
  Drawing changed = drawing;
  for (Stroke& stroke : changed.strokes) {
    for (StrokeSample& sample : stroke.samples) sample.position = {-3 * sample.position.x(), 3 * sample.position.y()};
  }
  for (SuggestedJoint& joint : inflated.suggested) joint.at = {-3 * joint.at.x(), 3 * joint.at.y()};
  for (auto& joint : inflated.attached) joint.at = {-3 * joint.at.x(), 3 * joint.at.y()};
  const auto mirrored = places_of_names(changed, inflated);
  REQUIRE(mirrored.size() == as_drawn.size());
  for (const auto& [name, place] : as_drawn) {
    // The first leg from the left is the last one then.
    const QString other = name.startsWith("Leg ") ? "Leg " + QString::number(5 - name.last(1).toInt()) : name;
    INFO(name.toStdString());
    REQUIRE(mirrored.contains(other));
    CHECK((mirrored.at(other) - Vec2(-3 * place.x(), 3 * place.y())).norm() < 1e-6);
  }
}

TEST_CASE("people rename a part in the list, which is one step and stays with the file", "[names]") {
  StudioFixture hand;
  hand.window().set_unattended();
  REQUIRE(hand.window().open(CROQUIS_SOURCE_DIR "/examples/data/dog.svg"));
  hand.settle();
  const auto row_named = [&](const QString& name) -> QTreeWidgetItem* {
    for (QTreeWidgetItem* row : part_rows(hand)) {
      if (row->text(0) == name) return row;
    }
    return nullptr;
  };
  REQUIRE(row_named("Tail") != nullptr);
  const std::size_t steps = hand.studio().session().undo_labels().size();
  row_named("Tail")->setText(0, "Wagging tail");
  CHECK(hand.wait_for([&] { return row_named("Wagging tail") != nullptr; }));
  hand.settle();
  CHECK(row_named("Wagging tail") != nullptr);
  CHECK(hand.studio().session().undo_labels().size() == steps + 1);
  const QString path = hand.folder() + "/dog.croq";
  hand.window().files().save(path);
  REQUIRE(hand.window().open(path));
  hand.settle();
  REQUIRE(row_named("Wagging tail") != nullptr);
  row_named("Wagging tail")->setText(0, "");
  CHECK(hand.wait_for([&] { return row_named("Tail") != nullptr; }));
}
