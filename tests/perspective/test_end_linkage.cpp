// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>
#include <set>
#include <vector>

#include <catch2/catch.hpp>

#include "algorithms/perspective/drawing/end_linkage.h"
#include "support/random.h"

using namespace croquis;
using namespace croquis::test;

namespace {

using Cluster = std::vector<std::size_t>;

bool may_join(const std::vector<LinkagePoint>& points, const Cluster& a, const Cluster& b) {
  for (const std::size_t i : a) {
    for (const std::size_t j : b) {
      const bool grouped = points[i].group != no_index && points[j].group != no_index;
      if (grouped && points[i].group != points[j].group) return false;
      if (points[i].owner == points[j].owner && !grouped) return false;
    }
  }
  return true;
}

double mean_distance(const std::vector<LinkagePoint>& points, const Cluster& a, const Cluster& b) {
  double sum = 0;
  for (const std::size_t i : a) {
    for (const std::size_t j : b) sum += (points[i].place - points[j].place).norm();
  }
  return sum / static_cast<double>(a.size() * b.size());
}

/// By the definition: all pairs of clusters, again after each join.
std::set<Cluster> clusters_by_definition(const std::vector<LinkagePoint>& points, double limit) {
  std::vector<Cluster> clusters;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto same = std::find_if(clusters.begin(), clusters.end(), [&](const Cluster& cluster) {
      return points[i].group != no_index && points[cluster[0]].group == points[i].group;
    });
    if (same != clusters.end()) {
      same->push_back(i);
    } else {
      clusters.push_back({i});
    }
  }
  while (true) {
    double best = limit;
    std::pair<std::size_t, std::size_t> pair{0, 0};
    for (std::size_t i = 0; i < clusters.size(); ++i) {
      for (std::size_t j = i + 1; j < clusters.size(); ++j) {
        if (!may_join(points, clusters[i], clusters[j])) continue;
        const double distance = mean_distance(points, clusters[i], clusters[j]);
        if (distance < best) {
          best = distance;
          pair = {i, j};
        }
      }
    }
    if (pair.second == 0) break;
    auto& into = clusters[pair.first];
    into.insert(into.end(), clusters[pair.second].begin(), clusters[pair.second].end());
    clusters.erase(clusters.begin() + static_cast<std::ptrdiff_t>(pair.second));
  }
  std::set<Cluster> result;
  for (Cluster& cluster : clusters) {
    std::sort(cluster.begin(), cluster.end());
    result.insert(cluster);
  }
  return result;
}

std::set<Cluster> clusters_of(const std::vector<Index>& numbers) {
  std::vector<Cluster> clusters(numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) clusters[numbers[i]].push_back(i);
  std::set<Cluster> result(clusters.begin(), clusters.end());
  result.erase(Cluster{});
  return result;
}

}  // namespace

TEST_CASE("ends are linked as average linkage is defined") {
  Random random(5);
  for (int round = 0; round < 300; ++round) {
    const double size = random.between(2, 30);
    std::vector<LinkagePoint> points;
    for (Index owner = 0; owner < 12; ++owner) {
      for (int end = 0; end < 2; ++end) {
        LinkagePoint point{Vec2(random.between(0, size), random.between(0, size)), owner, no_index};
        if (random.below(6) == 0) point.group = random.below(4);
        points.push_back(point);
      }
    }
    CHECK(clusters_of(link_nearest(points, 4)) == clusters_by_definition(points, 4));
  }
}

TEST_CASE("thousands of ends on one spot are linked within bounds") {
  std::vector<LinkagePoint> points(9000);
  for (Index i = 0; i < points.size(); ++i) points[i].owner = i;
  CHECK(clusters_of(link_nearest(points, 1)).size() == 3);
  points[0].place = Vec2(1e300, -1e300);
  points[1].place = Vec2(1e300, -1e300);
  CHECK(clusters_of(link_nearest(points, 1)).size() == 4);
}
