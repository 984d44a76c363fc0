// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/io/json.h"
#include "io/random_project.h"
#include "support/random.h"

using namespace croquis;
using namespace croquis::test;

namespace {

Report parsed(const std::string& text) { return read_json(text, "file"); }

Finding refused(const std::string& text) {
  try {
    parsed(text);
  } catch (const Error& error) {
    REQUIRE(error.findings().size() == 1);
    CHECK(error.findings()[0].category == Category::Malformed);
    return error.findings()[0];
  }
  FAIL("it was read: " << text.substr(0, 100));
  return {};
}

}  // namespace

TEST_CASE("JSON becomes a report with its numbers, texts and order") {
  const Report report =
      parsed("{\"b\": [1, -2, 1.0, 2e3, true, null, \"a\\u00e4\\n\"], \"a\": {}, \"big\": 18446744073709551615}");
  const Report::Array& list = report.at("b").as_array();
  REQUIRE(list.size() == 7);
  CHECK(list[0].as_integer() == 1);
  CHECK(list[1].as_integer() == -2);
  CHECK(std::holds_alternative<double>(list[2].value()));
  CHECK(list[3].as_number() == 2000);
  CHECK(std::get<bool>(list[4].value()));
  CHECK(list[5].is_null());
  CHECK(list[6].as_string() == "a\xc3\xa4\n");
  CHECK(report.as_object()[0].first == "b");
  CHECK(report.at("a").as_object().empty());
  CHECK(report.at("big").as_number() == 18446744073709551615.0);
  CHECK(parsed("3").as_integer() == 3);
}

TEST_CASE("of JSON members with one name the last one counts") {
  const Report report = parsed("{\"a\": 1, \"b\": 2, \"a\": [3]}");
  REQUIRE(report.as_object().size() == 2);
  CHECK(report.at("a").as_array()[0].as_integer() == 3);
}

TEST_CASE("damaged JSON is refused with its line") {
  CHECK(refused("").code == "E_EMPTY");
  CHECK(refused(" \n\t").code == "E_EMPTY");
  for (const char* text : {"{\n\"a\": }", "{\n\"a\": 1,}", "[1,\n2", "[1\n2]", "{\"a\"\n1}", "[\nnan]", "[\n1e999]",
                           "[1,\n\"\xff\"]", "[\n01]", "1\n2", "\n{'a': 1}", "[\n\"\t\"]"}) {
    INFO(text);
    const Finding finding = refused(text);
    CHECK(finding.code == "E_SYNTAX");
    CHECK(finding.subjects.at(0).line == 2);
    CHECK_THAT(finding.message, Catch::StartsWith("'file', line 2: "));
    CHECK_THAT(finding.message, !Catch::Contains("exception"));
  }
}

TEST_CASE("JSON may be nested as deep as the limit and no deeper") {
  const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
  CHECK(parsed(nested(200)).as_array().size() == 1);
  CHECK_THAT(refused(nested(201)).message, Catch::Contains("200 levels"));
  CHECK(refused(std::string(1'000'000, '[')).code == "E_SYNTAX");
  std::string objects;
  for (int i = 0; i < 201; ++i) objects += "{\"a\":";
  CHECK(refused(objects).code == "E_SYNTAX");
}

TEST_CASE("reports that JSON can hold come back from it") {
  const std::string text =
      "{\n \"a\": [\n  1,\n  0.1,\n  -0.0,\n  5e-324\n ],\n \"b\": {},\n \"c\": \"\xc3\xa4\\\"\"\n}\n";
  CHECK(write_json(parsed(text)) == text);
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const std::string once = write_json(random_report(random));  // NaN and bytes that are no text are lost here
    CHECK(write_json(parsed(once)) == once);
  }
}
