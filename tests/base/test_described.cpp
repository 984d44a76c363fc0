// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <optional>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/base/described.h"

namespace croquis {
namespace {

enum class Kind { Hole, Part };
const char* to_string(Kind kind) { return kind == Kind::Hole ? "hole" : "part"; }

struct Piece {
  std::string name;
  Kind kind = Kind::Hole;
  std::optional<double> size;
};
auto described(const Piece& piece) {
  const auto& [name, kind, size] = piece;  // all of them: members that may be absent can't be counted otherwise
  return fields(named("name", name), named("kind", kind), named("size", size));
}

struct Complete {
  int one = 0, other = 0;
};
[[maybe_unused]] auto described(const Complete& complete) {
  return fields(named("one", complete.one), named("other", complete.other));
}
static_assert(describes_every_member<Complete>);

struct Forgetful {
  int kept = 0, forgotten = 0;
};
[[maybe_unused]] auto described(const Forgetful& forgetful) { return fields(named("kept", forgetful.kept)); }
static_assert(!describes_every_member<Forgetful>);

TEST_CASE("reports have the members of described structs by their names, in their order") {
  const std::vector<Piece> pieces = {{"a", Kind::Part, 2.5}, {"b", Kind::Hole, {}}};
  const Report report =
      to_report(fields(named("pieces", pieces), named("count", pieces.size()), named("at", std::array{1.0, -2.0}),
                       named("kinds", std::vector<std::pair<std::string, Kind>>{{"a", Kind::Part}})));
  const Report::Object& members = report.as_object();
  REQUIRE(members.size() == 4);
  CHECK(members[0].first == "pieces");
  const Report& first = report.at("pieces").as_array()[0];
  CHECK(first.at("name").as_string() == "a");
  CHECK(first.at("kind").as_string() == "part");
  CHECK(first.at("size").as_number() == 2.5);
  CHECK(report.at("pieces").as_array()[1].at("size").is_null());
  CHECK(report.at("count").as_integer() == 2);
  CHECK(report.at("at").as_array()[1].as_number() == -2);
  CHECK(report.at("kinds").at("a").as_string() == "part");
}

TEST_CASE("what a described struct takes is what its lists and texts take") {
  std::vector<Piece> pieces(3);
  const std::size_t empty = heap_size(pieces);
  CHECK(empty >= 3 * sizeof(Piece));
  pieces[1].name.assign(1000, 'x');
  CHECK(heap_size(pieces) >= empty + 900);
  CHECK(byte_size(pieces[1]) == sizeof(Piece) + heap_size(pieces[1]));
}

}  // namespace
}  // namespace croquis
