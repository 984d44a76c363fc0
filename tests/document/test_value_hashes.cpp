// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "document/value_hashes.h"
#include "support/trial_operation.h"

namespace croquis {
namespace {

TEST_CASE("hashes of values that come and go at the same address are their own") {
  ValueHashes hashes;
  // Allocators love to hand out the place just freed.
  for (int i = 0; i < 2000; ++i) {
    const Value value = test::point(i);
    REQUIRE(hashes.of(value) == content_hash(value));
    REQUIRE(hashes.of(value) == content_hash(value));
  }
}

TEST_CASE("two values of one owner have each their own hash") {
  struct Pair {
    PolyMesh first, second;
  };
  auto pair = std::make_shared<Pair>();
  pair->second.positions = {Vec3(1, 2, 3)};
  const Value first = std::shared_ptr<const PolyMesh>(pair, &pair->first);
  const Value second = std::shared_ptr<const PolyMesh>(pair, &pair->second);
  ValueHashes hashes;
  CHECK(hashes.of(first) == content_hash(first));
  CHECK(hashes.of(second) == content_hash(second));
  CHECK(hashes.of(first) != hashes.of(second));
}

TEST_CASE("a value without an owner is hashed as it is now") {
  PolyMesh mesh;
  const Value value = std::shared_ptr<const PolyMesh>(std::shared_ptr<void>(), &mesh);
  ValueHashes hashes;
  const ContentHash before = hashes.of(value);
  mesh.positions = {Vec3(1, 2, 3)};
  CHECK(hashes.of(value) != before);
  CHECK(hashes.of(Value(std::shared_ptr<const PolyMesh>())) == content_hash(Value(std::shared_ptr<const PolyMesh>())));
}

}  // namespace
}  // namespace croquis
