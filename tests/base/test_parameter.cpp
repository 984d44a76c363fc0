// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <stdexcept>
#include <variant>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/base/parameter.h"

using namespace croquis;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

ParameterDescription number(double minimum = -infinity, double maximum = infinity) {
  return {"size", ParameterType::Number, 1.0, minimum, maximum, {}, "", "How large."};
}

ParameterDescription integer(double minimum = -infinity, double maximum = infinity) {
  return {"count", ParameterType::Integer, std::int64_t{3}, minimum, maximum, {}, "", "How many."};
}

ParameterDescription choice() {
  return {"mode", ParameterType::Choice, std::string("fast"), -infinity, infinity, {"fast", "good", "best"}, "",
          "How."};
}

ParameterDescription flag() { return {"wire", ParameterType::Flag, false, -infinity, infinity, {}, "", "Draw edges."}; }

ParameterDescription text() {
  return {"label", ParameterType::Text, std::string(), -infinity, infinity, {}, "", "A name."};
}

/// The findings of a refusal; fails when there is none.
template <typename Action>
Findings findings_of(Action action) {
  try {
    action();
  } catch (const Error& error) {
    return error.findings();
  }
  FAIL("accepted");
  return {};
}

}  // namespace

TEST_CASE("numbers are read whole and nothing else is") {
  CHECK(std::get<double>(parse_parameter(number(), "2.5")) == 2.5);
  CHECK(std::get<double>(parse_parameter(number(), "-1e-3")) == -1e-3);
  CHECK(std::get<double>(parse_parameter(number(), "7")) == 7.0);
  for (const char* bad : {"", " 1", "1 ", "1,5", "1.5mm", "nan", "inf", "-infinity", "1e999", "0x10", "--1", "e5"}) {
    INFO("'" << bad << "'");
    CHECK_THROWS_AS(parse_parameter(number(), bad), Error);
  }
}

TEST_CASE("whole numbers are read whole and nothing else is") {
  CHECK(std::get<std::int64_t>(parse_parameter(integer(), "-12")) == -12);
  CHECK(std::get<std::int64_t>(parse_parameter(integer(), "9223372036854775807")) ==
        std::numeric_limits<std::int64_t>::max());
  for (const char* bad : {"", "1.0", "1e3", "9223372036854775808", "12a", " 3", "true"}) {
    INFO("'" << bad << "'");
    CHECK_THROWS_AS(parse_parameter(integer(), bad), Error);
  }
}

TEST_CASE("flags, choices and texts take what they say") {
  CHECK(std::get<bool>(parse_parameter(flag(), "true")));
  CHECK_FALSE(std::get<bool>(parse_parameter(flag(), "false")));
  for (const char* bad : {"1", "yes", "TRUE", ""}) CHECK_THROWS_AS(parse_parameter(flag(), bad), Error);
  CHECK(std::get<std::string>(parse_parameter(choice(), "best")) == "best");
  for (const char* bad : {"", "Best", "fas", "worst"}) CHECK_THROWS_AS(parse_parameter(choice(), bad), Error);
  CHECK(std::get<std::string>(parse_parameter(text(), "")).empty());
  CHECK(std::get<std::string>(parse_parameter(text(), "12 true")) == "12 true");
}

TEST_CASE("ranges include their ends") {
  const ParameterDescription range = number(0, 1);
  CHECK(std::get<double>(parse_parameter(range, "0")) == 0.0);
  CHECK(std::get<double>(parse_parameter(range, "1")) == 1.0);
  CHECK_THROWS_AS(parse_parameter(range, "1.0000000000000002"), Error);
  CHECK_THROWS_AS(parse_parameter(range, "-5e-324"), Error);
  CHECK(std::get<std::int64_t>(parse_parameter(integer(1, 4), "4")) == 4);
  CHECK_THROWS_AS(parse_parameter(integer(1, 4), "0"), Error);
  CHECK_THROWS_AS(parse_parameter(integer(1, 4), "5"), Error);
}

