// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QPushButton>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>
#include <map>

#include "app/hole_scans.h"
#include "app/panels/lists.h"
#include "app/replay/replay_player.h"
#include "croquis/base/error.h"
#include "croquis/document/content_hash.h"
#include "croquis/io/file.h"
#include "croquis/tools/all_steps.h"
#include "support/meshes/mesh_shapes.h"

using namespace croquis;
using namespace croquis::test;

namespace {

/// Rows of the outliner that stand for named faces.
std::map<std::string, QTreeWidgetItem*> set_rows(StudioFixture& hand) {
  std::map<std::string, QTreeWidgetItem*> rows;
  for (QTreeWidgetItemIterator row(hand.window().findChild<app::ObjectList*>("objects")); *row != nullptr; ++row) {
    if (const auto parts = app::ObjectList::parts_of(*row); !parts.empty()) rows[parts.front()] = *row;
  }
  return rows;
}

void click_set(StudioFixture& hand, const std::string& name) {
  auto* list = hand.window().findChild<app::ObjectList*>("objects");
  list->clearSelection();
  QTreeWidgetItem* row = set_rows(hand).at(name);
  row->setSelected(true);
  emit list->itemClicked(row, 0);
}

const std::vector<std::int32_t>& patch_ids(const PolyMesh& mesh) {
  return std::get<std::vector<std::int32_t>>(mesh.channel("patch_id", Domain::Face)->data);
}

std::vector<Index> selected_faces(StudioFixture& hand) {
  return hand.studio().face_sets().selected(*hand.studio().active(), hand.studio().session().selection());
}

/// Positions of a patch's faces, corner by corner.
std::vector<Vec3> places_of_patch(StudioFixture& hand, Index hole) {
  const PolyMesh& mesh = filled_mesh(hand);
  std::vector<Vec3> places;
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    if (patch_ids(mesh)[face] != static_cast<std::int32_t>(holes(hand).row(hole)->patch.value())) continue;
    for (const Index vertex : mesh.face(face)) places.push_back(mesh.positions[vertex]);
  }
  return places;
}

}  // namespace

TEST_CASE("each patch is a named set of faces, selected by the outliner and brought back by undo", "[patches]") {
  StudioFixture hand;
  const QString recording = hand.folder() + "/session.jsonl";
  hand.window().record_to(recording);
  open_scan(hand, ball_with_holes());
  CHECK(set_rows(hand).empty());
  hand.act("fill-inner");
  hand.settle();
  const auto rows = set_rows(hand);
  REQUIRE(rows.size() == 7);
  CHECK(rows.at("patches")->childCount() == 6);
  click_set(hand, "patch of hole 2");
  const std::vector<Index> faces = selected_faces(hand);
  CHECK(!faces.empty());
  for (std::size_t face = 0; face < filled_mesh(hand).face_count(); ++face) {
    const bool is_in = patch_ids(filled_mesh(hand))[face] == static_cast<std::int32_t>(*holes(hand).row(2)->patch);
    CHECK(is_in == std::binary_search(faces.begin(), faces.end(), static_cast<Index>(face)));
  }
  CHECK(holes(hand).selected() == std::vector<Index>{2});
  CHECK(set_rows(hand).at("patch of hole 2")->isSelected());

  // Patches change their numbers when another hole is opened: the set is of the hole.
  holes(hand).select({0});
  hand.act("reopen-selected");
  hand.settle();
  CHECK(set_rows(hand).size() == 6);
  CHECK(selected_faces(hand).size() == faces.size());
  click_set(hand, "patches");
  CHECK(selected_faces(hand).size() > faces.size());
  hand.act("undo");
  hand.settle();
  CHECK(selected_faces(hand) == faces);
  hand.act("deselect");
  CHECK(selected_faces(hand).empty());

  StudioFixture other;
  const std::string text = read_file(recording.toStdString());
  app::play(other.window(), recorded::parse(text, "session.jsonl", recorded::all_steps()));
  CHECK(text.find(R"({"do":"face-set","node":"scan","names":["patch of hole 2"]})") != std::string::npos);
  CHECK(other.studio().session().selection() == hand.studio().session().selection());
  CHECK_THROWS_AS(
      app::play(other.window(), recorded::parse(R"({"do":"face-set","node":"scan","names":["patch of hole 99"]})",
                                                "bad.jsonl", recorded::all_steps())),
      Error);
}

