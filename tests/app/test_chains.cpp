// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAbstractButton>
#include <QAction>
#include <QTest>
#include <QTreeWidget>
#include <algorithm>

#include <catch2/catch.hpp>

#include "app/hole_scans.h"
#include "app/panels/lists.h"
#include "app/replay/replay_player.h"
#include "app/studio_fixture.h"
#include "croquis/document/content_hash.h"
#include "croquis/tools/all_steps.h"

namespace croquis::test {
namespace {

/// The rows of steps of the object in that row of the list, from above.
std::vector<QTreeWidgetItem*> step_rows(StudioFixture& hand, int object) {
  const QTreeWidgetItem* row = hand.window().findChild<app::ObjectList*>("objects")->topLevelItem(object);
  std::vector<QTreeWidgetItem*> steps;
  for (int i = 0; i < row->childCount(); ++i) {
    if (app::ObjectList::is_step(row->child(i))) steps.push_back(row->child(i));
  }
  return steps;
}

void choose(StudioFixture& hand, NodeId step) {
  emit hand.window().findChild<app::ObjectList*>("objects")->step_chosen(step);
}

/// A circle by hand, sketch units.
std::vector<Vec2> circle(const Vec2& middle, double radius) {
  std::vector<Vec2> places;
  for (int k = 0; k <= 40; ++k) {
    const double angle = 2 * M_PI * k / 40;
    places.push_back(middle + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return places;
}

/// Pulls the rightmost anchor of the first stroke further out.
void bend_first_stroke(StudioFixture& hand) {
  SketchTool& tool = hand.sketch().tool();
  const std::string stroke = hand.studio().drawing().strokes.front().id;
  const StrokeFit* fit = tool.fit(stroke);
  REQUIRE(fit != nullptr);
  const auto right =
      std::ranges::max_element(fit->anchors, {}, [](const StrokeAnchor& anchor) { return anchor.position.x(); });
  tool.drag(stroke, static_cast<std::size_t>(right - fit->anchors.begin()), {60, 0});
  hand.settle();
}

void add_subdivision(StudioFixture& hand) {
  hand.act("add-step-subdivide");
  hand.studio().set_parameter(active_step(hand.studio()), "levels", std::int64_t{1}, false);
  hand.settle();
}

/// Of few faces: more are slow to draw without a graphics card.
void draw_ball(StudioFixture& hand) {
  hand.window().start_with();
  hand.look_at({-200, -200}, {200, 200});
  hand.draw(circle({0, 0}, 80));
  hand.settle();
  hand.studio().set_parameter(hand.studio().solid_node(), "resolution", 20.0, false);
  hand.settle();
}

/// A solid of which three faces were inset by hand.
void draw_and_inset(StudioFixture& hand) {
  draw_ball(hand);
  hand.act("face-mode");
  hand.settle();
  app::play(hand.window(), recorded::parse(R"({"do":"edit","node":"inflate","line":"inset faces=100-102 width=0.02"})",
                                           "edits.jsonl", recorded::all_steps()));
  hand.settle();
}

/// By the start page's own button.
void recover(StudioFixture& hand) {
  auto* button = hand.window().findChild<QAbstractButton*>("recover");
  REQUIRE(button != nullptr);
  QTest::mouseClick(button, Qt::LeftButton);
  hand.settle();
}

double width_of(const PolyMesh& mesh) {
  double low = mesh.positions.front().x(), high = low;
  for (const Vec3& place : mesh.positions) {
    low = std::min(low, place.x());
    high = std::max(high, place.x());
  }
  return high - low;
}

TEST_CASE("a chain from a sketch stays live, and its steps are switched, moved and frozen", "[chains]") {
  StudioFixture hand;
  draw_ball(hand);
  const std::size_t coarse = hand.studio().objects().front().mesh->face_count();
  add_subdivision(hand);
  const NodeId smooth = active_step(hand.studio());
  REQUIRE(hand.studio().objects().size() == 1);
  CHECK(hand.studio().objects().front().mesh->face_count() > 3 * coarse);
  hand.act("add-step-fill");
  hand.settle();
  const NodeId end = hand.studio().objects().front().node;
  REQUIRE(step_rows(hand, 0).size() == 4);
  CHECK(app::ObjectList::node_of(step_rows(hand, 0)[1]) == smooth);

  // The first stroke is changed, and the end follows.
  const double before = width_of(*hand.studio().object(end)->mesh);
  bend_first_stroke(hand);
  CHECK(width_of(*hand.studio().object(end)->mesh) > before + 30);

  // Off: as many faces as the solid. On again: as before.
  choose(hand, smooth);
  CHECK(hand.window().action("step-on")->isChecked());
  const std::size_t fine = hand.studio().object(end)->mesh->face_count();
  hand.act("step-on");
  hand.settle();
  CHECK(hand.studio().object(end)->mesh->face_count() < fine / 2);
  CHECK(step_rows(hand, 0)[1]->text(1) == "off");
  hand.act("step-on");
  hand.settle();
  CHECK(hand.studio().object(end)->mesh->face_count() == fine);

  // Filled before it is refined, then frozen.
  choose(hand, smooth);
  hand.act("step-later");
  hand.settle();
  CHECK(hand.studio().objects().front().node == smooth);
  CHECK(hand.studio().objects().front().mesh->face_count() == fine);
  choose(hand, end);
  hand.act("freeze-step");
  hand.settle();
  CHECK(hand.studio().objects().front().chain == std::vector<NodeId>{end, smooth});
  CHECK(hand.studio().objects().front().mesh->face_count() == fine);
  hand.act("undo");
  hand.settle();
  CHECK(hand.studio().objects().front().chain.size() == 4);

  const ContentHash last = content_hash(hand.studio().session().document());
  Session& session = hand.studio().session();
  while (session.can_undo()) session.undo();
  CHECK(session.document().nodes().empty());
  while (session.can_redo()) session.redo();
  session.undo();  // the freezing
  CHECK(content_hash(session.document()) == last);
}

TEST_CASE("edits of a solid that became another one wait, keep their result, and are made again by position",
          "[chains]") {
  StudioFixture hand;
  draw_and_inset(hand);
  const WorkObject& object = hand.studio().objects().front();
  const NodeId edit = object.node;
  REQUIRE(step_rows(hand, 0).size() == 3);
  CHECK(step_rows(hand, 0)[0]->text(1).isEmpty());
  CHECK_FALSE(hand.window().action("reapply-step-by-position")->isEnabled());

  const auto shown = hand.studio().objects().front().mesh;
  bend_first_stroke(hand);
  CHECK(step_rows(hand, 0)[0]->text(1) == "needs attention");
  CHECK(hand.studio().objects().front().mesh->face_count() == shown->face_count());  // as it was
  choose(hand, edit);
  REQUIRE(hand.window().action("reapply-step-by-position")->isEnabled());
  hand.act("reapply-step-by-position");
  INFO((hand.window().last_findings().empty() ? std::string("-") : hand.window().last_findings().front().message));
  hand.settle();
  CHECK(step_rows(hand, 0)[0]->text(1).isEmpty());
  CHECK(hand.studio().objects().front().mesh->face_count() != shown->face_count());
}

TEST_CASE("after a crash edits that wait show their last result, what they wait for, and what can be done",
          "[chains]") {
  StudioFixture hand;
  draw_and_inset(hand);
  hand.act("object-mode");
  add_subdivision(hand);
  REQUIRE(step_rows(hand, 0).size() == 4);
  const std::size_t faces = hand.studio().objects().front().mesh->face_count();
  bend_first_stroke(hand);
  const std::vector<std::string> done = hand.studio().session().undo_labels();
  const auto check_waiting = [&] {
    CHECK(step_rows(hand, 0)[0]->text(1) == "waits for Edit");
    CHECK(step_rows(hand, 0)[1]->text(1) == "needs attention");
    REQUIRE(hand.studio().objects().front().mesh);
    CHECK(hand.studio().objects().front().mesh->face_count() == faces);
    CHECK(hand.studio().session().undo_labels() == done);
  };
  check_waiting();
  hand.crash_and_restart();
  recover(hand);
  INFO((hand.window().last_findings().empty() ? std::string("-") : hand.window().last_findings().front().message));
  REQUIRE(hand.studio().objects().size() == 1);
  check_waiting();

  auto* findings = hand.window().findChild<app::FindingsList*>("findings");
  REQUIRE(findings->count() == 3);  // the reason, and two things to do
  CHECK(findings->item(0)->text().contains("other faces"));
  CHECK(findings->item(2)->text().contains("Keep the shape"));
  emit findings->itemClicked(findings->item(1));
  hand.settle();
  for (const QTreeWidgetItem* row : step_rows(hand, 0)) CHECK(row->text(1).isEmpty());
  CHECK(hand.studio().objects().front().mesh->face_count() != faces);
  hand.act("undo");
  hand.settle();
  REQUIRE(step_rows(hand, 0)[1]->text(1) == "needs attention");
  REQUIRE(findings->count() == 3);
  const std::size_t last = hand.studio().objects().front().mesh->face_count();
  emit findings->itemClicked(findings->item(2));
  hand.settle();
  CHECK(hand.studio().objects().front().mesh->face_count() == last);
  CHECK(step_rows(hand, 0).size() == 2);
  while (hand.window().action("undo")->isEnabled()) hand.act("undo");
  CHECK(hand.studio().drawing().strokes.empty());
}

TEST_CASE("sketches side by side have their own solids, and the pen draws in the one worked on", "[chains]") {
  StudioFixture hand;
  hand.window().start_with();
  hand.look_at({-200, -200}, {200, 200});
  hand.draw(circle({-60, 0}, 50));
  hand.settle();
  hand.act("add-sketch");
  CHECK(hand.studio().drawing().strokes.empty());
  hand.draw(circle({70, 0}, 40));
  hand.draw(circle({70, 90}, 30));
  hand.settle();
  REQUIRE(hand.studio().objects().size() == 2);
  CHECK(hand.studio().objects()[0].name == "Sketch");
  CHECK(hand.studio().objects()[1].name == "Sketch 2");
  CHECK(hand.studio().drawing().strokes.size() == 2);
  for (const WorkObject& object : hand.studio().objects()) {
    REQUIRE(object.mesh);
    CHECK(object.mesh->face_count() > 100);
  }
  choose(hand, hand.studio().objects()[0].chain.front());
  CHECK(hand.studio().drawing().strokes.size() == 1);
  hand.draw(circle({-60, 100}, 20));
  hand.settle();
  CHECK(hand.studio().drawing().strokes.size() == 2);
  CHECK(hand.studio().objects()[0].mesh->face_count() > 100);
}

TEST_CASE("a sketch seen from the top stands on its own plane", "[chains]") {
  StudioFixture hand;
  hand.window().start_with();
  hand.act("add-sketch-top");
  hand.look_at({-200, -200}, {200, 200});
  hand.draw(circle({20, 60}, 100));
  hand.settle();
  const WorkObject& object = *hand.studio().active();
  REQUIRE(object.mesh);
  Eigen::AlignedBox3d box;
  for (const Vec3& place : object.mesh->positions) box.extend(place);
  // Up in the sketch is away from the eye of the front view.
  CHECK((box.center() - Vec3(20, 0, -60)).norm() < 5);
  CHECK(box.sizes().x() == Approx(200).epsilon(0.05));
}

TEST_CASE("choosing a step opens the tool that works on it", "[chains]") {
  StudioFixture hand;
  open_scan(hand, ball_with_holes());
  hand.act("fill-all");
  hand.settle();
  add_subdivision(hand);
  const std::vector<NodeId> chain = hand.studio().objects().front().chain;
  REQUIRE(chain.size() == 3);
  hand.act("select");
  const auto mode = [&] { return hand.window().viewport().views().mode; };

  // Within the chain its holes are those of its own result: the end has none left.
  choose(hand, chain[1]);
  hand.settle();
  CHECK(mode() == "holes");
  REQUIRE(holes(hand).rows.size() == 6);
  CHECK(count(hand, FillAction::Fill) == 6);
  const std::size_t faces = hand.studio().objects().front().mesh->face_count();
  holes(hand).select({1});
  hand.act("reopen-selected");
  hand.settle();
  CHECK(holes(hand).row(1)->state == FillAction::Leave);
  CHECK(hand.studio().objects().front().mesh->face_count() < faces);

  choose(hand, chain[2]);
  CHECK(mode() == "select");
  hand.act("draw");
  choose(hand, chain[0]);
  CHECK(mode() == "select");
}

TEST_CASE("Recover brings a chain back with its states and its result", "[chains]") {
  StudioFixture hand;
  draw_ball(hand);
  add_subdivision(hand);
  hand.act("add-step-fill");
  hand.settle();
  hand.act("step-on");  // off
  hand.settle();
  const ContentHash made = content_hash(hand.studio().session().document());
  const std::size_t faces = hand.studio().objects().front().mesh->face_count();
  hand.crash_and_restart();

  recover(hand);
  CHECK(hand.window().shows_views());
  CHECK(content_hash(hand.studio().session().document()) == made);
  REQUIRE(step_rows(hand, 0).size() == 4);
  CHECK(step_rows(hand, 0)[0]->text(1) == "off");
  CHECK(hand.studio().objects().front().mesh->face_count() == faces);
  choose(hand, app::ObjectList::node_of(step_rows(hand, 0)[0]));
  hand.act("step-on");
  hand.settle();
  CHECK(step_rows(hand, 0)[0]->text(1).isEmpty());
}

}  // namespace
}  // namespace croquis::test
