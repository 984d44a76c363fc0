// SPDX-License-Identifier: GPL-3.0-or-later
#include <stdexcept>

#include <catch2/catch.hpp>

#include "croquis/base/report.h"

using namespace croquis;

TEST_CASE("members keep the order of their first setting") {
  Report report;
  report.set("b", 1).set("a", 2).set("c", 3).set("a", 4);
  REQUIRE(report.as_object().size() == 3);
  CHECK(report.as_object()[0].first == "b");
  CHECK(report.as_object()[1].first == "a");
  CHECK(report.at("a").as_integer() == 4);
}

TEST_CASE("values keep their types") {
  Report report;
  report.set("flag", true).set("count", std::size_t{7}).set("ratio", 0.5).set("name", "x").set("none", Report());
  CHECK(std::get<bool>(report.at("flag").value()));
  CHECK(report.at("count").as_integer() == 7);
  CHECK(report.at("count").as_number() == 7.0);
  CHECK(report.at("ratio").as_number() == 0.5);
  CHECK_THROWS_AS(report.at("ratio").as_integer(), std::bad_variant_access);
  CHECK(report.at("name").as_string() == "x");
  CHECK(report.at("none").is_null());
  CHECK_FALSE(report.is_null());
}

TEST_CASE("arrays are lists of anything") {
  Report array;
  array.push(1);
  array.push("two");
  array.push(Report::list(std::vector<double>{3, 4}));
  REQUIRE(array.as_array().size() == 3);
  CHECK(array.as_array()[2].as_array()[1].as_number() == 4.0);
  CHECK(Report::array().as_array().empty());
  CHECK(Report::object().as_object().empty());
  CHECK_FALSE(Report::array().is_null());
}

TEST_CASE("looking for what is not there says so") {
  Report report;
  CHECK(report.find("a") == nullptr);
  report.set("a", 1);
  CHECK(report.find("b") == nullptr);
  REQUIRE(report.find("a") != nullptr);
  CHECK_THROWS_AS(report.at("b"), std::out_of_range);
  CHECK(Report(3).find("a") == nullptr);
  CHECK_THROWS_AS(Report(3).set("a", 1), std::bad_variant_access);
  CHECK_THROWS_AS(report.push(1), std::bad_variant_access);
}

TEST_CASE("a copy is a value of its own") {
  Report report;
  report.set("list", Report::list(std::vector<int>{1, 2}));
  Report copy = report;
  copy.set("list", "gone");
  CHECK(report.at("list").as_array().size() == 2);
}
