// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/hole_filling/editable_triangles.h"
#include "support/random.h"
#include "support/scans/scans.h"

using namespace croquis;
using namespace croquis::hole_filling;
using namespace croquis::test;

namespace {

using Triangles = std::vector<std::array<Index, 3>>;
using Edge = std::array<Index, 2>;

Triangles triangles_of(const PolyMesh& mesh) {
  Triangles triangles;
  for (Index f = 0; f < mesh.face_count(); ++f)
    triangles.push_back({mesh.face(f)[0], mesh.face(f)[1], mesh.face(f)[2]});
  return triangles;
}

/// Each triangle with its lowest vertex first, sorted: equal for equal surfaces.
Triangles sorted(Triangles triangles) {
  for (auto& t : triangles) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

std::set<Index> neighbours(const Triangles& triangles, Index v) {
  std::set<Index> found;
  for (const auto& t : triangles) {
    if (std::find(t.begin(), t.end(), v) != t.end()) found.insert(t.begin(), t.end());
  }
  found.erase(v);
  return found;
}

/// What the same step does to a plain list of triangles.
void split(Triangles& triangles, Index a, Index b, Index middle) {
  Triangles result;
  for (const auto& t : triangles) {
    const bool has_both = std::count(t.begin(), t.end(), a) + std::count(t.begin(), t.end(), b) == 2;
    for (const Index gone : has_both ? std::vector{a, b} : std::vector<Index>{}) {
      result.push_back(t);
      std::replace(result.back().begin(), result.back().end(), gone, middle);
    }
    if (!has_both) result.push_back(t);
  }
  triangles = result;
}

void collapse(Triangles& triangles, Index gone, Index kept) {
  for (auto& t : triangles) std::replace(t.begin(), t.end(), gone, kept);
  std::erase_if(triangles, [&](const auto& t) { return std::count(t.begin(), t.end(), kept) > 1; });
}

void flip(Triangles& triangles, Index a, Index b, Index c, Index d) {
  for (auto& t : triangles) {
    const bool has_a = std::count(t.begin(), t.end(), a) > 0, has_b = std::count(t.begin(), t.end(), b) > 0;
    if (has_a && has_b) t = std::count(t.begin(), t.end(), c) > 0 ? std::array{c, a, d} : std::array{d, b, c};
  }
}

void check_sides(const EditableTriangles& edited) {
  std::map<Edge, EditableTriangles::Side> sides;
  for (EditableTriangles::Side s = 0; s < edited.count(); ++s) {
    if (edited.from(s) == EditableTriangles::none) continue;
    CHECK(sides.emplace(Edge{edited.from(s), edited.to(s)}, s).second);
  }
  for (const auto& [edge, s] : sides) {
    const auto twin = sides.find({edge[1], edge[0]});
    CHECK(edited.twin(s) == (twin == sides.end() ? EditableTriangles::none : twin->second));
  }
}

}  // namespace

TEST_CASE("splits, collapses and flips in any order do what they do to a list of triangles") {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    Triangles list = triangles_of(round_sphere(1));
    Index vertices = 42, steps = 0;
    EditableTriangles edited(list, vertices);
    REQUIRE(edited.is_manifold(0));
    Random random(seed);
    for (int trial = 0; trial < 600; ++trial) {
      const EditableTriangles::Side s = random.below(edited.count());
      if (edited.from(s) == EditableTriangles::none) continue;
      const Index a = edited.from(s), b = edited.to(s), c = edited.apex(s), d = edited.apex(edited.twin(s));
      const auto around_a = neighbours(list, a), around_b = neighbours(list, b);
      std::vector<Index> common;
      std::set_intersection(around_a.begin(), around_a.end(), around_b.begin(), around_b.end(),
                            std::back_inserter(common));
      switch (random.below(3)) {
        case 0:
          edited.split(s);
          split(list, a, b, vertices++);
          break;
        case 1:
          if (common.size() != 2 || list.size() < 12) continue;
          edited.collapse(s);
          collapse(list, a, b);
          CHECK(edited.is_gone(a));
          break;
        default:
          if (neighbours(list, c).contains(d)) continue;
          edited.flip(s);
          flip(list, a, b, c, d);
      }
      ++steps;
      CHECK(sorted(edited.triangles()) == sorted(list));
    }
    check_sides(edited);
    CHECK(steps > 200);
    for (Index v = 0; v < vertices; ++v) {
      const std::set<Index> expected = neighbours(list, v);
      CHECK(edited.is_gone(v) == expected.empty());
      if (expected.empty()) continue;
      std::set<Index> found;
      edited.all_around(v, [&](EditableTriangles::Side s) { return found.insert(edited.to(s)).second; });
      CHECK(found == expected);
    }
  }
}

TEST_CASE("sides that were there at first are found again after splits") {
  const Triangles triangles = triangles_of(round_sphere(1));
  EditableTriangles edited(triangles, 42);
  std::map<EditableTriangles::Side, Edge> at_first;
  for (EditableTriangles::Side s = 0; s < edited.count(); ++s) at_first[s] = {edited.from(s), edited.to(s)};
  Random random(5);
  std::set<Edge> gone;  // edges with a new vertex in the middle
  for (int step = 0; step < 60; ++step) {
    const EditableTriangles::Side s = random.below(edited.count());
    gone.insert({edited.from(s), edited.to(s)});
    gone.insert({edited.to(s), edited.from(s)});
    edited.split(s);
  }
  for (const auto& [s, edge] : at_first) {
    if (gone.contains(edge)) continue;
    const EditableTriangles::Side now = edited.where_is_now(s);
    CHECK(Edge{edited.from(now), edited.to(now)} == edge);
  }
}

TEST_CASE("what isn't a surface is refused: crowded edges, touching fans, borders where none may be") {
  const Triangles closed = triangles_of(round_sphere(0));
  CHECK(EditableTriangles(closed, 12).is_manifold(0));
  Triangles twice = closed;
  twice.push_back(closed.front());
  CHECK_FALSE(EditableTriangles(twice, 12).is_manifold(0));
  const Triangles open(closed.begin() + 1, closed.end());
  CHECK_FALSE(EditableTriangles(open, 12).is_manifold(0));
  CHECK(EditableTriangles(open, 12).is_manifold(12));
  Triangles touching = closed;
  for (auto t : closed) {
    for (Index& v : t) v = v == 0 ? 0 : v + 11;
    touching.push_back(t);
  }
  CHECK_FALSE(EditableTriangles(touching, 23).is_manifold(0));
  CHECK(EditableTriangles(touching, 23).is_manifold(1));
}
