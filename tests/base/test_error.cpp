// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"

using namespace croquis;

TEST_CASE("an error keeps every finding in order") {
  const Error error(Findings{make_warning(Category::Geometry, "W_ONE", "First."),
                             make_error(Category::Malformed, "E_TWO", "Second."),
                             make_error(Category::Malformed, "E_THREE", "Third.")});
  REQUIRE(error.findings().size() == 3);
  CHECK(error.findings()[0].code == "W_ONE");
  CHECK(error.findings()[2].code == "E_THREE");
}

TEST_CASE("an error speaks with its first error's sentence, not with a warning's") {
  CHECK(std::string(Error(Findings{make_warning(Category::Geometry, "W_ONE", "First."),
                                   make_error(Category::Malformed, "E_TWO", "Second.")})
                        .what()) == "Second.");
  CHECK(std::string(Error(make_warning(Category::Geometry, "W_ONE", "First.")).what()) == "First.");
  CHECK_FALSE(std::string(Error(Findings{}).what()).empty());
}

TEST_CASE("cancelling is not an error") {
  const auto cancel = [] { throw Cancelled(); };
  CHECK_THROWS_AS(cancel(), Cancelled);
  try {
    cancel();
  } catch (const Error&) {
    FAIL("taken for an error");
  } catch (const std::exception& exception) {
    CHECK(std::string(exception.what()) == "cancelled");
  }
}
