// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/tools/all_steps.h"
#include "croquis/tools/mesh/mesh_steps.h"
#include "croquis/tools/recording/general_steps.h"
#include "croquis/tools/recording/recording.h"
#include "croquis/tools/silhouette/sketch_steps.h"

namespace croquis::recorded {
namespace {

/// A step of a tool that the program doesn't have.
struct Measure {
  Vec3 from = Vec3::Zero();
  std::vector<Index> vertices;
  std::string unit = "mm";
  bool shown = true;

  static constexpr std::array verbs{"weigh"};
  void describe(Fields& fields) {
    fields.required("from", from);
    fields.required("vertices", vertices);
    fields.given("unit", unit, Words{"mm", "inch"});
    fields.required("shown", shown);
  }
};

Vocabulary with_measures() {
  Vocabulary vocabulary;
  vocabulary.add(all_steps());
  vocabulary.add(step_kind<Measure>());
  vocabulary.add_count("measures");
  vocabulary.add_range("length");
  return vocabulary;
}

/// What is wrong with a line, without the words about where it stands.
std::string mistake_in(const std::string& line, const Vocabulary& vocabulary) {
  try {
    parse(line, "walk.jsonl", vocabulary);
  } catch (const Error& error) {
    const std::string message = error.findings().front().message;
    const std::string beginning = "Line 1 of the recording can't be replayed: ";
    REQUIRE(message.starts_with(beginning));
    return message.substr(beginning.size());
  }
  return "none";
}

TEST_CASE("a tool's own step reads back as it was written, beside all others") {
  const Vocabulary vocabulary = with_measures();
  const Step step = Measure{{0.1, -2, 1e-9}, {3, 4000000000U}, "inch", false};
  CHECK(to_line(step) ==
        R"({"do":"weigh","from":[0.1,-2.0,1e-09],"vertices":[3,4000000000],"unit":"inch","shown":false})");
  const std::vector<Line> lines =
      parse(to_line(step) + "\n" + to_line(Move{"box", {1, 2, 3}}), "walk.jsonl", vocabulary);
  REQUIRE(lines.size() == 2);
  const auto* back = lines[0].step.as<Measure>();
  REQUIRE(back != nullptr);
  CHECK(back->from == Vec3(0.1, -2, 1e-9));
  CHECK(back->vertices == std::vector<Index>{3, 4000000000U});
  CHECK(back->unit == "inch");
  CHECK_FALSE(back->shown);
  CHECK(lines[0].step.as<Move>() == nullptr);
  REQUIRE(lines[1].step.as<Move>() != nullptr);
  CHECK(lines[1].step.as<Measure>() == nullptr);
}

TEST_CASE("a tool's own step is refused with a sentence that names what is wrong") {
  const Vocabulary vocabulary = with_measures();
  const std::string begin = R"({"do":"weigh","from":[1,2,3],"vertices":[1],"shown":true)";
  CHECK(mistake_in(begin + "}", vocabulary) == "none");
  CHECK(mistake_in(begin + "}", all_steps()) == "there is no step \"weigh\".");
  CHECK(mistake_in(begin + R"(,"unit":"ell"})", vocabulary) == "\"unit\" must be one of mm, inch.");
  CHECK(mistake_in(begin + R"(,"colour":"red"})", vocabulary) == "\"colour\" means nothing here.");
  CHECK(mistake_in(R"({"do":"weigh"})", vocabulary) == "\"from\" is missing.");
  CHECK(mistake_in(R"({"do":"weigh","from":[1,2]})", vocabulary) == "\"from\" must be three numbers.");
  CHECK(mistake_in(R"({"do":"weigh","from":[1,2,3],"vertices":[-1]})", vocabulary) ==
        "\"vertices\" must hold whole numbers of at least 0.");
  CHECK(mistake_in(R"({"do":"weigh","from":[1,2,3],"vertices":[1],"shown":1})", vocabulary) ==
        "\"shown\" must be true or false.");
}

TEST_CASE("a recording expects what its vocabulary counts and measures, nothing else") {
  const Vocabulary vocabulary = with_measures();
  const std::string count = R"({"do":"expect","what":"measures","count":2})";
  const std::string range = R"({"do":"expect","what":"length","value":1,"to":2})";
  CHECK(mistake_in(count, vocabulary) == "none");
  CHECK(mistake_in(range, vocabulary) == "none");
  CHECK(mistake_in(count, all_steps()).starts_with("\"what\" must be one of objects, "));
  CHECK(mistake_in(range, general_steps()).starts_with("\"what\" must be one of objects, "));
  CHECK(mistake_in(R"({"do":"expect","what":"measures","value":2})", vocabulary) == "\"count\" is missing.");
  CHECK(mistake_in(R"({"do":"expect","what":"length","count":2})", vocabulary) == "\"value\" is missing.");
}

TEST_CASE("steps that share a verb are told apart by a field, and may not share that too") {
  CHECK(parse(R"({"do":"drag","stroke":"a","by":[1,2]})", "", all_steps()).front().step.as<Drag>() != nullptr);
  const std::string model = R"({"do":"drag","from":[1,2,3],"to":[1,2,4]})";
  CHECK(parse(model, "", all_steps()).front().step.as<ModelDrag>() != nullptr);
  CHECK(mistake_in(R"({"do":"drag","by":[1,2]})", mesh_steps()) == "\"from\" is missing.");
  CHECK(mistake_in(R"({"do":"drag","by":[1,2]})", all_steps()) == "\"stroke\" is missing.");
  Vocabulary twice = with_measures();
  CHECK_THROWS_AS(twice.add(step_kind<Measure>()), Error);
  CHECK_THROWS_AS(twice.add(mesh_steps()), Error);
}

TEST_CASE("a copy of a step holds the same struct, whatever becomes of the first") {
  std::optional<Step> first = Step(Action{"undo"});
  const Step copy = *first;
  first = Wait{};
  REQUIRE(copy.as<Action>() != nullptr);
  CHECK(copy.as<Action>()->name == "undo");
  CHECK(first->as<Action>() == nullptr);
}

TEST_CASE("an edit is recorded by its line, and refused in the edit's own words") {
  const Vocabulary& vocabulary = all_steps();
  const std::string line = R"({"do":"edit","node":"box","line":"inset faces=3-4 width=0.1"})";
  const Step step = parse(line, "", vocabulary).front().step;
  REQUIRE(step.as<EditStep>() != nullptr);
  CHECK(step.as<EditStep>()->node == "box");
  CHECK(step.as<EditStep>()->line.target.elements == Elements{3, 4});
  CHECK(parse(to_line(step), "", vocabulary).front().step.as<EditStep>()->line == step.as<EditStep>()->line);
  const auto refusal = [&](const std::string& text) {
    return mistake_in(R"({"do":"edit","node":"box","line":")" + text + "\"}", vocabulary);
  };
  CHECK(refusal("bevel faces=1").starts_with("'bevel faces=1': there is no edit 'bevel', but "));
  CHECK(refusal("inset edges=1 width=1") == "'inset edges=1 width=1': it works on faces=.");
  CHECK(refusal("inset faces=1 depth=1").starts_with("'inset faces=1 depth=1': there is no 'depth'"));
  CHECK(refusal("") == "\"line\" must hold one edit.");
  CHECK(refusal("delete faces=1; delete faces=2") == "\"line\" must hold one edit.");
  CHECK(mistake_in(R"({"do":"edit","node":"box"})", vocabulary) == "\"line\" is missing.");
}

}  // namespace
}  // namespace croquis::recorded