TEST_CASE("a refusal names the parameter, the value and what would have been accepted") {
  const auto message = [](const ParameterDescription& description, const std::string& value) {
    const Findings findings = findings_of([&] { parse_parameter(description, value); });
    REQUIRE(findings.size() == 1);
    CHECK(findings[0].code == "E_PARAMETER");
    CHECK(findings[0].category == Category::Usage);
    REQUIRE(findings[0].subjects.size() == 1);
    CHECK(findings[0].subjects[0].kind == SubjectKind::Parameter);
    CHECK(findings[0].subjects[0].id == description.name);
    CHECK(findings[0].message.find("'" + value + "'") != std::string::npos);
    CHECK(findings[0].message.find(description.name) != std::string::npos);
    return findings[0].message;
  };
  CHECK(message(number(0, 2.5), "3").find("from 0 to 2.5") != std::string::npos);
  CHECK(message(number(1), "0").find("at least 1") != std::string::npos);
  CHECK(message(integer(-infinity, 9), "x").find("whole number of at most 9") != std::string::npos);
  CHECK(message(choice(), "slow").find("fast, good or best") != std::string::npos);
  CHECK(message(flag(), "1").find("true or false") != std::string::npos);
}

TEST_CASE("completing fills in defaults and keeps what was given") {
  const std::vector<ParameterDescription> all = {number(0, 10), integer(), choice(), flag(), text()};
  const ParameterValues values = complete(all, {{"size", 4.0}, {"wire", true}});
  REQUIRE(values.size() == 5);
  CHECK(std::get<double>(values.at("size")) == 4.0);
  CHECK(std::get<bool>(values.at("wire")));
  CHECK(std::get<std::int64_t>(values.at("count")) == 3);
  CHECK(std::get<std::string>(values.at("mode")) == "fast");
  CHECK(complete(all, values) == values);
}

TEST_CASE("a preset sets what isn't given, and nothing that is, whatever its value") {
  ParameterDescription preset{"preset", ParameterType::Choice, std::string("plain"), 0, 0, {"plain", "rough"}, "", ""};
  preset.presets["rough"] = {{"size", 7.0}, {"mode", std::string("best")}};
  ParameterDescription mode = choice();
  mode.choices.emplace_back("preset");
  const std::vector<ParameterDescription> all = {number(0, 10), mode, preset};
  const ParameterValues defaults = complete(all, {});
  const ParameterValues rough = complete(all, {{"preset", std::string("rough")}, {"mode", std::string("preset")}});
  CHECK(number_of(rough, "size") == 7.0);
  CHECK(text_of(rough, "mode") == "best");
  CHECK(complete(all, rough) == rough);
  for (const char* name : {"size", "mode"}) {
    const ParameterValues told = complete(all, {{"preset", std::string("rough")}, {name, defaults.at(name)}});
    CHECK(told.at(name) == defaults.at(name));
  }
  CHECK(complete(all, {{"mode", std::string("preset")}}) == defaults);
}

TEST_CASE("completing reports everything that is wrong at once") {
  const std::vector<ParameterDescription> all = {number(0, 10), integer(), choice(), flag()};
  const Findings findings = findings_of([&] {
    complete(all, {{"size", 11.0}, {"count", 2.0}, {"mode", std::string("slow")}, {"wire", true}, {"wier", true}});
  });
  REQUIRE(findings.size() == 4);
  for (const Finding& finding : findings) CHECK(finding.code == "E_PARAMETER");
  CHECK(findings[0].subjects[0].id == "count");
  CHECK(findings[3].subjects[0].id == "wier");
}

TEST_CASE("values that are not finite or too large are refused even without a range") {
  for (const double value : {infinity, -infinity, std::nan(""), 1e31, -1e308}) {
    const Findings findings = findings_of([&] { complete({number()}, {{"size", value}}); });
    CHECK(findings.size() == 1);
  }
}

