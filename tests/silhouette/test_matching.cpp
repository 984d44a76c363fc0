// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <vector>

#include <catch2/catch.hpp>

#include "algorithms/silhouette/figure/labelling.h"
#include "support/random.h"

using namespace croquis;
using namespace croquis::silhouette;
using croquis::test::Random;

namespace {

/// Costs of all perfect matchings by trying everything, ascending.
void collect_costs(const std::vector<MatchingEdge>& edges, std::vector<char>& matched, double cost,
                   std::vector<double>& all) {
  const auto free = std::find(matched.begin(), matched.end(), 0);
  if (free == matched.end()) {
    all.push_back(cost);
    return;
  }
  const auto node = static_cast<Index>(free - matched.begin());
  for (const MatchingEdge& edge : edges) {
    if ((edge.a != node && edge.b != node) || matched[edge.a] || matched[edge.b]) continue;
    matched[edge.a] = matched[edge.b] = 1;
    collect_costs(edges, matched, cost + edge.cost, all);
    matched[edge.a] = matched[edge.b] = 0;
  }
}

std::vector<MatchingEdge> random_edges(Random& random, Index nodes, double share) {
  std::vector<MatchingEdge> edges;
  for (Index a = 0; a < nodes; ++a) {
    for (Index b = a + 1; b < nodes; ++b) {
      if (random.unit() < share) edges.push_back({a, b, random.between(0.1, 10)});
    }
  }
  return edges;
}

}  // namespace

TEST_CASE("matchings come in order of cost and all of them come") {
  Random random(11);
  for (int round = 0; round < 60; ++round) {
    const Index nodes = 2 * (1 + random.below(4));
    const std::vector<MatchingEdge> edges = random_edges(random, nodes, round % 2 == 0 ? 1.0 : 0.5);
    std::vector<char> matched(nodes, 0);
    std::vector<double> expected;
    collect_costs(edges, matched, 0, expected);
    std::sort(expected.begin(), expected.end());

    MatchingSearch search(nodes, edges, 100'000);
    std::vector<double> found;
    while (const auto matching = search.next()) {
      double cost = 0;
      std::vector<int> uses(nodes, 0);
      for (const Index e : *matching) {
        cost += edges[e].cost;
        ++uses[edges[e].a];
        ++uses[edges[e].b];
      }
      CHECK(std::count(uses.begin(), uses.end(), 1) == static_cast<std::ptrdiff_t>(nodes));
      CHECK((found.empty() || cost >= found.back() - 1e-9));
      found.push_back(cost);
    }
    REQUIRE(found.size() == expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) CHECK(found[i] == Approx(expected[i]));
    CHECK_FALSE(search.limit_reached());
  }
}

TEST_CASE("no nodes have one empty matching, an odd number none") {
  MatchingSearch empty(0, {}, 10);
  REQUIRE(empty.next().has_value());
  CHECK_FALSE(empty.next().has_value());
  CHECK_FALSE(MatchingSearch(3, {{0, 1, 1.0}, {1, 2, 1.0}}, 10).next().has_value());
}

TEST_CASE("a matching search knows when it stops early") {
  Random random(5);
  MatchingSearch search(20, random_edges(random, 20, 1.0), 5);
  while (search.next()) {
  }
  CHECK(search.limit_reached());
}

TEST_CASE("the cheapest pairing of 64 ends with known sides is found at once") {
  // Where sides are known only left ends fit right ends: then the bound is exact.
  Random random(8);
  std::vector<Vec2> places;
  for (int i = 0; i < 64; ++i) places.emplace_back(random.between(0, 100), random.between(0, 100));
  const auto distance = [&](Index a, Index b) { return (places[a] - places[b]).norm(); };
  std::vector<MatchingEdge> edges;
  for (Index a = 0; a < 64; a += 2) {
    for (Index b = 1; b < 64; b += 2) edges.push_back({a, b, distance(a, b)});
  }
  MatchingSearch search(64, edges, 20);
  const auto matching = search.next();
  REQUIRE(matching.has_value());
  // No exchange of partners between two pairs makes it cheaper.
  for (const Index e : *matching) {
    for (const Index f : *matching) {
      if (e == f) continue;
      CHECK(edges[e].cost + edges[f].cost <=
            distance(edges[e].a, edges[f].b) + distance(edges[f].a, edges[e].b) + 1e-9);
    }
  }
}