TEST_CASE("a frozen scan keeps its patches as sets of faces that can be worked on, in projects too", "[patches]") {
  StudioFixture hand;
  open_scan(hand, ball_with_holes());
  hand.act("fill-inner");
  hand.settle();
  const std::size_t faces = filled_mesh(hand).face_count();
  hand.act("freeze");
  hand.settle();
  CHECK(last_step(hand) == "Freeze scan filled");
  CHECK(!holes(hand).active);
  CHECK(hand.studio().active()->cage_mesh->face_count() == faces);
  const QString project = hand.folder() + "/scan.croq";
  hand.window().files().save(project);
  StudioFixture other;
  REQUIRE(other.window().open(project));
  other.settle();
  app::select_face_sets(other.window(), other.studio().objects().back().node, {"patch 3"});
  const ComponentSelection& picked = other.studio().session().components();
  CHECK(picked.kind == ComponentKind::Face);
  REQUIRE(!picked.empty());
  const std::size_t picked_count = picked.elements.size();
  const PolyMesh& mesh = *other.studio().active()->cage_mesh;
  for (const Index face : picked.elements) CHECK(patch_ids(mesh)[face] == 3);
  other.act("delete");
  other.settle();
  CHECK(last_step(other) == "Delete " + std::to_string(picked_count) + " faces");
  CHECK(other.studio().active()->cage_mesh->face_count() == faces - picked_count);
  other.act("undo");
  CHECK(other.studio().active()->cage_mesh->face_count() == faces);
  CHECK(other.studio().session().components().elements.size() == picked_count);
}

TEST_CASE("a hole that is brought near is seen from its front, inside-out scans or not", "[patch-views]") {
  for (const bool turned : {false, true}) {
    StudioFixture hand;
    const PolyMesh ball = ball_with_holes();
    open_scan(hand, turned ? flipped(ball) : ball);
    for (const Index hole : {Index{0}, Index{1}, Index{2}, Index{3}}) {
      holes(hand).select({hole});
      hand.act("frame-selection");
      const auto& camera = hand.viewport().pane(app::PerspectiveView).camera;
      const glm::dvec3 to_eye = glm::normalize(camera.eye - camera.target);
      const Vec3 out = holes(hand).row(hole)->at.normalized();
      CHECK(out.dot(Vec3(to_eye.x, to_eye.y, to_eye.z)) > 0.4);
    }
    const bool can_reopen = hand.window().action("reopen-selected")->isEnabled();
    CHECK(!can_reopen);
    hand.act("fill-selected");
    hand.settle();
    CHECK(hand.window().action("reopen-selected")->isEnabled());
    CHECK(!hand.window().action("fill-selected")->isEnabled());
    hand.act("undo");
    hand.act("undo");
    hand.settle();
    CHECK(hand.window().tool<app::HoleFillingTool>().words().help.startsWith("O "));
  }
}

TEST_CASE("where holes were filled no line is left in the picture", "[patch-views]") {
  StudioFixture hand;
  const auto share_of_lines = [&] {
    hand.settle();
    const QRect solid = box_of_solid(hand);
    const double ratio = hand.picture().devicePixelRatio();
    const QRectF inside(solid.x() / ratio + solid.width() / ratio / 4, solid.y() / ratio + solid.height() / ratio / 4,
                        solid.width() / ratio / 2, solid.height() / ratio / 2);
    return share_of_pixels(hand.picture(), inside, [](const QColor& color) { return color.lightness() < 100; });
  };
  const Vec3 towards_eye = Vec3(1, 0.8, 1.2).normalized();
  open_scan(hand, without_loose_vertices(cut(round_sphere(4), towards_eye, 0.35).mesh));
  hand.act("fill-inner");
  hand.settle();
  hand.act("select");
  CHECK(share_of_lines() == 0);
  hand.act("undo");
  CHECK(share_of_lines() > 0.001);
}

