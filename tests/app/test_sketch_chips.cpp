// SPDX-License-Identifier: GPL-3.0-or-later
// What people change about how a sketch is read: chips over the sketch, strokes drawn behind, pieces cut out.
#include <QAction>
#include <QColorDialog>
#include <QDoubleSpinBox>
#include <QFile>
#include <QMenu>
#include <QTest>
#include <cmath>

#include <catch2/catch.hpp>

#include "app/dialogs.h"
#include "app/files/mesh_export.h"
#include "app/tools/silhouette/sketch_chip.h"
#include "app/tools/silhouette/sketch_chips.h"
#include "croquis/operators/inflate_result.h"
#include "croquis/silhouette/stroke_data.h"
#include "croquis/tools/silhouette/stroke_setting.h"

namespace croquis::test {
namespace {

using app::Joint;
using silhouette::Hold;

std::vector<Vec2> round_line(const Vec2& centre, double radius, double turns = 1.01) {
  std::vector<Vec2> places;
  for (int k = 0; k <= 80; ++k) {
    const double angle = 0.7 + 2 * 3.14159265358979 * turns * k / 80;
    places.push_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return places;
}

app::SketchChip* chip(StudioFixture& hand, const char* name) {
  return hand.viewport().findChild<app::SketchChip*>(name);
}

/// Presses the mouse on a chip and drags it by logical pixels. The chip may be placed anew meanwhile.
void drag_chip(app::SketchChip& chip, const QPoint& by) {
  const QPoint from = chip.rect().center();
  const QPoint on_screen = chip.mapToGlobal(from);
  const auto send = [&](QEvent::Type type, Qt::MouseButton button, Qt::MouseButtons held, const QPoint& moved) {
    QMouseEvent event(type, from + moved, on_screen + moved, button, held, Qt::NoModifier);
    QApplication::sendEvent(&chip, &event);
  };
  send(QEvent::MouseButtonPress, Qt::LeftButton, Qt::LeftButton, {});
  for (int k = 1; k <= 4; ++k) send(QEvent::MouseMove, Qt::NoButton, Qt::LeftButton, by * k / 4);
  send(QEvent::MouseButtonRelease, Qt::LeftButton, Qt::NoButton, by);
}

std::string attach_of(StudioFixture& hand) {
  return std::get<std::string>(hand.studio().solid_operation()->parameters.at("attach"));
}

/// Two parts, of which one has two strokes.
InflateResult two_parts() {
  InflateResult result;
  result.objects.resize(2);
  result.objects[0] = {"body", {"body", "belly"}};
  result.objects[1] = {"ear", {"ear"}};
  result.suggested = {{"body", "ear", {10, 20}, Hold::Resting}};
  return result;
}

TEST_CASE("a pair is held as the drawing suggests it, until it has an entry of its own", "[sketch-chips]") {
  const InflateResult result = two_parts();
  const auto only = [&](const AttachText& text) { return app::joints_of(result, text, false).at(0); };
  CHECK(only(read_attach_text("")).hold == Hold::Apart);
  AttachText text = read_attach_text("auto");
  CHECK(only(text).hold == Hold::Resting);
  text = app::with_hold(text, only(text), app::next_hold(Hold::Resting));
  CHECK(to_text(text) == "auto;body,ear");
  CHECK(only(text).hold == Hold::Joined);
  text = app::with_blend(text, only(text), 0.3);
  CHECK(to_text(text) == "auto;body,ear=join:0.3");
  CHECK(only(text).blend == 0.3);
  CHECK(only(app::with_blend(text, only(text), 7)).blend == 1);
  text = app::with_hold(text, only(text), app::next_hold(Hold::Joined));
  CHECK(to_text(text) == "auto;body,ear=apart");
  text = app::with_hold(text, only(text), app::next_hold(Hold::Apart));
  CHECK(to_text(text) == "auto");  // as by itself: nothing has to be said
}

TEST_CASE("entries name parts by any of their strokes, and keep what they say besides", "[sketch-chips]") {
  const InflateResult result = two_parts();
  AttachText text = app::with_object_names(read_attach_text("leg,foot;ear,belly=0.4"), result);
  const Joint joint = app::joints_of(result, text, false).at(0);
  CHECK(joint.hold == Hold::Joined);
  CHECK(to_text(app::with_blend(text, joint, 0.5)) == "leg,foot;body,ear=0.4:0.5");
  CHECK(to_text(app::with_hold(text, joint, Hold::Apart)) == "leg,foot");
}

TEST_CASE("a pair that the solid couldn't join is reported, of finished solids alone", "[sketch-chips]") {
  InflateResult result = two_parts();
  const AttachText text = read_attach_text("body,ear");
  CHECK(app::joints_of(result, text, false).at(0).held);
  CHECK(!app::joints_of(result, text, true).at(0).held);
  result.attached = {{"ear", "body", 0.55, Hold::Joined, 0.2, {10, 20}}};
  CHECK(app::joints_of(result, text, true).at(0).held);
  result.suggested.clear();  // what is attached can be taken apart, suggested or not
  CHECK(app::joints_of(result, text, true).size() == 1);
}

TEST_CASE("readings of outlines follow the drawing before its solid does", "[sketch-chips]") {
  Drawing drawing;
  for (const char* id : {"face", "eye", "patch"}) {
    Stroke stroke;
    stroke.id = id;
    stroke.closed = true;
    stroke.samples.resize(1);
    drawing.strokes.push_back(stroke);
  }
  InflateResult result;
  result.nested = {{"eye", "face", false, false, {1, 2}}, {"gone", "face", true, false, {3, 4}}};
  result.crossings_in_view = {{"patch", "face", {5, 6}, false}, {"patch", "face", {7, 8}, false}};
  CHECK(app::nested_outlines(result, drawing).size() == 1);
  CHECK(!app::nested_outlines(result, drawing)[0].hole);
  drawing = set_kind(drawing, "eye", silhouette::StrokeKind::Hole).drawing;
  CHECK(app::nested_outlines(result, drawing)[0].hole);
  CHECK(app::nested_outlines(result, drawing)[0].chosen);

  REQUIRE(app::crossings_in_view(result, drawing).size() == 1);
  CHECK(app::crossings_in_view(result, drawing)[0].front == "patch");
  const Drawing swapped = set_in_front(drawing, "face", "patch").drawing;
  CHECK(app::crossings_in_view(result, swapped)[0].front == "face");
  InflateResult after = result;
  after.crossings_in_view = {{"face", "patch", {5, 6}, true}};
  CHECK(app::crossings_in_view(after, swapped)[0].front == "face");
  CHECK(app::crossings_in_view(after, drawing)[0].front == "patch");  // undone
}

TEST_CASE("the part with all that is selected has a thickness, several parts have none", "[sketch-chips]") {
  Drawing drawing;
  for (const char* id : {"belly", "ear", "body"}) {
    Stroke stroke;
    stroke.id = id;
    stroke.samples.resize(2);
    stroke.samples[1].position = {40, 30};
    drawing.strokes.push_back(stroke);
  }
  const InflateResult result = two_parts();
  CHECK(app::chosen_part(result, drawing, {"body"}).stroke == "belly");  // the first of its strokes
  CHECK((app::chosen_part(result, drawing, {"body"}).at - Vec2(20, 30)).norm() < 1e-12);
  CHECK(app::chosen_part(result, drawing, {"body", "ear"}).stroke.empty());
  CHECK(app::chosen_part(result, drawing, {}).stroke.empty());
}

TEST_CASE("two circles that cross become two bodies, and a click on the chip swaps them", "[sketch-chips]") {
  StudioFixture hand;
  hand.look_at({-260, -200}, {260, 200});
  hand.draw(round_line({-60, 0}, 110));
  hand.draw(round_line({80, 10}, 110));
  hand.settle();
  const auto inflated = [&] { return *hand.studio().result()->result<InflateResult>(); };
  REQUIRE(inflated().objects.size() == 2);
  REQUIRE(!inflated().crossings_in_view.empty());
  CHECK(inflated().crossings_in_view[0].front == "stroke 2");
  app::SketchChip* swap = chip(hand, "crossing-0");
  REQUIRE(swap != nullptr);
  REQUIRE(swap->isVisible());
  const QString before = swap->toolTip();
  swap->click();
  hand.settle();
  CHECK(inflated().crossings_in_view[0].front == "stroke 1");
  CHECK(inflated().objects.size() == 2);
  CHECK(swap->toolTip() != before);
  hand.act("undo");
  hand.settle();
  CHECK(inflated().crossings_in_view[0].front == "stroke 2");
  CHECK(swap->toolTip() == before);
}

TEST_CASE("an outline within another is a part or a hole by a click on its chip", "[sketch-chips]") {
  StudioFixture hand;
  hand.look_at({-260, -200}, {260, 200});
  hand.draw(round_line({0, 0}, 150));
  hand.draw(round_line({-60, 40}, 25));
  hand.settle();
  const auto parts = [&] { return hand.studio().result()->result<InflateResult>()->objects.size(); };
  REQUIRE(parts() == 2);  // small and aside: an eye
  app::SketchChip* nested = chip(hand, "nested-0");
  REQUIRE(nested != nullptr);
  REQUIRE(nested->isVisible());
  CHECK(nested->toolTip().startsWith("Part"));
  CHECK(nested->toolTip().contains("read from the drawing"));
  nested->click();
  hand.settle();
  CHECK(parts() == 1);
  CHECK(hand.studio().drawing().strokes[1].data.at("kind") == "hole");
  CHECK(nested->toolTip().startsWith("Hole"));
  CHECK(hand.studio().session().undo_labels().back() == "Make stroke 2 a hole");
  nested->click();
  hand.settle();
  CHECK(parts() == 2);
  hand.act("undo");
  hand.act("undo");
  hand.settle();
  CHECK(!hand.studio().drawing().strokes[1].data.contains("kind"));
}

TEST_CASE("a line on a body is a detail, and a click on its chip makes it something else", "[sketch-chips]") {
  StudioFixture hand;
  hand.look_at({-260, -200}, {260, 200});
  hand.draw(round_line({0, 0}, 150));
  hand.draw({{-60, -40}, {-30, -55}, {0, -60}, {30, -55}, {60, -40}});
  hand.settle();
  const auto kind = [&] { return hand.studio().result()->result<InflateResult>()->kinds.at(1).second; };
  const auto lines = [&] { return hand.studio().result()->outputs.at("lines").get<PolyMesh>().line_count(); };
  REQUIRE(kind() == silhouette::StrokeKind::Detail);
  CHECK(lines() == 1);
  app::SketchChip* chip_of_line = chip(hand, "kind-0");
  REQUIRE(chip_of_line != nullptr);
  REQUIRE(chip_of_line->isVisible());
  CHECK(chip_of_line->text() == "Detail");
  const auto choose = [&](const char* name) {
    chip_of_line->click();
    auto* menu = chip_of_line->findChild<QMenu*>("kinds");
    REQUIRE(menu != nullptr);
    menu->findChild<QAction*>(name)->trigger();
    menu->close();
    hand.settle();
  };
  choose("kind-ignored");
  CHECK(kind() == silhouette::StrokeKind::Ignored);
  CHECK(lines() == 0);
  CHECK(hand.studio().drawing().strokes[1].data.at("kind") == "ignored");
  choose("kind-visible");
  CHECK(kind() == silhouette::StrokeKind::Detail);
  CHECK(!hand.studio().drawing().strokes[1].data.contains("kind"));
}

TEST_CASE("new sketches hold their parts as drawn; a seam's radius is dragged and typed", "[sketch-chips]") {
  StudioFixture hand;
  hand.look_at({-260, -200}, {260, 200});
  hand.draw(round_line({0, 0}, 110));
  hand.draw({{108, 25}, {150, 34}, {190, 30}, {205, 0}, {190, -28}, {150, -32}, {108, -22}});
  hand.settle();
  CHECK(attach_of(hand) == "auto");
  app::SketchChip* joint = chip(hand, "joint-0");
  REQUIRE(joint != nullptr);
  REQUIRE(joint->isVisible());
  for (int clicks = 0; clicks < 3 && attach_of(hand).find("=apart") == std::string::npos; ++clicks) joint->click();
  CHECK(joint->toolTip().startsWith("Apart"));
  joint->click();
  CHECK(joint->toolTip().startsWith("Resting"));
  const auto steps = hand.studio().session().undo_labels().size();
  joint->click();
  hand.settle();
  CHECK(hand.studio().session().undo_labels().size() == steps + 1);
  const auto blend = [&] {
    const InflateResult* result = hand.studio().result()->result<InflateResult>();
    return app::joints_of(*result, read_attach_text(attach_of(hand)), true).at(0).blend;
  };
  const double before = blend();
  drag_chip(*joint, {24, 0});
  hand.settle();
  CHECK(hand.studio().session().undo_labels().size() == steps + 2);
  CHECK(blend() == Approx(before + 0.2));
  QTest::mouseClick(joint, Qt::RightButton);
  auto* number = joint->findChild<QDoubleSpinBox*>("seam-radius");
  REQUIRE(number != nullptr);
  CHECK(number->value() == Approx(before + 0.2));
  number->setValue(0.25);
  CHECK(attach_of(hand).ends_with(":0.25"));
}

TEST_CASE("how a part is held is forgotten when it is deleted, and comes back with it", "[sketch-chips]") {
  StudioFixture hand;
  hand.look_at({-260, -200}, {260, 200});
  hand.draw(round_line({0, 0}, 110));
  hand.draw({{108, 25}, {150, 34}, {190, 30}, {205, 0}, {190, -28}, {150, -32}, {108, -22}});
  hand.settle();
  const NodeId solid = hand.studio().solid_node();
  hand.studio().set_parameter(solid, "attach", std::string("auto;stroke 1,stroke 2=apart"), false);
  hand.studio().session().select({{hand.studio().drawing_node(), "stroke 2"}});
  hand.act("delete");
  CHECK(attach_of(hand) == "auto");
  hand.settle();
  CHECK(!hand.studio().result()->failed);
  hand.act("undo");
  CHECK(attach_of(hand) == "auto;stroke 1,stroke 2=apart");
}

TEST_CASE("the thickness of the selected part is dragged and typed at its chip", "[sketch-chips]") {
  StudioFixture hand;
  hand.look_at({-260, -200}, {260, 200});
  hand.draw(round_line({0, 0}, 110));
  hand.settle();
  hand.studio().session().select({{hand.studio().drawing_node(), "stroke 1"}});
  hand.settle();
  app::SketchChip* thickness = chip(hand, "thickness-0");
  REQUIRE(thickness != nullptr);
  REQUIRE(thickness->isVisible());
  const auto steps = hand.studio().session().undo_labels().size();
  drag_chip(*thickness, {0, 70});
  const auto factor = [&] { return thickness_of(hand.studio().drawing(), "stroke 1"); };
  CHECK(factor() == Approx(std::exp(-0.7)).margin(0.006));
  CHECK(hand.studio().session().undo_labels().size() == steps + 1);
  CHECK(thickness->text().contains("0.5"));
  QTest::mouseClick(thickness, Qt::LeftButton);
  auto* number = thickness->findChild<QDoubleSpinBox*>("part-thickness");
  REQUIRE(number != nullptr);
  number->setValue(2);
  CHECK(factor() == 2);
  hand.act("undo");
  hand.act("undo");
  CHECK(factor() == 1);
  hand.studio().session().select({});
  hand.settle();
  CHECK(!thickness->isVisible());
}

TEST_CASE("a key makes a second one of the last part on the far side, which follows it and goes again",
          "[sketch-chips]") {
  StudioFixture hand;
  hand.look_at({-260, -260}, {260, 200});
  CHECK(!hand.window().action("far-copy")->isEnabled());
  hand.draw(round_line({0, 0}, 110));
  hand.draw({{-30, -50}, {-34, -120}, {-30, -180}, {0, -200}, {30, -180}, {34, -120}, {30, -50}, {0, -40}, {-30, -50}});
  hand.settle();
  const auto extent = [&] {
    hand.settle();
    Eigen::AlignedBox3d box;
    for (const Vec3& position : hand.studio().active()->mesh->positions) box.extend(position);
    return box.sizes().z();
  };
  const double one = extent();
  const auto steps = hand.studio().session().undo_labels().size();
  hand.act("far-copy");
  CHECK(has_far_copy(hand.studio().drawing(), "stroke 2"));
  CHECK(hand.studio().session().undo_labels().back() == "Make a far copy of stroke 2");
  CHECK(hand.studio().session().undo_labels().size() == steps + 1);
  const double two = extent();
  CHECK(two > one + 1);
  hand.studio().session().select({{hand.studio().drawing_node(), "stroke 2"}});
  hand.studio().set_parameter(hand.studio().solid_node(), "attach", std::string("auto;stroke 1,stroke 2=0.9"), false);
  CHECK(std::abs(extent() - two) > 1);
  hand.act("undo");
  hand.act("far-copy");
  CHECK(!has_far_copy(hand.studio().drawing(), "stroke 2"));
  CHECK(extent() == Approx(one));
  hand.act("undo");
  CHECK(extent() == Approx(two));
}

TEST_CASE("a part gets a colour, which is seen, undone and exported", "[sketch-chips]") {
  StudioFixture hand;
  hand.window().set_unattended();
  hand.look_at({-260, -260}, {260, 200});
  hand.draw(round_line({0, 0}, 110));
  hand.settle();
  const auto orange = [](const QColor& color) { return color.red() > 120 && color.blue() < color.red() / 2; };
  const QRectF view = hand.viewport().pane(app::PerspectiveView).rect;
  CHECK(share_of_pixels(hand.picture(), view, orange) < 0.01);
  in_dialog<QColorDialog>([](QColorDialog& dialog) {
    dialog.setCurrentColor(QColor("#ff7000"));
    dialog.accept();
  });
  hand.act("part-colour");
  hand.settle();
  CHECK(fill_of(hand.studio().drawing(), "stroke 1") == "#ff7000");
  CHECK(share_of_pixels(hand.picture(), view, orange) > 0.1);
  const QString file = hand.folder() + "/part.ply";
  app::export_solid(hand.studio(), file);
  QFile written(file);
  REQUIRE(written.open(QIODevice::ReadOnly));
  CHECK(written.read(600).contains("property uchar red"));
  hand.act("undo");
  hand.settle();
  CHECK(fill_of(hand.studio().drawing(), "stroke 1").empty());
  CHECK(share_of_pixels(hand.picture(), view, orange) < 0.01);
}

TEST_CASE("half of an outline is enough for a symmetric drawing, and an ear comes twice", "[sketch-chips]") {
  StudioFixture hand;
  hand.look_at({-200, -200}, {200, 200});
  hand.act("symmetric-drawing");
  const double axis = *hand.sketch().tool().options().mirror;
  std::vector<Vec2> half;
  for (int k = 0; k <= 60; ++k) {
    const double angle = 3.14159265358979 * (0.5 + k / 60.0);
    half.emplace_back(axis + 3 + 100 * std::cos(angle), 100 * std::sin(angle));
  }
  hand.draw(half);
  hand.draw(round_line({axis - 80, 90}, 35));
  hand.settle();
  const Drawing drawn = hand.studio().drawing();
  REQUIRE(drawn.strokes.size() == 3);
  CHECK(drawn.strokes[0].closed);
  double left = 0, right = 0;
  for (const Vec3& place : hand.studio().active()->mesh->positions) {
    left = std::max(left, axis - place.x());
    right = std::max(right, place.x() - axis);
  }
  CHECK(left > 110);
  CHECK(left == Approx(right).epsilon(1e-12));
  // The line is seen, between the strokes, from above to below.
  const QPointF top = app::sketch_to_widget(hand.viewport().views(), {axis, 150});
  const auto grey = [](const QColor& color) { return color.lightness() > 60 && color.lightness() < 215; };
  CHECK(share_of_pixels(hand.picture(), QRectF(top - QPointF(3, 20), QSizeF(6, 40)), grey) > 0.1);
  hand.act("symmetric-drawing");
  CHECK(share_of_pixels(hand.picture(), QRectF(top - QPointF(3, 20), QSizeF(6, 40)), grey) < 0.01);
  hand.draw(round_line({axis - 40, -40}, 15));
  CHECK(hand.studio().drawing().strokes.size() == 4);
  for (int k = 0; k < 3; ++k) hand.act("undo");
  CHECK(hand.studio().drawing().strokes.empty());
}

TEST_CASE("a part reaches as far as its own faces do", "[sketch-chips]") {
  PolyMesh mesh;
  mesh.positions = {{0, 0, -2}, {1, 0, 0}, {0, 1, 4}, {0, 0, 9}};
  mesh.add_triangle(0, 1, 2);
  mesh.add_triangle(1, 2, 3);
  mesh.channels.push_back({"object", Domain::Face, 1, std::vector<std::int32_t>{0, 1}, {"ear", "head"}});
  const auto ear = app::part_reach(mesh, "ear", Vec3::UnitZ());
  REQUIRE(ear);
  CHECK(ear->front == Vec3(0, 1, 4));
  CHECK(ear->depth == 6);
  CHECK(app::part_reach(mesh, "head", -Vec3::UnitZ())->front == Vec3(1, 0, 0));
  CHECK(!app::part_reach(mesh, "tail", Vec3::UnitZ()));
}

TEST_CASE("the front of a part follows the pointer wherever depth points in the view", "[sketch-chips]") {
  for (const Vec2& depth : {Vec2(40, 0), Vec2(-30, 20), Vec2(5, -60)}) {
    CHECK(app::thickness_after(0.8, Vec2(0.5 * depth), depth) == Approx(1.2));
    CHECK(app::thickness_after(0.8, Vec2(-0.5 * depth), depth) == Approx(0.4));
    CHECK(app::thickness_after(1, Vec2(depth.y(), -depth.x()), depth) == 1);  // across it
    CHECK(app::thickness_after(1, Vec2(-3 * depth), depth) == least_thickness);
    CHECK(app::thickness_after(1, Vec2(30 * depth), depth) == most_thickness);
  }
  CHECK(app::thickness_after(1, {50, -70}, {1, 0}) == Approx(std::exp(0.7)).margin(0.006));  // seen from the front
}

TEST_CASE("the thickness of the selected part is dragged at its front in the view of the solid", "[sketch-chips]") {
  StudioFixture hand;
  hand.look_at({-260, -200}, {260, 200});
  hand.draw(round_line({0, 0}, 110));
  hand.settle();
  app::SketchChip* handle = chip(hand, "thickness-in-solid");
  REQUIRE(handle != nullptr);
  CHECK(!handle->isVisible());
  hand.studio().session().select({{hand.studio().drawing_node(), "stroke 1"}});
  hand.settle();
  REQUIRE(handle->isVisible());
  const auto depth = [&] {
    const auto& mesh = hand.studio().result()->outputs.at("mesh").get<PolyMesh>();
    const auto [low, high] = std::ranges::minmax(mesh.positions, {}, [](const Vec3& p) { return p.z(); });
    return high.z() - low.z();
  };
  const double before = depth();
  const QPoint front = handle->geometry().center();
  const auto frame = app::frame_of(hand.viewport().views(), app::PerspectiveView);
  const Vec3 pole(0, 0, before / 2);
  const Vec2 further = frame.project(pole * 1.5)->pixel - frame.project(pole)->pixel;
  drag_chip(*handle, QPoint(qRound(further.x()), qRound(further.y())));
  hand.settle();
  CHECK(depth() == Approx(1.5 * before).epsilon(0.06));  // whole pixels
  const QPoint moved = handle->geometry().center() - front;
  CHECK((Vec2(moved.x(), moved.y()) - further).norm() < 6);
  hand.act("undo");
  hand.settle();
  CHECK(depth() == Approx(before));
}

TEST_CASE("the parts of a sketch that is opened hold together as they look", "[sketch-chips]") {
  StudioFixture hand;
  Drawing drawing;
  for (const auto& [id, radius] : {std::pair{"head", 100.0}, {"eye", 20.0}}) {
    Stroke stroke;
    stroke.id = id;
    stroke.closed = true;
    for (const Vec2& place : round_line({radius / 2, 0}, radius, 0.99)) stroke.samples.push_back({place});
    drawing.strokes.push_back(std::move(stroke));
  }
  app::start_with(hand.studio(), drawing);
  hand.settle();
  const InflateResult* inflated = hand.studio().result()->result<InflateResult>();
  REQUIRE(inflated != nullptr);
  REQUIRE(inflated->attached.size() == 1);
  CHECK(inflated->attached[0].hold == Hold::Resting);
  CHECK(!hand.studio().solid_operation()->parameters.contains("preset"));  // any lines
}

TEST_CASE("the right button draws behind what is there; with the select tool it draws nothing", "[sketch-strokes]") {
  StudioFixture hand;
  hand.look_at({-260, -200}, {260, 200});
  hand.draw(round_line({-60, 0}, 110));
  QTest::qWait(250);
  const auto draw_with = [&](Qt::MouseButton button, Qt::KeyboardModifiers modifiers) {
    const auto places = round_line({80, 0}, 110);
    const auto at = [&](const Vec2& place) { return app::sketch_to_widget(hand.viewport().views(), place); };
    hand.send_mouse(QEvent::MouseButtonPress, at(places.front()), button, modifiers);
    for (const Vec2& place : places) hand.send_mouse(QEvent::MouseMove, at(place), button, modifiers);
    if (const auto ink = hand.sketch().state().ink) CHECK(ink->pale);
    hand.send_mouse(QEvent::MouseButtonRelease, at(places.back()), button, modifiers);
  };
  draw_with(Qt::RightButton, Qt::NoModifier);
  REQUIRE(hand.studio().drawing().strokes.size() == 2);
  CHECK(hand.studio().drawing().strokes[1].data.at("behind") == "all");
  CHECK(hand.studio().drawing().strokes[1].closed);
  hand.settle();
  const InflateResult* inflated = hand.studio().result()->result<InflateResult>();
  REQUIRE(inflated != nullptr);
  REQUIRE(!inflated->crossings_in_view.empty());
  CHECK(inflated->crossings_in_view[0].front == "stroke 1");
  hand.act("undo");
  draw_with(Qt::LeftButton, Qt::ShiftModifier);
  REQUIRE(hand.studio().drawing().strokes.size() == 2);
  CHECK(hand.studio().drawing().strokes[1].data.at("behind") == "all");
  hand.act("undo");
  hand.act("select");
  draw_with(Qt::RightButton, Qt::NoModifier);
  CHECK(hand.studio().drawing().strokes.size() == 1);
}

TEST_CASE("ends that rest on a body follow it when it is dragged in the view", "[sketch-strokes]") {
  StudioFixture hand;
  hand.look_at({-260, -200}, {260, 200});
  hand.draw(round_line({0, 0}, 110));
  hand.draw({{108, 25}, {150, 34}, {190, 30}, {205, 0}, {190, -28}, {150, -32}, {108, -22}});
  hand.act("select");
  const Vec2 before = hand.studio().drawing().strokes[1].samples.front().position;
  hand.drag({-110, 0}, {-130, 30});
  const Vec2 moved = hand.studio().drawing().strokes[1].samples.front().position - before;
  CHECK((moved - Vec2(-20, 30)).norm() < 3);
  hand.act("undo");
  CHECK(hand.studio().drawing().strokes[1].samples.front().position == before);
}

TEST_CASE("the eraser cuts a piece out of a line in the view, as one undo step", "[sketch-strokes]") {
  StudioFixture hand;
  hand.look_at({-260, -200}, {260, 200});
  hand.draw(round_line({0, 0}, 110));
  hand.act("erase");
  const auto steps = hand.studio().session().undo_labels().size();
  hand.drag({-150, 0}, {150, 0});
  CHECK(hand.studio().drawing().strokes.size() == 2);
  CHECK(!hand.studio().drawing().strokes[0].closed);
  CHECK(hand.studio().session().undo_labels().size() == steps + 1);
  hand.act("undo");
  REQUIRE(hand.studio().drawing().strokes.size() == 1);
  CHECK(hand.studio().drawing().strokes[0].closed);
}

}  // namespace
}  // namespace croquis::test
