// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <set>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/tools/all_steps.h"
#include "croquis/tools/recording/general_steps.h"
#include "croquis/tools/recording/recording.h"
#include "croquis/tools/silhouette/sketch_steps.h"
#include "croquis/tools/silhouette/sketch_tool.h"
#include "tools/pointer/pointer_traces.h"
#include "tools/strokes/drawn_strokes.h"

namespace croquis {
namespace {

using Ids = std::vector<std::string>;
using Kind = PenStep::Kind;

/// A session with its tool, and a hand that makes gestures on the sketch plane.
struct Desk {
  Session session;
  SketchTool tool{session};

  Verdict feed(Kind kind, const Vec2& at, Modifiers modifiers = {}, bool erases = false) {
    SketchEvent event;
    event.kind = kind;
    event.sample.position = at;
    event.sample.time = time += 0.01;
    event.modifiers = modifiers;
    event.erases = erases;
    return tool.handle(event);
  }
  Verdict gesture(const std::vector<Vec2>& places, Modifiers modifiers = {}, bool erases = false) {
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Verdict verdict = feed(i == 0 ? Kind::Begin : Kind::Sample, places[i], modifiers, erases);
      CHECK(verdict == Verdict::Continue);
    }
    return feed(Kind::End, places.back(), modifiers, erases);
  }
  Verdict draw_line(const Vec2& a, const Vec2& b) { return gesture(line(a, b)); }

  static std::vector<Vec2> line(const Vec2& a, const Vec2& b) {
    std::vector<Vec2> places;
    for (int i = 0; i <= 40; ++i) places.push_back(a + i / 40.0 * (b - a));
    return places;
  }
  Ids strokes() const {
    Ids ids;
    if (const auto drawing = tool.drawing()) {
      for (const Stroke& stroke : drawing->strokes) ids.push_back(stroke.id);
    }
    return ids;
  }
  const Stroke& stroke(const std::string& id) const { return *find_stroke(*tool.drawing(), id); }

