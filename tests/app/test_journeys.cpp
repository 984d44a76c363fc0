// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QFile>
#include <QProcess>

#include <catch2/catch.hpp>

#include "app/panels/lists.h"
#include "app/studio_fixture.h"
#include "app/window/theme.h"
#include "croquis/document/content_hash.h"
#include "support/sketches/sketch_gallery.h"

using namespace croquis;
using croquis::test::StudioFixture;

namespace {

bool is_ink(const QColor& color) { return color.lightness() < 90; }

std::size_t objects_shown(StudioFixture& hand) {
  const auto result = hand.studio().result();
  if (!result || result->failed) return 0;
  const auto details = result->outputs.at("details").as<Report>();
  return details->at("objects").as_array().size();
}

void check_solid_in_view(StudioFixture& hand) {
  const QRect box = test::box_of_solid(hand);
  const double ratio = hand.viewport().devicePixelRatioF();
  const QRectF view = hand.viewport().pane(app::Viewport::PerspectiveView).rect;
  INFO(box.x() << " " << box.y() << " " << box.width() << " " << box.height());
  // Large, and clipped at no border.
  CHECK(box.width() > 0.4 * view.width() * ratio);
  CHECK(box.height() > 0.15 * view.height() * ratio);
  CHECK(box.left() > view.left() * ratio + 2);
  CHECK(box.right() < view.right() * ratio - 2);
  CHECK(box.top() > 2);
}

/// cli check says that the file is closed, oriented and free of self-intersections.
bool passes_check(const QString& file) { return QProcess::execute(CROQUIS_CLI, {"check", file, "--quiet"}) == 0; }

}  // namespace

TEST_CASE("a snake drawn with a pen becomes solid, is bent, undone, saved, opened and exported", "[journey]") {
  StudioFixture hand;
  const test::Sketch snake = test::snake_sketch();
  hand.draw(snake);
  hand.settle();
  CHECK(hand.studio().drawing().strokes.size() == snake.drawing.strokes.size());
  REQUIRE(objects_shown(hand) == 1);
  check_solid_in_view(hand);
  const QRectF sketch_view = hand.viewport().pane(app::Viewport::SketchView).rect;
  CHECK(test::share_of_pixels(hand.picture(), sketch_view, is_ink) > 0.002);

  // Every state is reached again by undo and redo, to the last bit.
  Session& session = hand.studio().session();
  hand.act("select");
  const Stroke& stroke = hand.studio().drawing().strokes.front();
  hand.click(stroke.samples[stroke.samples.size() / 3].position);
  REQUIRE(session.selection().size() == 1);
  const StrokeFit* fit = hand.sketch().tool().fit(stroke.id);
  REQUIRE(fit != nullptr);
  const Vec2 anchor = fit->anchors[fit->anchors.size() / 2].position;
  const Document before_drag = session.document();
  hand.drag(anchor, anchor + Vec2(12, 16));
  CHECK(!same_nodes(session.document(), before_drag));
  CHECK(session.undo_labels().back().find("stroke") != std::string::npos);
  hand.settle();
  const ContentHash all_done = content_hash(session.document());
  const std::size_t steps = session.undo_labels().size();
  CHECK(steps == snake.drawing.strokes.size() + 1);
  for (std::size_t i = 0; i < steps; ++i) hand.act("undo");
  CHECK(session.document().nodes().empty());
  CHECK(!hand.window().action("undo")->isEnabled());
  for (std::size_t i = 0; i < steps; ++i) hand.act("redo");
  CHECK(content_hash(session.document()) == all_done);
  hand.settle();
  REQUIRE(objects_shown(hand) == 1);

  const QString project = hand.folder() + "/snake.croq";
  hand.window().files().save(project);
  CHECK(!session.modified());
  hand.window().start_with();
  hand.settle();
  CHECK(hand.studio().drawing().strokes.empty());
  CHECK(hand.studio().solid() == nullptr);
  REQUIRE(hand.window().open(project));
  hand.settle();
  CHECK(content_hash(session.document()) == all_done);
  check_solid_in_view(hand);

  const QString solid = hand.folder() + "/snake.stl";
  app::export_solid(hand.studio(), solid);
  CHECK(passes_check(solid));
  const QString picture = hand.folder() + "/snake.png";
  app::export_picture(hand.window().parts().pictures, hand.viewport().views(), picture);
  CHECK(QImage(picture).height() > 1000);
}

