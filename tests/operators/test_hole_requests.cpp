// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/operators/hole_requests.h"
#include "operators/fill_settings.h"
#include "support/random.h"

namespace croquis {
namespace {

std::size_t refused_parts(const std::string& text) {
  try {
    parse_hole_requests(text);
  } catch (const Error& error) {
    for (const Finding& finding : error.findings()) {
      CHECK(finding.code == "E_PARAMETER");
      REQUIRE(finding.subjects.size() == 1);
      CHECK(finding.subjects[0].id == "holes");
    }
    return error.findings().size();
  }
  return 0;
}

TEST_CASE("requests for single holes are read as people write them") {
  const auto requests = parse_hole_requests(
      "3: leave; 5-7: flat, bulge 0.4; 4: through 0.1 0.2 0.3; 2+9: bridge; 8: fill; 1: kernel biharmonic; 6: trim 1");
  REQUIRE(requests.size() == 7);
  CHECK(requests[0] == HoleRequest{.holes = {3}, .fill = false});
  CHECK(requests[1] == HoleRequest{.holes = {5, 6, 7}, .fairness = hole_filling::Fairness::Flat, .bulge = 0.4});
  CHECK(requests[2] == HoleRequest{.holes = {4}, .through = {Vec3(0.1, 0.2, 0.3)}});
  CHECK(requests[3] == HoleRequest{.holes = {2, 9}, .bridge = true});
  CHECK(requests[4] == HoleRequest{.holes = {8}, .fill = true});
  CHECK(requests[5] == HoleRequest{.holes = {1}, .kernel = implicit::Kernel::Biharmonic});
  CHECK(requests[6] == HoleRequest{.holes = {6}, .trim_rim = 1});
  CHECK(parse_hole_requests("").empty());
  CHECK(parse_hole_requests(" ; ;").empty());
}

TEST_CASE("blanks don't matter in requests, and places may be several") {
  const auto requests = parse_hole_requests("\n 1 3,5 :through 1 2 3 ,\tthrough -1e-3 0 4;");
  REQUIRE(requests.size() == 1);
  CHECK(requests[0] == HoleRequest{.holes = {1, 3, 5}, .through = {Vec3(1, 2, 3), Vec3(-1e-3, 0, 4)}});
}

TEST_CASE("every part of a request that can't be read is refused by name") {
  for (const char* wrong : {"3",
                            "3:",
                            ": fill",
                            ",+: fill",
                            "a: fill",
                            "-1: fill",
                            "5-3: fill",
                            "3: melt",
                            "3: bulge",
                            "3: bulge 2",
                            "3: bulge nan",
                            "3: trim 4",
                            "3: trim -1",
                            "3: trim 1.5",
                            "3: kernel cubic",
                            "3: kernel",
                            "3: through 1 2",
                            "3: through 1 2 x",
                            "3: through 1 2 inf",
                            "3: through 1 2 3 4",
                            "3: fill leave",
                            "2: bridge",
                            "2+2: bridge",
                            "3: Fill"}) {
    INFO(wrong);
    CHECK(refused_parts(wrong) == 1);
  }
  CHECK(refused_parts("a: fill; 3: melt, bulge 7; 4: leave") == 3);
}

TEST_CASE("requests as text read back as the same requests") {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    test::Random random(seed);
    std::vector<HoleRequest> requests(1 + random.below(4));
    for (HoleRequest& request : requests) {
      for (Index i = 0; i < 1 + random.below(6); ++i) request.holes.push_back(random.below(12));
      request.fill = random.below(2) == 0;
      if (random.below(3) == 0) request.fill = std::nullopt;
      if (random.below(2) == 0) request.fairness = fairnesses[random.below(3)];
      if (random.below(2) == 0) request.kernel = static_cast<implicit::Kernel>(random.below(4));
      if (random.below(2) == 0) request.bulge = 2 * random.unit() - 1;
      if (random.below(2) == 0) request.trim_rim = static_cast<int>(random.below(4));
      for (Index i = random.below(3); i > 0; --i)
        request.through.emplace_back(random.unit() * 1e6, -random.unit() * 1e-9, random.unit());
      if (request.through.empty()) request.through.emplace_back(0.1, 1e30, -5);
      if (random.below(4) == 0) {
        request.holes = {7, 2};
        request.bridge = true;
      }
    }
    const std::string text = to_text(requests);
    INFO(text);
    CHECK(parse_hole_requests(text) == requests);
    CHECK(to_text(parse_hole_requests(text)) == text);
  }
  CHECK(to_text(std::vector<HoleRequest>{{.holes = {3}}, {.fairness = hole_filling::Fairness::Flat}}).empty());
  CHECK(to_text(std::vector<HoleRequest>{{.holes = {5, 6, 7, 2}, .fairness = hole_filling::Fairness::Flat}}) ==
        "5-7,2: flat");
}

TEST_CASE("which holes are filled goes into parameters and back, through their texts too") {
  FillChoice choice;
  choice.select = hole_filling::Selection::AllButLargest;
  choice.only = {2, 3, 4, 9};
  choice.requests = {{.holes = {3}, .fill = false}, {.holes = {4}, .through = {Vec3(0.1, 1.0 / 3, -2e-7)}}};
  const auto same = [&](const FillChoice& read) {
    return read.select == choice.select && read.only == choice.only && read.requests == choice.requests;
  };
  ParameterValues values = to_parameters(choice);
  CHECK(same(read_fill_choice(values)));
  for (const ParameterDescription& description : parameters_of(list_fill_parameters)) {
    const auto value = values.find(description.name);
    if (value != values.end()) value->second = parse_parameter(description, to_text(value->second));
  }
  CHECK(same(read_fill_choice(values)));
}

TEST_CASE("asking for nothing sets the parameters to their defaults") {
  const ParameterValues values = to_parameters({});
  for (const auto& [name, value] : values) CHECK(value == complete(parameters_of(list_fill_parameters), {}).at(name));
  CHECK(values.size() == 3);
}

TEST_CASE("requests that a program wrote aren't parsed") {
  ParameterValues values = complete(parameters_of(list_fill_parameters), {});
  const std::vector<HoleRequest> requests{{.holes = {7}, .fairness = hole_filling::Fairness::Flat}};
  values["holes"] = ParsedText("no request at all", requests);
  CHECK(read_fill_choice(values).requests == requests);
  values["holes"] = std::string("no request at all");
  CHECK_THROWS_AS(read_fill_choice(values), Error);
}

}  // namespace
}  // namespace croquis
