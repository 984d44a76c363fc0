// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <bit>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/geometry/face_orientation.h"
#include "support/random.h"

using namespace croquis;
using namespace croquis::test;

namespace {

/// Two faces with a common edge.
struct Neighbours {
  Index a, b;
  bool disagree;
};

/// More than any face here has neighbours: every pair has a corner of its own at both faces.
constexpr Index corners_per_face = 100;

FaceOrientation oriented(Index face_count, const std::vector<Neighbours>& pairs) {
  return orient_faces(face_count, [&](Index face, auto&& visit) {
    for (Index i = 0; i < pairs.size(); ++i) {
      const Neighbours& pair = pairs[i];
      if (pair.a == face) visit(corners_per_face * face + i, pair.b, pair.disagree);
      if (pair.b == face) visit(corners_per_face * face + i, pair.a, pair.disagree);
    }
  });
}

std::vector<Index> parts_by_spreading(Index face_count, const std::vector<Neighbours>& pairs) {
  std::vector<Index> part(face_count);
  for (Index face = 0; face < face_count; ++face) part[face] = face;
  for (Index round = 0; round < face_count; ++round) {
    for (const Neighbours& pair : pairs) part[pair.a] = part[pair.b] = std::min(part[pair.a], part[pair.b]);
  }
  return part;
}

bool agrees(const std::vector<Neighbours>& pairs, const std::vector<Index>& lowest, Index part, unsigned turned) {
  return std::ranges::all_of(pairs, [&](const Neighbours& pair) {
    const bool differ = ((turned >> pair.a ^ turned >> pair.b) & 1U) != 0;
    return lowest[pair.a] != part || differ == pair.disagree;
  });
}

}  // namespace

TEST_CASE("of every part the fewest faces are turned that make all agree, as trying all choices shows") {
  Random random(5);
  std::size_t conflicts = 0, ties = 0;
  for (int run = 0; run < 400; ++run) {
    const Index count = 1 + random.below(8);
    std::vector<Neighbours> pairs;
    for (Index i = random.below(2 * count); i > 0; --i) {
      const Index a = random.below(count), b = random.below(count);
      if (a != b) pairs.push_back({a, b, random.below(2) == 0});
    }
    const FaceOrientation found = oriented(count, pairs);
    const std::vector<Index> lowest = parts_by_spreading(count, pairs);
    for (Index part = 0; part < count; ++part) {
      if (lowest[part] != part) continue;
      unsigned members = 0, turned = 0;
      for (Index face = 0; face < count; ++face) {
        if (lowest[face] != part) continue;
        members |= 1U << face;
        turned |= static_cast<unsigned>(found.turned[face]) << face;
        CHECK(found.part[face] == found.part[part]);
      }
      std::vector<unsigned> sound;
      for (unsigned choice = 0; choice < 1U << count; ++choice) {
        if ((choice & ~members) == 0 && agrees(pairs, lowest, part, choice)) sound.push_back(choice);
      }
      const Index conflict = found.conflict[found.part[part]];
      REQUIRE((conflict == no_index) == !sound.empty());
      if (sound.empty()) {
        ++conflicts;
        CHECK((members >> (conflict / corners_per_face) & 1U) != 0);
        continue;
      }
      REQUIRE(sound.size() == 2);
      const auto size = [](unsigned choice) { return std::popcount(choice); };
      const bool tie = size(sound[0]) == size(sound[1]);
      ties += tie ? 1 : 0;
      const auto expected = tie ? std::ranges::find_if(sound, [&](unsigned c) { return (c >> part & 1U) == 0; })
                                : std::ranges::min_element(sound, {}, size);
      CHECK(turned == *expected);
    }
  }
  CHECK(conflicts > 50);
  CHECK(ties > 50);
}

TEST_CASE("parts are numbered by their lowest faces") {
  const FaceOrientation found = oriented(5, {{4, 1, false}, {3, 0, true}});
  CHECK(found.part == std::vector<Index>{0, 1, 2, 0, 1});
  CHECK(found.conflict.size() == 3);
}
