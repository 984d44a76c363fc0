// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/tools/all_steps.h"
#include "croquis/tools/perspective/perspective_steps.h"
#include "croquis/tools/perspective/perspective_tool.h"
#include "croquis/tools/perspective/sheet_units.h"
#include "croquis/tools/recording/recording.h"
#include "tools/perspective/perspective_ink.h"

namespace croquis {
namespace {

using test::plain_drawing;

/// A tool on a session of its own, moved as a hand does.
struct Hand {
  Session session;
  PerspectiveTool tool{session};
  Modifiers held;

  Verdict step(PenStep::Kind kind, const Vec2& sheet) {
    SketchEvent event;
    event.kind = kind;
    event.sample.position = {sheet.x(), -sheet.y()};
    event.modifiers = held;
    return tool.handle(event);
  }

  Verdict drag(const std::vector<Vec2>& way) {
    step(PenStep::Kind::Begin, way.front());
    for (const Vec2& place : way) step(PenStep::Kind::Sample, place);
    return step(PenStep::Kind::End, way.back());
  }

  Verdict line(const Vec2& from, const Vec2& to) {
    std::vector<Vec2> way;
    for (int k = 0; k <= 40; ++k) way.push_back(from + (to - from) * k / 40.0);
    return drag(way);
  }

  const PerspectiveStroke& stroke(std::size_t i) { return tool.drawing()->strokes.at(i); }