TEST_CASE("linked rings drawn with a pen become two solids that hold each other", "[journey]") {
  StudioFixture hand;
  hand.draw(test::linked_rings_sketch());
  hand.settle();
  CHECK(objects_shown(hand) == 2);
  check_solid_in_view(hand);
  CHECK(part_rows(hand).size() == 2);
  const QString file = hand.folder() + "/rings.obj";
  app::export_solid(hand.studio(), file);
  CHECK(passes_check(file));
}

TEST_CASE("what can't be read is marked where it is, with its sentence, until the drawing is mended", "[journey]") {
  StudioFixture hand;
  hand.look_at({-200, -200}, {200, 200});
  std::vector<Vec2> open;
  for (int k = 0; k <= 60; ++k) {
    const double angle = 3.5 * k / 60;
    open.emplace_back(120 * std::cos(angle), 120 * std::sin(angle));
  }
  hand.draw(open);
  hand.sketch().tool().set({"stroke 1", silhouette::StrokeKind::Contour});  // its ends are too far apart
  hand.settle();
  CHECK(objects_shown(hand) == 0);
  const auto& marks = hand.sketch().scene().finding_marks();
  REQUIRE(!marks.empty());
  CHECK(marks.front().error);
  CHECK((marks.front().at.head<2>() - open[30]).norm() < 15);
  CHECK(marks.front().sentence.contains("stroke 1"));
  CHECK(hand.window().findChild<app::FindingsList*>("findings")->count() >= 1);
  const QPointF at = app::sketch_to_widget(hand.viewport().views(), marks.front().at.head<2>());
  const auto is_red = [](const QColor& c) { return c.red() > 150 && c.green() < 110 && c.blue() < 110; };
  CHECK(test::share_of_pixels(hand.picture(), QRectF(at - QPointF(8, 8), QSizeF(16, 16)), is_red) > 0.1);

  // The missing piece closes the line.
  std::vector<Vec2> rest;
  for (int k = 0; k <= 30; ++k) {
    const double angle = 3.5 + (2 * 3.14159265358979 - 3.5) * k / 30;
    rest.emplace_back(120 * std::cos(angle), 120 * std::sin(angle));
  }
  hand.draw(rest);
  hand.settle();
  CHECK(objects_shown(hand) == 1);
  for (const app::FindingMark& mark : hand.sketch().scene().finding_marks()) CHECK(!mark.error);
}

TEST_CASE("work that a crash left is offered and comes back whole", "[journey]") {
  StudioFixture hand;
  hand.draw(test::linked_rings_sketch());
  hand.settle();
  const ContentHash drawn = content_hash(hand.studio().session().document());
  hand.crash_and_restart();
  const auto offers = hand.window().files().recoverable();
  REQUIRE(offers.size() == 1);
  CHECK(!offers.front().thumbnail.isNull());
  hand.window().files().recover(offers.front());
  app::show_views(hand.window());
  hand.settle();
  CHECK(content_hash(hand.studio().session().document()) == drawn);
  CHECK(hand.studio().session().modified());
  CHECK(objects_shown(hand) == 2);
}

TEST_CASE("a project that can't be written leaves the old file and the work in the window", "[journey]") {
  StudioFixture hand;
  hand.draw(test::linked_rings_sketch());
  hand.settle();
  const ContentHash drawn = content_hash(hand.studio().session().document());
  const QString nowhere = hand.folder() + "/missing/folder/rings.croq";
  CHECK(!hand.window().attempt([&] { hand.window().files().save(nowhere); }));
  CHECK(!hand.window().last_findings().empty());
  CHECK(hand.studio().session().modified());
  CHECK(content_hash(hand.studio().session().document()) == drawn);

  const QString damaged = hand.folder() + "/damaged.croq";
  QFile file(damaged);
  REQUIRE(file.open(QIODevice::WriteOnly));
  file.write("SQLite format 3 but nothing of the kind");
  file.close();
  hand.studio().session().mark_saved();
  CHECK(!hand.window().open(damaged));
  CHECK(content_hash(hand.studio().session().document()) == drawn);
}