TEST_CASE("another kernel of one hole changes its patch alone", "[patch-views]") {
  StudioFixture hand;
  open_scan(hand, ball_with_holes());
  hand.act("fill-inner");
  hand.settle();
  std::map<Index, std::vector<Vec3>> before;
  for (Index hole = 0; hole < 6; ++hole) before[hole] = places_of_patch(hand, hole);
  holes(hand).select({4});
  app::set_method(holes(hand), {.kernel = "biharmonic"});
  hand.settle();
  CHECK(last_step(hand) == "Kernel biharmonic of hole 4");
  for (Index hole = 0; hole < 6; ++hole) {
    INFO(hole);
    CHECK((places_of_patch(hand, hole) == before[hole]) == (hole != 4));
  }
  CHECK(app::method_of_selected(holes(hand)).kernel == "biharmonic");
  hand.act("deselect");
  CHECK(app::method_of_selected(holes(hand)).kernel == "hermite");
  hand.act("undo");
  hand.settle();
  CHECK(places_of_patch(hand, 4) == before[4]);
}

TEST_CASE("a cancelled making anew changes nothing, and the window works on", "[hole-sessions]") {
  StudioFixture hand;
  open_scan(hand, without_loose_vertices(random_cuts(round_sphere(6), 7, 6, 0.15, 0.3).mesh));
  holes(hand).select({1});
  hand.act("fill-selected");
  hand.settle();
  const ContentHash document = content_hash(hand.studio().session().document());
  const auto steps = hand.studio().session().undo_labels();
  const std::size_t faces = filled_mesh(hand).face_count();
  auto* cancel = hand.window().findChild<QPushButton*>("cancel");
  REQUIRE(hand.wait_for([&] { return label(hand, "hole-check").contains("outside unchanged"); }));
  app::set_mode(holes(hand), "remesh");
  REQUIRE(hand.wait_for([&] { return cancel->isVisible(); }));
  // What is seen meanwhile are the patches, and that is what is said of them.
  CHECK(label(hand, "hole-check").contains("outside unchanged"));
  cancel->click();
  hand.settle();
  CHECK(content_hash(hand.studio().session().document()) == document);
  CHECK(hand.studio().session().undo_labels() == steps);
  CHECK(filled_mesh(hand).face_count() == faces);
  CHECK(holes(hand).row(1)->state == FillAction::Fill);
  CHECK(!cancel->isVisible());
  holes(hand).select({2});
  hand.act("fill-selected");
  hand.settle();
  CHECK(count(hand, FillAction::Fill) == 2);
  app::export_solid(hand.studio(), hand.folder() + "/filled.ply");
}

TEST_CASE("move and rotate leave the holes as they are, and holes come back with their selection", "[patch-views]") {
  StudioFixture hand;
  open_scan(hand, ball_with_holes());
  holes(hand).select({2});
  hand.act("fill-selected");
  hand.settle();
  const ContentHash document = content_hash(hand.studio().session().document());
  auto* dock = hand.window().findChild<QWidget*>("holes-dock");
  for (const auto& [name, handles] : {std::pair{"move", MeshHandles::Move}, {"rotate", MeshHandles::Rotate}}) {
    hand.act(name);
    CHECK(!holes(hand).active);
    CHECK(!dock->isVisible());
    CHECK(hand.mesh().tool().handles() == handles);
    hand.act("holes");
    hand.settle();
    CHECK(holes(hand).active);
    CHECK(dock->isVisible());
    CHECK(count(hand, FillAction::Fill) == 1);
    CHECK(hand.mesh().tool().handles() == MeshHandles::Select);
  }
  CHECK(content_hash(hand.studio().session().document()) == document);
}