  /// With the solid as somebody drew it.
  void open(PerspectiveDrawing drawing) { session.load(add_perspective_drawing(Document(), std::move(drawing), {})); }
};

/// Through the text of a recording and back.
recorded::Step recorded_again(const recorded::Step& step) {
  return recorded::parse(recorded::to_line(step), "test", recorded::all_steps()).front().step;
}

bool same_drawing(const PerspectiveDrawing& a, const PerspectiveDrawing& b) {
  const auto same = [](const PerspectiveStroke& x, const PerspectiveStroke& y) {
    return x.id == y.id && x.group == y.group && x.role == y.role && x.pieces == y.pieces && x.hidden == y.hidden &&
           x.from == y.from && x.to == y.to && x.start_lock == y.start_lock && x.end_lock == y.end_lock;
  };
  return std::ranges::equal(a.strokes, b.strokes, same) && a.known_point == b.known_point &&
         a.known_lengths == b.known_lengths && a.field_of_view == b.field_of_view;
}

TEST_CASE("the first stroke makes a drawing with its operation, and each gesture is one step back") {
  Hand hand;
  CHECK(hand.tool.node() == 0);
  CHECK(hand.line({100, 100}, {400, 90}) == Verdict::Commit);
  REQUIRE(hand.tool.drawing());
  CHECK(hand.tool.drawing()->strokes.size() == 1);
  CHECK(hand.tool.operation_node() != 0);
  hand.line({400, 92}, {410, 400});
  REQUIRE(hand.tool.drawing()->strokes.size() == 2);
  CHECK(hand.stroke(1).start() == hand.stroke(0).end());
  hand.session.undo();
  CHECK(hand.tool.drawing()->strokes.size() == 1);
  hand.session.undo();
  CHECK(hand.tool.node() == 0);
}

TEST_CASE("a tap draws nothing, and a gesture given up leaves the document as it was") {
  Hand hand;
  CHECK(hand.drag({{50, 50}, {51, 50}}) != Verdict::Commit);
  hand.step(PenStep::Kind::Begin, {10, 10});
  hand.step(PenStep::Kind::Sample, {200, 10});
  CHECK(!hand.tool.preview().ink.empty());
  hand.step(PenStep::Kind::Cancel, {200, 10});
  CHECK(hand.tool.preview().ink.empty());
  CHECK(!hand.session.can_undo());
}

TEST_CASE("chosen groups and roles are those of what is drawn, a key counts for the stroke under way") {
  Hand hand;
  hand.tool.set_group(StrokeGroup::NormalY);
  hand.tool.set_role(StrokeRole::Construction);
  hand.line({100, 100}, {400, 90});
  CHECK(hand.stroke(0).group == StrokeGroup::NormalY);
  CHECK(hand.stroke(0).role == StrokeRole::Construction);
  hand.step(PenStep::Kind::Begin, {100, 300});
  hand.step(PenStep::Kind::Sample, {300, 320});
  hand.tool.set_group(StrokeGroup::ParallelX);
  CHECK(hand.tool.preview().group == StrokeGroup::ParallelX);
  hand.step(PenStep::Kind::End, {300, 320});
  CHECK(hand.stroke(1).group == StrokeGroup::ParallelX);
}

TEST_CASE("a selected stroke's end is dragged with its vertex, alone with Ctrl, and joins another vertex") {
  Hand hand;
  hand.open(plain_drawing(test::box(), test::three_point_views()[1]).drawing);
  const PerspectiveDrawing before = *hand.tool.drawing();
  hand.tool.set_mode(PerspectiveMode::Select);
  std::size_t edge = 0;
  while (before.strokes[edge].role != StrokeRole::Edge) ++edge;
  const Vec2 place = before.strokes[edge].start();
  hand.step(PenStep::Kind::Begin, place_on(before.strokes[edge].pieces[0], 0.5));
  hand.step(PenStep::Kind::End, place_on(before.strokes[edge].pieces[0], 0.5));
  REQUIRE(hand.tool.selected() == std::vector<std::string>{before.strokes[edge].id});

  CHECK(hand.line(place, place + Vec2(40, 30)) == Verdict::Commit);
  CHECK(vertices_of(*hand.tool.drawing()).size() == 8);
  CHECK((hand.stroke(edge).start() - place - Vec2(40, 30)).norm() < 1e-9);
  hand.session.undo();
  CHECK(same_drawing(*hand.tool.drawing(), before));

  hand.held.ctrl = true;
  hand.line(place, place + Vec2(40, 30));
  hand.held.ctrl = false;
  CHECK(vertices_of(*hand.tool.drawing()).size() == 9);
  hand.line(place + Vec2(40, 30), place + Vec2(3, 2));  // near enough: it goes to the vertex
  CHECK(vertices_of(*hand.tool.drawing()).size() == 8);
  CHECK(hand.stroke(edge).start() == place);
}

TEST_CASE("the eraser deletes what it touches in any mode") {
  Hand hand;
  hand.open(plain_drawing(test::box(), test::three_point_views()[1]).drawing);
  const std::size_t count = hand.tool.drawing()->strokes.size();
  const std::string id = hand.stroke(0).id;
  const Vec2 on = place_on(hand.stroke(0).pieces[0], 0.5);
  hand.tool.set_mode(PerspectiveMode::Erase);
  CHECK(hand.drag({on - Vec2(0, 1), on, on + Vec2(0, 1)}) == Verdict::Commit);
  CHECK(hand.tool.drawing()->strokes.size() < count);
  CHECK(find_stroke(*hand.tool.drawing(), id) == nullptr);
}

TEST_CASE("lists of the operation hold what was chosen, and nothing when it was taken off") {
  Hand hand;
  hand.open(plain_drawing(test::box(), test::three_point_views()[1]).drawing);
  CHECK(hand.tool.take(recorded::SheetChoice{"sharp", "e00", true}) == Verdict::Commit);
  CHECK(hand.tool.take(recorded::SheetChoice{"sharp", "e01", true}) == Verdict::Commit);
  CHECK(hand.tool.take(recorded::SheetChoice{"sharp", "e01", true}) == Verdict::Continue);
  const auto parameters = [&] { return hand.session.document().find(hand.tool.operation_node())->parameters; };
  CHECK(std::get<std::string>(parameters().at("sharp")) == "e00;e01");
  hand.tool.take(recorded::SheetChoice{"sharp", "e00", false});
  CHECK(!hand.tool.is_chosen("sharp", "e00"));
  CHECK(hand.tool.is_chosen("sharp", "e01"));
  hand.tool.take(recorded::SheetChoice{"sharp", "e01", false});
  CHECK(!parameters().contains("sharp"));
}

TEST_CASE("what isn't there or can't be is refused, and nothing changes") {
  Hand hand;
  CHECK_THROWS_AS(hand.tool.take(recorded::SheetDelete{{"s1"}}), Error);
  hand.open(plain_drawing(test::box(), test::three_point_views()[1]).drawing);
  const PerspectiveDrawing before = *hand.tool.drawing();
  CHECK_THROWS_AS(hand.tool.take(recorded::SheetDrag{"nobody", 0, {1, 1}}), Error);
  CHECK_THROWS_AS(hand.tool.take(recorded::SheetLength{"e00", -1.0}), Error);
  CHECK_THROWS_AS(hand.tool.take(recorded::SheetCamera{4.0, {}}), Error);
  CHECK_THROWS_AS(hand.tool.take(recorded::SheetMirror{{0, 1}, {}}), Error);
  CHECK(same_drawing(*hand.tool.drawing(), before));
  CHECK(!hand.session.can_undo());
}

TEST_CASE("every step reads back as it was written") {
  StrokeSetting setting;
  setting.group = StrokeGroup::NormalZ;
  setting.set(&PerspectiveStroke::hidden, true);
  setting.set(&PerspectiveStroke::end_lock, EndLock::Corner);
  setting.set(&PerspectiveStroke::weight, 0.25);
  const std::vector<recorded::Step> steps = {
      recorded::SheetStroke{{{1, 2}, {3.5, 4.25}}, StrokeGroup::ParallelY, StrokeRole::Construction, false, 0.5, {}},
      recorded::SheetStroke{{{1, 2}}, {}, StrokeRole::Edge, true, 2, {}},
      recorded::SheetStroke{
          {{1, 2}, {3, 4}}, {}, StrokeRole::Edge, false, 2, {StrokeGroup::NormalX, StrokeGroup::Unknown}},
      recorded::SheetDrag{"s3", 4, {1.5, -2}, true},
      recorded::SheetDrag{"s3", {}, {0.1, 0.2}, false},
      recorded::SheetAim{2, {5000.5, -20}},
      recorded::SheetSetting{{"a", "b"}, setting},
      recorded::SheetDelete{{"a"}},
      recorded::SheetPoint{KnownPoint{{1, 2}, {3, 4, 5}}},
      recorded::SheetPoint{},
      recorded::SheetLength{"s3", 120.0},
      recorded::SheetLength{"s3", {}},
      recorded::SheetCamera{0.5, Vec2(500, 375)},
      recorded::SheetCamera{},
      recorded::SheetUnit{"cm"},
      recorded::SheetUnit{},
      recorded::SheetFaces{{"s1+s2+s3"}, {"s1+s4", "s2+s5+s6"}},
      recorded::SheetChoice{"no-faces", "s1+s2+s3", false},
      recorded::SheetMirror{{1, -2.5}, {}},
      recorded::SheetMirror{{1, -2.5}, plain_drawing(test::bottle(), test::three_point_views()[0]).drawing.strokes},
  };
  for (const recorded::Step& step : steps) {
    const std::string line = recorded::to_line(step);
    INFO(line);
    CHECK(recorded::to_line(recorded_again(step)) == line);
  }
  CHECK_THROWS_AS(recorded::parse(R"({"do":"perspective-set","strokes":["a"]})", "t", recorded::all_steps()), Error);
  CHECK_THROWS_AS(recorded::parse(R"({"do":"perspective-stroke","points":[[1]]})", "t", recorded::all_steps()), Error);
}

TEST_CASE("a recording of gestures makes the same drawing") {
  const test::SolidDrawing truth = plain_drawing(test::bottle(), test::three_point_views()[1]);
  test::Random random(8);
  Hand hand, replayed;
  for (const PerspectiveStroke& stroke : truth.drawing.strokes) {
    if (stroke.role != StrokeRole::Edge) continue;
    hand.tool.set_group(stroke.group);
    if (hand.drag(test::hand_drawn(stroke.pieces, random, 3)) != Verdict::Commit) continue;
    const recorded::Step step = recorded_again(*hand.tool.done());
    REQUIRE(step.as<recorded::SheetStroke>() != nullptr);
    replayed.tool.take(step);
  }
  REQUIRE(hand.tool.drawing()->strokes.size() >= 20);
  CHECK(same_drawing(*hand.tool.drawing(), *replayed.tool.drawing()));
  // Every end of a hand that misses by 3 px has found the vertex that it was meant for.
  CHECK(vertices_of(*hand.tool.drawing()).size() == truth.network.vertices.size());
}

TEST_CASE("changing the unit keeps known lengths at their size, and choosing faces is one step back") {
  Hand hand;
  hand.line({100, 100}, {400, 90});
  hand.tool.take(recorded::SheetUnit{"mm"});
  hand.tool.take(recorded::SheetLength{"s1", 120.0});
  hand.tool.take(recorded::SheetPoint{KnownPoint{{100, 100}, {10, 20, 30}}});
  CHECK(hand.tool.take(recorded::SheetUnit{"cm"}) == Verdict::Commit);
  CHECK(hand.tool.drawing()->known_lengths[0].length == Approx(12));
  CHECK((hand.tool.drawing()->known_point->point - Vec3(1, 2, 3)).norm() < 1e-12);
  CHECK(hand.tool.take(recorded::SheetUnit{"cm"}) == Verdict::Continue);
  CHECK_THROWS_AS(hand.tool.take(recorded::SheetUnit{"furlong"}), Error);
  hand.session.undo();
  CHECK(hand.tool.drawing()->known_lengths[0].length == 120);

  hand.tool.take(recorded::SheetChoice{"faces", "s1+s2+s3", true});
  CHECK(hand.tool.take(recorded::SheetFaces{{"s4+s5+s6"}, {"s1+s2+s3"}}) == Verdict::Commit);
  CHECK(hand.tool.is_chosen("faces", "s4+s5+s6"));
  CHECK_FALSE(hand.tool.is_chosen("faces", "s1+s2+s3"));
  CHECK(hand.tool.is_chosen("no-faces", "s1+s2+s3"));
  hand.session.undo();
  CHECK(hand.tool.is_chosen("faces", "s1+s2+s3"));
  CHECK_FALSE(hand.tool.is_chosen("no-faces", "s1+s2+s3"));
}

TEST_CASE("lengths and points are read as people type them") {
  CHECK(read_length("120", "mm") == 120);
  CHECK(*read_length(" 12 cm ", "mm") == Approx(120));
  CHECK(*read_length("4,5in", "cm") == Approx(11.43));
  CHECK(*read_length("1 inch", "mm") == Approx(25.4));
  CHECK(read_length("7", "") == 7);
  for (const char* wrong : {"", "abc", "-3", "0", "1 2", "3 miles", "nan", "1e999"})
    CHECK_FALSE(read_length(wrong, "mm"));
  CHECK_FALSE(read_length("12 cm", ""));
  CHECK(*read_point("0 0 0", "") == Vec3(0, 0, 0));
  CHECK(*read_point("1, -2, 3.5", "mm") == Vec3(1, -2, 3.5));
  CHECK(*read_point("1,2,3", "mm") == Vec3(1, 2, 3));
  CHECK((*read_point("1 2,5 3 cm", "mm") - Vec3(10, 25, 30)).norm() < 1e-12);
  for (const char* wrong : {"", "1 2", "1 2 3 4", "a b c", "1 2 3 cm"}) CHECK_FALSE(read_point(wrong, ""));
}

TEST_CASE("a replay that knows nothing of the camera gives automatic strokes and those of a mirror their groups") {
  const test::SolidDrawing truth = plain_drawing(test::bottle(), test::three_point_views()[1]);
  Hand hand, replayed;
  hand.tool.set_solved(std::make_shared<const SolvedDrawing>(truth_of(truth)));
  test::Random random(6);
  std::size_t guessed = 0;
  const auto replay_last = [&] { return replayed.tool.take(recorded_again(*hand.tool.done())); };
  double low = 1e9, high = -1e9;
  for (const Vec3& vertex : truth.network.vertices) {
    low = std::min(low, vertex.y());
    high = std::max(high, vertex.y());
  }
  for (const NetworkCurve& curve : truth.network.curves) {
    const double nearer = std::min(truth.network.vertices[curve.start].y(), truth.network.vertices[curve.end].y());
    if (nearer > (low + high) / 2) continue;
    const PerspectiveStroke* stroke = find_stroke(truth.drawing, curve.id);
    if (hand.drag(test::hand_drawn(stroke->pieces, random, 2)) != Verdict::Commit) continue;
    guessed += hand.tool.drawing()->strokes.back().group != StrokeGroup::Unknown;
    replay_last();
    CHECK(same_drawing(*hand.tool.drawing(), *replayed.tool.drawing()));
  }
  // One gesture around a corner: two strokes, whose groups are recorded one by one.
  std::vector<Vec2> bent;
  for (int k = 0; k < 100; ++k) bent.emplace_back(k < 50 ? 20 + 4 * k : 220, k < 50 ? 40 + k : 90 + 4 * (k - 50));
  REQUIRE(hand.drag(bent) == Verdict::Commit);
  CHECK(hand.tool.done()->as<recorded::SheetStroke>()->groups.size() == 2);
  replay_last();
  CHECK(same_drawing(*hand.tool.drawing(), *replayed.tool.drawing()));
  CHECK(guessed > 8);

  // The strokes are not those of the truth's names, so its curves are mirrored in a drawing that has them.
  Hand named, mirrored;
  SolvedDrawing found = truth_of(truth);
  std::erase_if(found.network.curves, [&](const NetworkCurve& curve) {
    return std::min(found.network.vertices[curve.start].y(), found.network.vertices[curve.end].y()) > (low + high) / 2;
  });
  const MirrorPlane plane{1, (low + high) / 2};
  for (Hand* one : {&named, &mirrored}) {
    PerspectiveDrawing half = truth.drawing;
    for (const NetworkCurve& curve : truth.network.curves) {
      const double nearer = std::min(truth.network.vertices[curve.start].y(), truth.network.vertices[curve.end].y());
      if (nearer > plane.at) remove_strokes(half, {curve.id});
    }
    one->open(half);
  }
  named.tool.set_solved(std::make_shared<const SolvedDrawing>(found));
  REQUIRE(named.tool.take(recorded::SheetMirror{plane, {}}) == Verdict::Commit);
  const recorded::Step step = recorded_again(*named.tool.done());
  REQUIRE(step.as<recorded::SheetMirror>()->strokes.size() > 5);
  REQUIRE(mirrored.tool.take(step) == Verdict::Commit);
  CHECK(same_drawing(*named.tool.drawing(), *mirrored.tool.drawing()));
}

}  // namespace
}  // namespace croquis
