// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/base/stage_key.h"

namespace croquis {
namespace {

struct Inner {
  double size = 1;
  bool wire = false;
};
constexpr auto members(const Inner& inner) { return std::tie(inner.size, inner.wire); }
static_assert(lists_every_member<Inner>);

struct Outer {
  Inner inner;
  std::string name;
  std::vector<int> list;
  std::array<float, 3> place = {};
};
constexpr auto members(const Outer& outer) { return std::tie(outer.inner, outer.name, outer.list); }
static_assert(!lists_every_member<Outer>, "the place is forgotten");

TEST_CASE("members are counted, whatever their types and defaults are") {
  struct None {};
  struct One {
    std::vector<std::string> names;
  };
  STATIC_REQUIRE(member_count<None>() == 0);
  STATIC_REQUIRE(member_count<One>() == 1);
  STATIC_REQUIRE(member_count<Inner>() == 2);
  STATIC_REQUIRE(member_count<Outer>() == 4);
}

TEST_CASE("keys of options are those of their members, one after the other, those of members within too") {
  const Outer outer{{2, true}, "name", {1, 2}, {}};
  StageKey key, expected;
  key.add(outer);
  expected.add(2.0).add(true).add(std::string("name")).add(std::vector<int>{1, 2});
  CHECK(key.bytes() == expected.bytes());
}

TEST_CASE("pieces can't be shifted from one text or list into the next") {
  CHECK(StageKey().add("ab").add("c").bytes() != StageKey().add("a").add("bc").bytes());
  using List = std::vector<std::uint8_t>;
  CHECK(StageKey().add(List{1, 2}).add(List{3}).bytes() != StageKey().add(List{1}).add(List{2, 3}).bytes());
}

}  // namespace
}  // namespace croquis
