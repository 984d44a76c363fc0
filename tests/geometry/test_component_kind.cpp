// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include <catch2/catch.hpp>

#include "croquis/geometry/component_kind.h"

using namespace croquis;

TEST_CASE("kinds of elements have the glossary's words, and are found by them alone") {
  CHECK(std::string(singular(ComponentKind::Vertex)) == "vertex");
  CHECK(std::string(plural(ComponentKind::Vertex)) == "vertices");
  for (const ComponentKind kind : component_kinds) {
    CHECK(kind_of_singular(singular(kind)) == kind);
    CHECK(kind_of_plural(plural(kind)) == kind);
    CHECK_FALSE(kind_of_singular(plural(kind)));
    CHECK_FALSE(kind_of_plural(singular(kind)));
  }
  CHECK_FALSE(kind_of_singular(""));
  CHECK_FALSE(kind_of_plural("Faces"));
}
