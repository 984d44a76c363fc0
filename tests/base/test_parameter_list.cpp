// SPDX-License-Identifier: GPL-3.0-or-later
#include <numbers>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/base/parameter_list.h"

namespace croquis {
namespace {

enum class Shape { Round, Square };

struct Settings {
  double size = 2, slope = std::numbers::pi / 12;
  std::optional<double> limit;
  std::optional<Shape> shape;
  Shape ends = Shape::Square;
  int rounds = 3;
  std::size_t segments = 8;
  bool kept = true, turned = false;
  std::string names;
};

void list_settings(Settings& settings, ParameterList& list) {
  list.number("size", settings.size, 0, 10, "m", "How large.").titled("Size");
  list.choice_of("preset", 0, {"fine", "rough"}, "What it is like.",
                 [&](std::size_t chosen) {
                   settings = {};
                   if (chosen == 0) return;
                   settings.size = 5;
                   settings.ends = Shape::Round;
                   settings.names = "rough";
                 })
      .sets_others();
  list.angle("slope", settings.slope, 0, 90, "How steep.").at(ParameterPlace::Expert);
  list.number("limit", settings.limit, 100, "", "At most; 0 for none.");
  list.choice("shape", settings.shape, {"any", "round", "square"}, "What it looks like.");
  list.choice("ends", settings.ends, {"round", "square"}, "What its ends look like.").or_preset();
  list.integer("rounds", settings.rounds, 0, 9, "", "How often.");
  list.choice_of_numbers("segments", settings.segments, {4, 8}, "Of how many.");
  list.flag("kept", settings.kept, "Whether it stays.");
  list.choice("turned", settings.turned, {"no", "yes"}, "Whether it is turned.");
  list.list("names", "Its names.", [&](const std::string& text) {
    if (text == "wrong") throw Error(refused_value("names", text, "names"));
    if (!text.empty()) settings.names = text;
  });
}

Settings read(const ParameterValues& given) {
  return settings_of(list_settings, complete(parameters_of(list_settings), given));
}

TEST_CASE("parameters have the values of the members as defaults") {
  const ParameterValues values = complete(parameters_of(list_settings), {});
  CHECK(values == ParameterValues{{"size", 2.0},
                                  {"preset", std::string("fine")},
                                  {"slope", 15.0},
                                  {"limit", 0.0},
                                  {"shape", std::string("any")},
                                  {"ends", std::string("square")},
                                  {"rounds", std::int64_t{3}},
                                  {"segments", std::string("8")},
                                  {"kept", true},
                                  {"turned", std::string("no")},
                                  {"names", std::string()}});
  const Settings settings = settings_of(list_settings, values);
  CHECK(settings.slope == Approx(std::numbers::pi / 12));
  CHECK(!settings.limit);
  CHECK(!settings.shape);
  CHECK(settings.ends == Shape::Square);
  CHECK(settings.segments == 8);
}

TEST_CASE("given values set the members that they are listed with") {
  const Settings settings = read({{"size", 3.0},
                                  {"slope", 45.0},
                                  {"limit", 7.0},
                                  {"shape", std::string("square")},
                                  {"ends", std::string("round")},
                                  {"rounds", std::int64_t{0}},
                                  {"segments", std::string("4")},
                                  {"kept", false},
                                  {"turned", std::string("yes")},
                                  {"names", std::string("a;b")}});
  CHECK(settings.size == 3);
  CHECK(settings.slope == std::numbers::pi / 4);
  CHECK(settings.limit == 7);
  CHECK(settings.shape == Shape::Square);
  CHECK(settings.ends == Shape::Round);
  CHECK(settings.rounds == 0);
  CHECK(settings.segments == 4);
  CHECK(!settings.kept);
  CHECK(settings.turned);
  CHECK(settings.names == "a;b");
}

TEST_CASE("a choice that sets others counts for what isn't given, wherever it is listed") {
  const std::vector<ParameterDescription> parameters = parameters_of(list_settings);
  CHECK(find_parameter(parameters, "preset")->presets ==
        std::map<std::string, ParameterValues>{{"rough", {{"size", 5.0}, {"ends", std::string("round")}}}});
  CHECK(find_parameter(parameters, "ends")->choices == std::vector<std::string>{"round", "square", "preset"});
  const Settings rough = read({{"preset", std::string("rough")}});
  CHECK(rough.size == 5);
  CHECK(rough.ends == Shape::Round);
  CHECK(rough.names == "rough");
  const Settings mixed = read({{"preset", std::string("rough")}, {"size", 2.0}, {"ends", std::string("preset")}});
  CHECK(mixed.size == 2);
  CHECK(mixed.ends == Shape::Round);
}

TEST_CASE("a text that can't be read is refused") { CHECK_THROWS_AS(read({{"names", std::string("wrong")}}), Error); }

}  // namespace
}  // namespace croquis