TEST_CASE("text turns back into the same value") {
  for (const double value : {0.0, -0.0, 0.1, 1.0 / 3, 1e-310, 5e-324, -1e30, 123456789.125}) {
    const double again = std::get<double>(parse_parameter(number(), to_text(value)));
    CHECK(again == value);
    CHECK(std::signbit(again) == std::signbit(value));
  }
  for (const std::int64_t value : {std::numeric_limits<std::int64_t>::min(), std::int64_t{-1}, std::int64_t{0},
                                   std::numeric_limits<std::int64_t>::max()}) {
    CHECK(std::get<std::int64_t>(parse_parameter(integer(), to_text(value))) == value);
  }
  for (const bool value : {false, true}) CHECK(std::get<bool>(parse_parameter(flag(), to_text(value))) == value);
  for (const std::string value : {"fast", "good", "best"}) {
    CHECK(std::get<std::string>(parse_parameter(choice(), to_text(value))) == value);
  }
}

TEST_CASE("types are spelled for help and files") {
  CHECK(to_string(ParameterType::Flag) == std::string("flag"));
  CHECK(to_string(ParameterType::Integer) == std::string("integer"));
  CHECK(to_string(ParameterType::Number) == std::string("number"));
  CHECK(to_string(ParameterType::Choice) == std::string("choice"));
  CHECK(to_string(ParameterType::Text) == std::string("text"));
  CHECK(to_string(ParameterType::File) == std::string("file"));
}

TEST_CASE("a text that a program wrote is a text, and brings along what it stands for") {
  const ParsedText parsed("two", std::vector<int>{1, 1});
  REQUIRE(parsed.value<std::vector<int>>() != nullptr);
  CHECK(*parsed.value<std::vector<int>>() == std::vector<int>{1, 1});
  CHECK(parsed.value<int>() == nullptr);
  CHECK(to_text(parsed) == "two");
  CHECK(parsed == ParsedText("two", 2));
  CHECK_FALSE(parsed == ParsedText("three", 2));
  CHECK(complete({text()}, {{text().name, parsed}}).at(text().name) == ParameterValue(parsed));
  CHECK_THROWS_AS(complete({choice()}, {{choice().name, ParsedText("fast", 1)}}), Error);
}

TEST_CASE("a description is found by its whole name alone") {
  const std::vector<ParameterDescription> all = {number(), integer(), choice(), flag(), text()};
  for (const ParameterDescription& description : all) CHECK(find_parameter(all, description.name) == &description);
  for (const char* name : {"", "siz", "sizes", "Size"}) CHECK(find_parameter(all, name) == nullptr);
  CHECK(find_parameter({}, "size") == nullptr);
}

TEST_CASE("complete values are read by name and type") {
  const ParameterValues values = complete({number(), integer(), choice(), flag(), text()}, {{"size", 2.5}});
  CHECK(number_of(values, "size") == 2.5);
  CHECK(integer_of(values, "count") == 3);
  CHECK(text_of(values, "mode") == "fast");
  CHECK_FALSE(flag_of(values, "wire"));
  CHECK_THROWS_AS(number_of(values, "width"), std::out_of_range);
  CHECK_THROWS_AS(number_of(values, "count"), std::bad_variant_access);
}

TEST_CASE("titles are words for people, with the value where it says something") {
  ParameterDescription level = integer_parameter("levels", 2, 0, 6, "", "How fine.");
  level.title = "Level";
  CHECK(title_of(level) == "Level");
  CHECK(title_with(level, std::int64_t{3}) == "Level 3");
  ParameterDescription scheme = choice_parameter("scheme", {"loop", "doo-sabin"}, "Rules.");
  CHECK(title_of(scheme) == "Scheme");
  CHECK(title_with(scheme, std::string("doo-sabin")) == "Scheme doo-sabin");
  scheme.title = "Smoothing";
  scheme.choice_titles = {"Triangles", "Soft"};
  CHECK(title_with(scheme, std::string("doo-sabin")) == "Smoothing Soft");
  CHECK(title_with(flag_parameter("patch-ids", true, "Marks."), false) == "Patch ids off");
  CHECK(title_with(text_parameter("known-point", "", "Where."), std::string("1,2=3")) == "Known point");
}
