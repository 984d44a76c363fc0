// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <sstream>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/geometry/mesh_tags.h"
#include "croquis/tools/all_steps.h"
#include "croquis/tools/holes/hole_steps.h"
#include "croquis/tools/mesh/mesh_steps.h"
#include "croquis/tools/recording/general_steps.h"
#include "croquis/tools/recording/recording.h"
#include "croquis/tools/silhouette/sketch_steps.h"
#include "support/random.h"

namespace croquis::recorded {
namespace {

Findings findings_of(const std::string& text) {
  try {
    parse(text, "walk.jsonl", all_steps());
  } catch (const Error& error) {
    return error.findings();
  }
  return {};
}

std::vector<Step> one_of_each() {
  StrokeDrawn stroke;
  stroke.points = {{{1.5, -2}, 0.25, Vec2::Zero(), 0}, {{0.1, 1e-300}, 1, Vec2::Zero(), 1.0 / 3}};
  stroke.device = "pen";
  stroke.scale = 0.125;
  return {stroke,
          Drag{"stroke 1", 3, {0.1, -0.2}},
          Drag{"outline \"left\"\n", std::nullopt, {5, 6}},
          Action{"undo"},
          Set{"inflate", "weight-curvature", 0.5},
          Set{"inflate", "preset", std::string("tablet")},
          Set{"inflate", "count", std::int64_t{7}},
          Set{"inflate", "flag", true},
          Set{"inflate", "whole", 2.0},
          Wait{},
          Screenshot{"x.png"},
          File{"save", "a.croq"},
          File{"open", "b.svg"},
          File{"export", "ü.obj"},
          File{"export", "all.obj", false, "all", "mm"},
          File{"open", "b.obj", true},
          File{"open", "photo.png", false, {}, {}, true},
          Place{{"mug", "bolt"}, {{{1, 2, 3}, {0, 90, -0.1}, {1, 1, 2}}, Placement()}},
          Click{"sketch", {1, 2}, {"shift", "ctrl"}},
          Box{"sketch", {-1, -2}, {3, 4}, {}},
          Navigate{"perspective", "tumble", {30, -10}},
          Expect{"objects", 3}};
}

/// The steps for meshes.
std::vector<Step> one_of_each_for_meshes() {
  return {Click{"perspective", Vec2::Zero(), {"shift"}, Vec3(0.1, -2, 1e-9), 2},
          Box{"top", Vec2::Zero(), Vec2::Zero(), {}, Vec3(0, 1, 2), Vec3(3, 4, 1.0 / 3)},
          ModelDrag{"front", {0, 0, 0}, {1, 2, 3}, {"ctrl"}},
          Pick{"bolt", "edge", {3, 1, 4000000000U}, "loop"},
          Pick{"bolt", "vertex", {}, "all"},
          Move{"bolt", {0.1, 0, -7}},
          Rotate{"bolt", {0, 0, 2}, 33.3, Vec3(1, 1, 1)},
          Rotate{"bolt", {0, 1, 0}, -720, std::nullopt},
          Scale{"bolt", {1, 2, 0.5}, std::nullopt},
          Tag{"bolt", "selected", 0, infinite_sharpness, std::nullopt},
          Tag{"bolt", "selected", 0, 0.0, std::nullopt},
          Tag{"bolt", "sharper-than", 60, 2.5, std::nullopt},
          Tag{"bolt", "selected", 0, std::nullopt, -1.25},
          Pin{"bolt", false},
          TagSet{"bolt", "make", "collar", "", 3.0},
          TagSet{"bolt", "rename", "collar", "neck", std::nullopt},
          TagSet{"bolt", "sharpness", "neck", "", infinite_sharpness},
          TagSet{"bolt", "select", "neck", "", std::nullopt},
          Extrude{"bolt", {0, 0, 0.5}},
          LoopCut{"bolt", 17, 0.25},
          Expect{"sharp-edges", 4, std::nullopt, std::nullopt, "subdivide"},
          Expect{"dihedral", 0, 90.0, 91.5, ""}};
}

TEST_CASE("steps for meshes read back as they were written") {
  for (const Step& step : one_of_each_for_meshes()) {
    const std::string line = to_line(step);
    INFO(line);
    const Step back = parse(line, "walk.jsonl", all_steps()).front().step;
    CHECK(&back.kind() == &step.kind());
    CHECK(to_line(back) == line);
  }
  const auto click = *parse(to_line(one_of_each_for_meshes()[0]), "", all_steps()).front().step.as<Click>();
  CHECK(click.place == Vec3(0.1, -2, 1e-9));
  CHECK(click.clicks == 2);
  const auto tag =
      *parse("{\"do\":\"tag\",\"node\":\"a\",\"sharpness\":\"inf\"}", "", all_steps()).front().step.as<Tag>();
  CHECK(tag.sharpness == infinite_sharpness);
  CHECK(tag.edges == "selected");
  const auto pick = *parse("{\"do\":\"pick\",\"node\":\"a\",\"kind\":\"face\",\"elements\":[7]}", "", all_steps())
                         .front()
                         .step.as<Pick>();
  CHECK(pick.how == "replace");
  CHECK(pick.elements == std::vector<Index>{7});
}

TEST_CASE("steps for holes read back as they were written") {
  for (const Step& step : std::vector<Step>{
           HoleChoice{{3}, "fill", {}}, HoleChoice{{}, "fill", "fill", 0.25}, HoleWay{{1, 2}, "flat", {}, {}, {}, {}},
           FaceSetChoice{"scan", {"patches", "patch of hole 3"}}, HoleWay{{}, {}, "biharmonic", -0.5, 2, "fill"},
           HoleChoice{{1, 4000000000U, 2}, "toggle", "fill"}, HoleChoice{{}, "select", {}},
           HolePoint{7, Vec3(0.1, -2, 1e-9), Vec3(1.0 / 3, 0, 1), {}},
           HolePoint{7, std::nullopt, Vec3(0, 0, 1), "fill"}, HolePoint{7, Vec3(0, 0, 1), std::nullopt, {}}}) {
    const std::string line = to_line(step);
    INFO(line);
    const Step back = parse(line, "walk.jsonl", all_steps()).front().step;
    CHECK(&back.kind() == &step.kind());
    CHECK(to_line(back) == line);
  }
  const auto choice = *parse(R"({"do":"hole","hole":3})", "", all_steps()).front().step.as<HoleChoice>();
  CHECK(choice.holes == std::vector<Index>{3});
  CHECK(choice.action == "select");
  const auto point =
      *parse(to_line(HolePoint{7, Vec3(1, 2, 3), Vec3(4, 5, 6), {}}), "", all_steps()).front().step.as<HolePoint>();
  CHECK(point.hole == 7);
  CHECK(point.from == Vec3(1, 2, 3));
  CHECK(point.to == Vec3(4, 5, 6));
}

TEST_CASE("every mistake in a step for holes is named") {
  const std::vector<std::string> wrong = {R"({"do":"hole"})",
                                          R"({"do":"hole","holes":[]  ,"action":"fill"})",
                                          R"({"do":"hole","hole":-1})",
                                          R"({"do":"hole","hole":1,"holes":[2]})",
                                          R"({"do":"hole","holes":[1],"action":"close"})",
                                          R"({"do":"hole","holes":[1],"action":"fill","up-to":2})",
                                          R"({"do":"hole","action":"leave","up-to":2})",
                                          R"({"do":"hole","action":"fill","up-to":0})",
                                          R"({"do":"face-set","node":"scan","names":[]})",
                                          R"({"do":"face-set","names":["patches"]})",
                                          R"({"do":"hole-way","holes":[1]})",
                                          R"({"do":"hole-way","holes":[1],"bulge":2})",
                                          R"({"do":"hole-way","holes":[1],"fairness":"round"})",
                                          R"({"do":"hole-point","from":[1,2,3],"to":[1,2,3]})",
                                          R"({"do":"hole-point","hole":1})",
                                          R"({"do":"hole-point","hole":1,"to":[1,2]})"};
  std::string text;
  for (const std::string& line : wrong) text += line + "\n";
  const Findings findings = findings_of(text);
  REQUIRE(findings.size() == wrong.size());
  for (std::size_t i = 0; i < wrong.size(); ++i)
    CHECK(findings[i].message.find("Line " + std::to_string(i + 1) + " ") == 0);
}

TEST_CASE("every mistake in a step for meshes is named") {
  const std::vector<std::string> wrong = {
      R"({"do":"pick","node":"a","kind":"corner","elements":[1]})",
      R"({"do":"pick","node":"a","kind":"edge","elements":[-1]})",
      R"({"do":"pick","node":"a","kind":"edge","elements":[1.5]})",
      R"({"do":"pick","node":"a","kind":"edge","elements":[4294967295]})",
      R"({"do":"pick","node":"a","kind":"edge","elements":4})",
      R"({"do":"pick","node":"a","kind":"edge","elements":[1],"how":"magic"})",
      R"({"do":"pick","kind":"edge","elements":[1]})",
      R"({"do":"move","node":"a","by":[1,2]})",
      R"({"do":"rotate","node":"a","axis":[0,0,0],"degrees":5})",
      R"({"do":"rotate","node":"a","axis":[0,0,1],"degrees":"5"})",
      R"({"do":"scale","node":"a","factors":[1,1,1],"pivot":[1,2]})",
      R"({"do":"tag","node":"a"})",
      R"({"do":"tag","node":"a","sharpness":-1})",
      R"({"do":"tag","node":"a","sharpness":"infinite"})",
      R"({"do":"tag","node":"a","sharpness":1,"change":1})",
      R"({"do":"tag","node":"a","edges":"sharper-than","sharpness":1})",
      R"({"do":"pin","node":"a","pinned":1})",
      R"({"do":"tag-set","node":"a","how":"rename","name":"x"})",
      R"({"do":"tag-set","node":"a","how":"sharpness","name":"x"})",
      R"({"do":"tag-set","node":"a","how":"select","name":"x","sharpness":1})",
      R"({"do":"loop-cut","node":"a","edge":1,"at":1})",
      R"({"do":"click","at":[1,2,3,4]})",
      R"({"do":"click","at":[1,2,3],"clicks":3})",
      R"({"do":"box","from":[1,2,3],"to":[1,2]})",
      R"({"do":"drag","from":[1,2],"to":[1,2]})",
      R"({"do":"drag","from":[1,2,3],"to":[1,2,3],"by":[1,2]})",
      R"({"do":"expect","what":"dihedral","count":90})",
      R"({"do":"expect","what":"faces","value":90})",
  };
  std::string text;
  for (const std::string& line : wrong) text += line + '\n';
  const Findings findings = findings_of(text);
  REQUIRE(findings.size() == wrong.size());
  for (std::size_t i = 0; i < findings.size(); ++i)
    CHECK(findings[i].subjects.front().line == static_cast<std::int64_t>(i) + 1);
}

TEST_CASE("every kind of step reads back as it was written") {
  std::string text;
  Recorder recorder([&](const std::string& line) { text += line; });
  for (const Step& step : one_of_each()) recorder.add(step);
  const std::vector<Line> lines = parse(text, "walk.jsonl", all_steps());
  REQUIRE(lines.size() == one_of_each().size());
  std::istringstream stream(text);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::string written;
    std::getline(stream, written);
    CHECK(lines[i].number == static_cast<std::int64_t>(i) + 1);
    CHECK(&lines[i].step.kind() == &one_of_each()[i].kind());
    CHECK(to_line(lines[i].step) == written);
  }
  const auto& stroke = *lines[0].step.as<StrokeDrawn>();
  REQUIRE(stroke.points.size() == 2);
  CHECK(stroke.points[1].position == Vec2(0.1, 1e-300));
  CHECK(stroke.points[1].time == 1.0 / 3);
  CHECK(stroke.points[0].pressure == 0.25);
  CHECK(stroke.scale == 0.125);
  CHECK(lines[1].step.as<Drag>()->anchor == 3U);
  CHECK(!lines[2].step.as<Drag>()->anchor);
  CHECK(lines[2].step.as<Drag>()->stroke == "outline \"left\"\n");
  for (std::size_t i = 4; i <= 8; ++i) CHECK(lines[i].step.as<Set>()->value == one_of_each()[i].as<Set>()->value);
}

TEST_CASE("the documented lines are understood, with their defaults") {
  const std::vector<Line> lines = parse(
      "# a walk\n\n"
      "{\"do\":\"stroke\",\"points\":[[0,0],[1,2,0.5],[3,4,0.5,0.1]]}\r\n"
      "  {\"do\":\"click\",\"at\":[1,2]}\n"
      "{\"do\":\"navigate\",\"motion\":\"dolly\",\"by\":[1,2]}",
      "walk.jsonl", all_steps());
  REQUIRE(lines.size() == 3);
  CHECK(lines[0].number == 3);
  const auto& stroke = *lines[0].step.as<StrokeDrawn>();
  CHECK(stroke.view == "sketch");
  CHECK(stroke.device == "mouse");
  CHECK(stroke.points[0].pressure == 1);
  CHECK(stroke.scale == 0);
  CHECK(lines[1].step.as<Click>()->view == "sketch");
  CHECK(lines[2].step.as<Navigate>()->view == "perspective");
  CHECK(parse("", "empty", all_steps()).empty());
}

TEST_CASE("every line that can't be understood is named with its number, all at once") {
  const std::vector<std::string> wrong = {
      "pear",
      "[1,2]",
      "{\"do\":\"fly\"}",
      "{\"name\":\"undo\"}",
      "{\"do\":7}",
      "{\"do\":\"action\"}",
      "{\"do\":\"action\",\"name\":\"undo\",\"times\":2}",
      "{\"do\":\"stroke\",\"points\":[]}",
      "{\"do\":\"stroke\",\"points\":[[1]]}",
      "{\"do\":\"stroke\",\"points\":[[1,2,3]]}",
      "{\"do\":\"stroke\",\"points\":[[1,\"2\"]]}",
      "{\"do\":\"stroke\",\"points\":[[1,1e999]]}",
      "{\"do\":\"stroke\",\"points\":[[1,2]],\"device\":\"foot\"}",
      "{\"do\":\"stroke\",\"points\":[[1,2]],\"scale\":0}",
      "{\"do\":\"drag\",\"stroke\":\"a\",\"anchor\":-1,\"by\":[1,2]}",
      "{\"do\":\"drag\",\"stroke\":\"a\",\"anchor\":1.5,\"by\":[1,2]}",
      "{\"do\":\"drag\",\"stroke\":\"a\",\"by\":[1,2,3]}",
      "{\"do\":\"set\",\"node\":\"inflate\",\"parameter\":\"x\",\"value\":null}",
      "{\"do\":\"click\",\"at\":[1,2],\"modifiers\":[\"hyper\"]}",
      "{\"do\":\"navigate\",\"motion\":\"fly\",\"by\":[1,2]}",
      "{\"do\":\"expect\",\"what\":\"luck\",\"count\":1}",
      "{\"do\":\"expect\",\"what\":\"objects\",\"count\":-1}",
      "{\"do\":\"action\",\"name\":\"\xff\"}",
  };
  std::string text = "{\"do\":\"action\",\"name\":\"undo\"}\n";
  for (const std::string& line : wrong) text += line + '\n';
  const Findings findings = findings_of(text);
  REQUIRE(findings.size() == wrong.size());
  for (std::size_t i = 0; i < findings.size(); ++i) {
    INFO(wrong[i] << ": " << findings[i].message);
    CHECK(findings[i].code == "E_REPLAY");
    CHECK(findings[i].subjects.front().line == static_cast<std::int64_t>(i) + 2);
    CHECK(findings[i].subjects.front().file == "walk.jsonl");
  }
}

TEST_CASE("damaged recordings are refused or read, never worse") {
  std::string text;
  for (const Step& step : one_of_each()) text += to_line(step) + '\n';
  for (const Step& step : one_of_each_for_meshes()) text += to_line(step) + '\n';
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    test::Random random(seed);
    std::string damaged = text;
    for (std::uint32_t edit = 0; edit <= random.below(4); ++edit) {
      const std::size_t at = random.below(static_cast<std::uint32_t>(damaged.size()));
      if (random.below(2) == 0)
        damaged[at] = static_cast<char>(random.below(256));
      else
        damaged.erase(at, random.below(20));
    }
    try {
      for (const Line& line : parse(damaged, "damaged", all_steps())) REQUIRE(!to_line(line.step).empty());
    } catch (const Error& error) {
      for (const Finding& finding : error.findings()) REQUIRE(finding.code == "E_REPLAY");
    }
  }
}

}  // namespace
}  // namespace croquis::recorded