  double time = 100;
};

/// Three parallel lines 100 apart, in Select mode.
void draw_three(Desk& desk) {
  for (int i = 0; i < 3; ++i) desk.draw_line({0, 100.0 * i}, {300, 100.0 * i});
  desk.tool.set_mode(SketchMode::Select);
}

constexpr Modifiers shift = {.shift = true};

TEST_CASE("the first stroke makes a drawing and the operation on it in one undo step") {
  Desk desk;
  CHECK(desk.tool.node() == 0);
  CHECK(desk.draw_line({0, 0}, {100, 0}) == Verdict::Commit);
  const auto& nodes = desk.session.document().nodes();
  REQUIRE(nodes.size() == 2);
  CHECK(nodes[0]->name == "Sketch");
  CHECK(desk.tool.node() == nodes[0]->id);
  CHECK(nodes[1]->operation == "inflate");
  CHECK(nodes[1]->inputs.at("drawing") == Link{nodes[0]->id, "value"});
  CHECK(!nodes[1]->parameters.contains("preset"));  // any lines
  CHECK(nodes[1]->parameters.at("attach") == ParameterValue(std::string("auto")));
  CHECK(desk.session.undo_labels() == Ids{"Draw stroke 1"});
  CHECK(desk.stroke("stroke 1").samples.size() == 41);
  CHECK(desk.stroke("stroke 1").samples.back().time == Approx(0.4));
  desk.session.undo();
  CHECK(desk.session.document().nodes().empty());
  desk.session.redo();
  CHECK(desk.strokes() == Ids{"stroke 1"});
}

TEST_CASE("the operation, its port and parameters are the host's choice") {
  Session session;
  SketchToolOptions options;
  options.operation = "trace";
  options.port = "lines";
  options.parameters = {};
  options.version = 3;
  SketchTool tool(session, options);
  for (int i = 0; i <= 10; ++i)
    tool.handle({i == 0 ? Kind::Begin : Kind::Sample, {{10.0 * i, 0}, 1, Vec2::Zero(), 0}, false, {}, 1});
  tool.handle({Kind::End, {{100, 0}, 1, Vec2::Zero(), 0}, false, {}, 1});
  const Node& node = *session.document().nodes().at(1);
  CHECK(node.operation == "trace");
  CHECK(node.version == 3);
  CHECK(node.inputs.contains("lines"));
  CHECK(node.parameters.empty());
}

TEST_CASE("further strokes go into the same drawing; ink is seen at once and gone afterwards") {
  Desk desk;
  desk.draw_line({0, 0}, {100, 0});
  desk.feed(Kind::Begin, {0, 50});
  desk.feed(Kind::Sample, {50, 50});
  CHECK(desk.tool.preview().ink.size() == 2);
  CHECK(desk.strokes().size() == 1);
  CHECK(desk.feed(Kind::End, {50, 50}) == Verdict::Commit);
  CHECK(desk.tool.preview().ink.empty());
  CHECK(desk.strokes() == Ids{"stroke 1", "stroke 2"});
  CHECK(desk.session.document().nodes().size() == 2);
  const auto& done = *desk.tool.done()->as<recorded::StrokeDrawn>();
  CHECK(done.points.size() == 2);
  CHECK(done.points[0].time == 0);
  CHECK(done.scale == 1);
}

TEST_CASE("a cancelled stroke, a tap and a change of mode leave nothing behind") {
  Desk desk;
  desk.feed(Kind::Begin, {0, 0});
  desk.feed(Kind::Sample, {80, 0});
  CHECK(desk.feed(Kind::Cancel, {80, 0}) == Verdict::Revert);
  CHECK(desk.gesture({{0, 0}, {1, 1}}) == Verdict::Revert);
  desk.feed(Kind::Begin, {0, 0});
  desk.feed(Kind::Sample, {80, 0});
  desk.tool.set_mode(SketchMode::Select);
  CHECK(desk.feed(Kind::End, {80, 0}) == Verdict::Continue);
  CHECK(desk.session.document().nodes().empty());
  CHECK(!desk.session.can_undo());
  CHECK(desk.tool.preview().ink.empty());
}

TEST_CASE("a stroke over part of another changes that one, unless Ctrl is held") {
  Desk desk;
  desk.draw_line({0, 0}, {400, 0});
  std::vector<Vec2> bump;
  for (int i = 0; i <= 60; ++i)
    bump.push_back(
        {100 + 200 * i / 60.0, 50 * std::pow(std::sin(3.14159265 * std::clamp(i / 40.0 - 0.25, 0.0, 1.0)), 2)});
  desk.gesture(bump);
  CHECK(desk.strokes() == Ids{"stroke 1"});
  CHECK(desk.session.undo_labels().back() == "Redraw stroke 1");
  desk.session.undo();
  desk.gesture(bump, {.ctrl = true});
  CHECK(desk.strokes() == Ids{"stroke 1", "stroke 2"});
}

TEST_CASE("clicks and boxes select; Shift adds and takes away") {
  Desk desk;
  draw_three(desk);
  CHECK(desk.gesture({{150, 103}}) == Verdict::Commit);
  CHECK(desk.tool.selected() == Ids{"stroke 2"});
  desk.gesture({{150, 2}}, shift);
  CHECK(desk.tool.selected() == Ids{"stroke 1", "stroke 2"});
  desk.gesture({{150, 101}}, shift);
  CHECK(desk.tool.selected() == Ids{"stroke 1"});
  desk.gesture({{150, 203}});
  CHECK(desk.tool.selected() == Ids{"stroke 3"});
  desk.gesture({{150, 50}});
  CHECK(desk.tool.selected().empty());
  desk.gesture({{100, 50}, {120, 80}, {200, 250}});
  CHECK(desk.tool.selected() == Ids{"stroke 2", "stroke 3"});
  desk.gesture({{200, 50}, {150, 0}, {100, -50}}, shift);
  CHECK(desk.tool.selected().size() == 3);
  CHECK(desk.tool.done()->as<recorded::Box>() != nullptr);
  CHECK(desk.session.undo_labels().size() == 3);  // selecting is no undo step
  desk.tool.select_all();
  CHECK(desk.tool.selected().size() == 3);
}

TEST_CASE("dragging a stroke moves what is selected as one undo step") {
  Desk desk;
  draw_three(desk);
  desk.gesture({{150, 0}, {160, 10}, {170, 50}});
  CHECK(desk.stroke("stroke 1").samples[0].position == Vec2(20, 50));
  CHECK(desk.tool.selected() == Ids{"stroke 1"});
  CHECK(desk.session.undo_labels().back() == "Move stroke 1");
  desk.gesture({{150, 100}}, shift);
  desk.gesture({{200, 100}, {200, 120}, {200, 130}});
  CHECK(desk.stroke("stroke 1").samples[0].position == Vec2(20, 80));
  CHECK(desk.stroke("stroke 2").samples[0].position == Vec2(0, 130));
  CHECK(desk.stroke("stroke 3").samples[0].position == Vec2(0, 200));
  CHECK(desk.session.undo_labels().back() == "Move 2 strokes");
  CHECK(desk.session.undo_labels().size() == 5);
  desk.session.undo();
  CHECK(desk.stroke("stroke 2").samples[0].position == Vec2(0, 100));
  CHECK(desk.stroke("stroke 1").samples[0].position == Vec2(20, 50));
}

TEST_CASE("dragging an anchor of a selected stroke bends it as one undo step, seen on the way") {
  Desk desk;
  draw_three(desk);
  desk.gesture({{150, 0}});
  const StrokeFit* fit = desk.tool.fit("stroke 1");
  REQUIRE(fit != nullptr);
  REQUIRE(fit->anchors.size() == 2);
  int changes = 0;
  desk.session.on_change([&] {
    ++changes;
    CHECK(desk.tool.fit("stroke 1") != nullptr);
  });
  desk.feed(Kind::Begin, {300, 1});
  desk.feed(Kind::Sample, {310, 11});
  desk.feed(Kind::Sample, {320, 31});
  CHECK(changes == 2);
  CHECK(desk.tool.preview().held_anchor == 1U);
  CHECK((desk.tool.fit("stroke 1")->anchors[1].position - Vec2(320, 30)).norm() < 1e-9);
  CHECK((desk.stroke("stroke 1").samples.back().position - Vec2(320, 30)).norm() < 1e-9);
  CHECK(desk.feed(Kind::End, {320, 31}) == Verdict::Commit);
  CHECK(desk.stroke("stroke 1").samples.front().position == Vec2(0, 0));
  CHECK(desk.session.undo_labels().back() == "Drag a point of stroke 1");
  CHECK(desk.session.undo_labels().size() == 4);
  const auto done = *desk.tool.done()->as<recorded::Drag>();
  CHECK(done.anchor == 1U);
  const auto after = desk.stroke("stroke 1").samples;
  desk.session.undo();
  CHECK(desk.stroke("stroke 1").samples.back().position == Vec2(300, 0));
  desk.tool.drag(done.stroke, done.anchor, done.by);
  for (std::size_t i = 0; i < after.size(); ++i)
    CHECK(desk.stroke("stroke 1").samples[i].position == after[i].position);
}

TEST_CASE("a cancelled drag gives everything back; one interrupted by undo ends") {
  Desk desk;
  draw_three(desk);
  const Document before = desk.session.document();
  desk.feed(Kind::Begin, {150, 0});
  desk.feed(Kind::Sample, {150, 50});
  CHECK(desk.stroke("stroke 1").samples[0].position == Vec2(0, 50));
  CHECK(desk.feed(Kind::Cancel, {150, 50}) == Verdict::Revert);
  CHECK(desk.stroke("stroke 1").samples[0].position == Vec2(0, 0));
  CHECK(desk.session.undo_labels().size() == 3);
  desk.feed(Kind::Begin, {150, 0});
  desk.feed(Kind::Sample, {150, 50});
  desk.session.undo();
  CHECK(desk.feed(Kind::Sample, {150, 90}) == Verdict::Revert);
  CHECK(desk.feed(Kind::End, {150, 90}) == Verdict::Continue);
  CHECK(desk.stroke("stroke 1").samples[0].position == Vec2(0, 0));
}

TEST_CASE("the eraser cuts what it covers out of lines in one step, in any mode") {
  Desk desk;
  draw_three(desk);
  CHECK(desk.gesture(Desk::line({50, 50}, {60, 60}), {}, true) == Verdict::Revert);
  desk.feed(Kind::Begin, {50, -30}, {}, true);
  desk.feed(Kind::Sample, {50, 30}, {}, true);
  REQUIRE(desk.tool.preview().erased.size() == 1);
  CHECK((desk.tool.preview().erased[0].front() - Vec2(44, 0)).norm() < 1e-9);
  CHECK((desk.tool.preview().erased[0].back() - Vec2(56, 0)).norm() < 1e-9);
  CHECK(desk.strokes().size() == 3);
  desk.feed(Kind::Sample, {50, 130}, {}, true);
  CHECK(desk.feed(Kind::End, {50, 130}, {}, true) == Verdict::Commit);
  CHECK(desk.strokes() == Ids{"stroke 1", "stroke 4", "stroke 2", "stroke 5", "stroke 3"});
  CHECK(desk.session.undo_labels().back() == "Erase part of 2 strokes");
  CHECK(desk.tool.done()->as<recorded::StrokeDrawn>()->device == "eraser");
  desk.session.undo();
  CHECK(desk.strokes().size() == 3);
  desk.tool.set_mode(SketchMode::Erase);
  CHECK(desk.gesture(Desk::line({-10, 203}, {310, 203})) == Verdict::Commit);
  CHECK(desk.strokes() == Ids{"stroke 1", "stroke 2"});
  CHECK(desk.session.undo_labels().back() == "Erase stroke 3");
}

TEST_CASE("with the right button or Shift a stroke is drawn behind what is there, and redraws nothing") {
  Desk desk;
  desk.draw_line({0, 0}, {400, 0});
  SketchEvent event;
  event.right = true;
  const std::vector<Vec2> over = Desk::line({100, 2}, {300, 2});
  for (std::size_t i = 0; i < over.size(); ++i) {
    event.kind = i == 0 ? Kind::Begin : Kind::Sample;
    event.sample.position = over[i];
    desk.tool.handle(event);
    CHECK(desk.tool.preview().behind);
  }
  event.kind = Kind::End;
  CHECK(desk.tool.handle(event) == Verdict::Commit);
  CHECK(desk.stroke("stroke 2").data.at("behind") == "all");
  CHECK(desk.tool.done()->as<recorded::StrokeDrawn>()->behind);
  desk.gesture(Desk::line({100, 50}, {300, 50}), shift);
  CHECK(desk.stroke("stroke 3").data.at("behind") == "all");
  desk.draw_line({0, 90}, {300, 90});
  CHECK(!desk.stroke("stroke 4").data.contains("behind"));
  CHECK(!desk.tool.preview().behind);
}

TEST_CASE("what is said of a stroke is one undo step, also when it is dragged") {
  Desk desk;
  draw_three(desk);
  CHECK(desk.tool.set({"stroke 2", silhouette::StrokeKind::Hole}) == Verdict::Commit);
  CHECK(desk.stroke("stroke 2").data.at("kind") == "hole");
  CHECK(desk.session.undo_labels().back() == "Make stroke 2 a hole");
  CHECK(desk.tool.set({"stroke 1", {}, "stroke 3"}) == Verdict::Commit);
  CHECK(desk.stroke("stroke 3").data.at("behind") == "stroke 1");
  CHECK(desk.session.undo_labels().back() == "Bring stroke 1 in front of stroke 3");
  for (const double factor : {0.9, 0.6, 0.4})
    CHECK(desk.tool.set({"stroke 1", {}, {}, factor}, true) == Verdict::Continue);
  CHECK(desk.stroke("stroke 1").data.at("thickness") == "0.4");
  CHECK(desk.tool.set({"stroke 1", {}, {}, 0.3}) == Verdict::Commit);
  CHECK(*desk.tool.done()->as<recorded::StrokeReading>()->thickness == 0.3);
  CHECK(desk.session.undo_labels().size() == 6);
  desk.session.undo();
  CHECK(!desk.stroke("stroke 1").data.contains("thickness"));
  CHECK_THROWS_AS(desk.tool.set({"none", {}, {}, 0.3}), Error);
  desk.tool.set({"stroke 1", {}, {}, 0.9}, true);
  CHECK(desk.feed(Kind::Cancel, {0, 0}) == Verdict::Revert);
  CHECK(!desk.stroke("stroke 1").data.contains("thickness"));
}

TEST_CASE("Delete removes what is selected, and does nothing otherwise") {
  Desk desk;
  CHECK(desk.tool.delete_selected() == Verdict::Continue);
  draw_three(desk);
  CHECK(desk.tool.delete_selected() == Verdict::Continue);
  desk.gesture({{150, 100}});
  CHECK(desk.tool.delete_selected() == Verdict::Commit);
  CHECK(desk.strokes() == Ids{"stroke 1", "stroke 3"});
  CHECK(desk.tool.selected().empty());
  CHECK(desk.session.undo_labels().back() == "Delete stroke 2");
}

TEST_CASE("when strokes are taken away the operation follows in the same undo step") {
  SketchToolOptions options;
  options.follow_removal = [](ParameterValues parameters, const Drawing& drawing) {
    parameters["attach"] = std::to_string(drawing.strokes.size());
    return parameters;
  };
  Session session;
  SketchTool tool(session, options);
  for (int line = 0; line < 2; ++line) {
    for (int i = 0; i <= 10; ++i)
      tool.handle({i == 0 ? Kind::Begin : Kind::Sample, {{10.0 * i, 50.0 * line}, 1, Vec2::Zero(), 0}, false, {}, 1});
    tool.handle({Kind::End, {{100, 50.0 * line}, 1, Vec2::Zero(), 0}, false, {}, 1});
  }
  const auto attach = [&] { return session.document().nodes().at(1)->parameters.at("attach"); };
  CHECK(attach() == ParameterValue(std::string("auto")));
  session.select({{tool.node(), "stroke 1"}});
  tool.delete_selected();
  CHECK(attach() == ParameterValue(std::string("1")));
  session.undo();
  CHECK(attach() == ParameterValue(std::string("auto")));
}

TEST_CASE("reach and click distance follow the zoom") {
  Desk desk;
  draw_three(desk);
  SketchEvent event;
  event.units_per_pixel = 10;
  event.sample.position = {150, 160};
  desk.tool.handle(event);
  event.kind = Kind::End;
  desk.tool.handle(event);
  CHECK(desk.tool.selected() == Ids{"stroke 3"});
  event.kind = Kind::Begin;
  event.units_per_pixel = 0.1;
  event.sample.position = {150, 198};
  desk.tool.handle(event);
  event.kind = Kind::End;
  desk.tool.handle(event);
  CHECK(desk.tool.selected().empty());
}

TEST_CASE("a drawing that is already there is worked on, another can be chosen") {
  Document document;
  for (const char* name : {"first", "second"}) {
    Node node;
    node.name = name;
    Drawing drawing;
    drawing.strokes = {test::circle(name, {0, 0}, 50)};
    node.source = std::make_shared<const Drawing>(drawing);
    document = document.with(node);
  }
  Session session(document);
  SketchTool tool(session);
  CHECK(tool.drawing()->strokes[0].id == "first");
  tool.set_node(session.document().nodes()[1]->id);
  CHECK(tool.drawing()->strokes[0].id == "second");
  CHECK_THROWS_AS(tool.drag("first", std::nullopt, {1, 1}), Error);
  tool.drag("second", std::nullopt, {1, 1});
  CHECK((tool.drawing()->strokes[0].samples[0].position - Vec2(51, 1)).norm() < 1e-12);
  CHECK(session.document().nodes().size() == 2);
}

TEST_CASE("driver traces reach the document as one stroke with every sample, in sketch units") {
  const SketchFrame frame{{-200, 150}, 0.5};
  for (const test::DriverTrace& driver : test::driver_traces(300, 4)) {
    INFO(driver.name);
    Desk desk;
    PenInput pen;
    test::Random random(2);
    for (const PointerEvent& event : test::interleaved(driver, 0.02, random)) {
      for (const PenStep& step : pen.handle(event)) desk.tool.handle(to_sketch(step, frame));
    }
    REQUIRE(desk.strokes() == Ids{"stroke 1"});
    const Stroke& stroke = desk.stroke("stroke 1");
    CHECK(stroke.samples.size() == 300);
    CHECK(stroke.samples[0].position == frame.to_sketch({500.25, 300.125}));
    CHECK(stroke.data.at("scale") == "0.5");
    CHECK(desk.session.undo_labels().size() == 1);
  }
}

TEST_CASE("what was recorded gives the same drawing again") {
  Desk desk;
  std::vector<recorded::Line> lines;
  const auto keep = [&] {
    const std::string line = recorded::to_line(*desk.tool.done());
    lines.push_back(recorded::parse(line, "recording", recorded::all_steps()).front());
  };
  desk.draw_line({0, 0}, {400, 10});
  keep();
  desk.gesture({{0, 100}, {30, 160}, {90, 170}, {140, 90}, {60, 60}, {2, 98}});
  keep();
  desk.tool.drag("stroke 2", 1, {12, 9});
  keep();
  desk.tool.drag("stroke 1", std::nullopt, {-3, 4});
  keep();
  desk.gesture(Desk::line({20, 200}, {300, 220}), shift);
  keep();
  desk.tool.set({"stroke 3", {}, {}, 0.25});
  keep();
  desk.tool.set({"stroke 2", silhouette::StrokeKind::Part});
  keep();
  desk.tool.set({"stroke 3", {}, "stroke 1"});
  keep();
  Desk again;
  for (const recorded::Line& line : lines) {
    if (const auto* drag = line.step.as<recorded::Drag>()) again.tool.drag(drag->stroke, drag->anchor, drag->by);
    if (const auto* stroke = line.step.as<recorded::StrokeDrawn>()) {
      SketchEvent event{Kind::Begin, {}, false, {}, stroke->scale};
      event.right = stroke->behind;
      for (const StrokeSample& point : stroke->points) {
        event.sample = point;
        again.tool.handle(event);
        event.kind = Kind::Sample;
      }
      event.kind = Kind::End;
      again.tool.handle(event);
    }
    if (const auto* setting = line.step.as<recorded::StrokeReading>()) again.tool.set(*setting);
  }
  REQUIRE(again.strokes() == desk.strokes());
  for (const std::string& id : desk.strokes()) {
    CHECK(again.stroke(id).data == desk.stroke(id).data);
    REQUIRE(again.stroke(id).samples.size() == desk.stroke(id).samples.size());
    for (std::size_t i = 0; i < desk.stroke(id).samples.size(); ++i)
      CHECK(again.stroke(id).samples[i].position == desk.stroke(id).samples[i].position);
  }
}

TEST_CASE("random gestures keep the document sound, and undoing all of them leads back to nothing") {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    test::Random random(seed);
    Desk desk;
    for (int i = 0; i < 120; ++i) {
      const auto place = [&] { return Vec2(random.between(0, 200), random.between(0, 200)); };
      switch (random.below(8)) {
        case 0: desk.tool.set_mode(static_cast<SketchMode>(random.below(3))); break;
        case 1: desk.session.undo(); break;
        case 2: desk.session.redo(); break;
        case 3:
          desk.feed(static_cast<Kind>(random.below(4)), place(), {random.below(3) == 0}, random.below(9) == 0);
          break;
        case 4: desk.tool.select_all(); break;
        default:
          desk.feed(Kind::Begin, place(), {random.below(3) == 0}, random.below(9) == 0);
          for (std::uint32_t k = 0; k < random.below(30); ++k) desk.feed(Kind::Sample, place());
          if (random.below(5) == 0) desk.session.undo();
          desk.feed(random.below(6) == 0 ? Kind::Cancel : Kind::End, place());
      }
      const Ids ids = desk.strokes();
      CHECK(std::set<std::string>(ids.begin(), ids.end()).size() == ids.size());
      for (const std::string& id : desk.tool.selected()) CHECK(desk.tool.fit(id) != nullptr);
    }
    desk.feed(Kind::Cancel, {0, 0});
    while (desk.session.can_undo()) desk.session.undo();
    CHECK(desk.session.document().nodes().empty());
  }
}

}  // namespace
}  // namespace croquis
