// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/items/reduced_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace croquis::render {
namespace {

constexpr double wanted_triangles = 30'000;
constexpr double sure_triangles = 36'000;  // with more than these a coarser grid is tried
constexpr int most_tries = 4;
/// Across each other, and aslant to the axes: the normals of a flat side agree about them.
constexpr std::array<glm::vec3, 3> octant_axes = {
    {{0.7712F, 0.5453F, 0.3287F}, {-0.6017F, 0.7871F, 0.1359F}, {-0.2082F, -0.3026F, 0.9301F}}};

constexpr double cells_per_area = 2.2;  // that a surface meets, by direction too, per square of a cell's side

double area_of(const MeshItem& item) {
  double twice = 0;
  for (std::size_t i = 0; i + 2 < item.triangles.size(); i += 3) {
    const glm::dvec3 a(item.vertices[item.triangles[i]].position);
    const glm::dvec3 b(item.vertices[item.triangles[i + 1]].position);
    const glm::dvec3 c(item.vertices[item.triangles[i + 2]].position);
    twice += glm::length(glm::cross(b - a, c - a));
  }
  return twice / 2;
}

/// The mean normal at each place, to distinguish the sides of thin parts.
std::vector<glm::vec3> normals_of_places(const MeshItem& item, std::span<const Index> places) {
  std::vector<glm::vec3> normals(item.vertices.size(), glm::vec3(0));
  for (std::size_t v = 0; v < places.size(); ++v) normals[places[v]] += item.vertices[v].normal;
  return normals;
}

std::uint64_t cell_key(const glm::vec3& position, const glm::vec3& normal, double cell) {
  std::uint64_t key = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto step = static_cast<std::uint64_t>(std::max(0.0, std::floor((position[axis] + 1.001) / cell)));
    key = key << 20 | std::min<std::uint64_t>(step, (1U << 20) - 1);
  }
  for (const glm::vec3& side : octant_axes) key = key << 1 | (glm::dot(normal, side) < 0 ? 1U : 0U);
  return key;
}

struct Clusters {
  std::vector<Index> of;  ///< #V
  std::size_t count = 0;
};

/// Numbered in the order of their cells.
Clusters clusters_in(const MeshItem& item, std::span<const Index> places, std::span<const glm::vec3> normals,
                     double cell) {
  std::vector<std::pair<std::uint64_t, Index>> keys;
  for (Index v = 0; v < places.size(); ++v) {
    if (places[v] == v) keys.emplace_back(cell_key(item.vertices[v].position, normals[v], cell), v);
  }
  std::sort(keys.begin(), keys.end());
  Clusters clusters;
  clusters.of.resize(places.size());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (i > 0 && keys[i].first != keys[i - 1].first) ++clusters.count;
    clusters.of[keys[i].second] = static_cast<Index>(clusters.count);
  }
  if (!keys.empty()) ++clusters.count;
  for (std::size_t v = 0; v < places.size(); ++v) clusters.of[v] = clusters.of[places[v]];
  return clusters;
}

std::size_t count_left(const MeshItem& item, const Clusters& clusters) {
  std::size_t left = 0;
  for (std::size_t i = 0; i + 2 < item.triangles.size(); i += 3) {
    const Index a = clusters.of[item.triangles[i]];
    const Index b = clusters.of[item.triangles[i + 1]];
    const Index c = clusters.of[item.triangles[i + 2]];
    left += a != b && b != c && c != a ? 1 : 0;
  }
  return left;
}

Clusters fitting_clusters(const MeshItem& item, std::span<const Index> places) {
  const std::vector<glm::vec3> normals = normals_of_places(item, places);
  // A grid of 2^20 cells along an axis is the finest; two cells are enough for anything.
  double cell = std::clamp(std::sqrt(2 * cells_per_area * area_of(item) / wanted_triangles), 2.5e-6, 1.0);
  Clusters clusters = clusters_in(item, places, normals, cell);
  for (int round = 1; round < most_tries; ++round) {
    const auto left = static_cast<double>(count_left(item, clusters));
    if (left <= sure_triangles) break;
    cell = std::min(1.0, cell * std::sqrt(1.15 * left / wanted_triangles));
    clusters = clusters_in(item, places, normals, cell);
  }
  return clusters;
}

/// How many of the item's vertices are at each place: more than one on creases.
std::vector<std::uint8_t> counts_of_places(std::span<const Index> places) {
  std::vector<std::uint8_t> counts(places.size(), 0);
  for (const Index place : places) counts[place] = static_cast<std::uint8_t>(std::min(counts[place] + 1, 255));
  return counts;
}

/// Of each cluster the place that stands for it.
std::vector<Index> chosen_places(const MeshItem& item, std::span<const Index> places, std::span<const Index> clusters,
                                 std::size_t cluster_count) {
  const std::vector<std::uint8_t> counts = counts_of_places(places);
  std::vector<glm::vec4> sums(cluster_count, glm::vec4(0));
  for (Index v = 0; v < places.size(); ++v) {
    if (places[v] == v) sums[clusters[v]] += glm::vec4(item.vertices[v].position, 1);
  }
  std::vector<Index> chosen(cluster_count, no_index);
  std::vector<float> distances(cluster_count);
  for (Index v = 0; v < places.size(); ++v) {
    if (places[v] != v) continue;
    const Index cluster = clusters[v];
    const float away = glm::distance(item.vertices[v].position, glm::vec3(sums[cluster]) / sums[cluster].w);
    const Index best = chosen[cluster];
    if (best != no_index && (counts[best] > counts[v] || (counts[best] == counts[v] && distances[cluster] <= away)))
      continue;
    chosen[cluster] = v;
    distances[cluster] = away;
  }
  return chosen;
}

/// Each triple or pair of clusters once, in the order in which they come.
template <std::size_t count>
std::vector<std::uint32_t> without_repeats(std::span<const std::uint32_t> indices, std::span<const Index> clusters) {
  struct Entry {
    std::array<Index, count> key;
    std::uint32_t at;
  };
  std::vector<Entry> entries;
  entries.reserve(indices.size() / count);
  for (std::uint32_t i = 0; i + count <= indices.size(); i += count) {
    Entry entry{{}, i};
    for (std::size_t k = 0; k < count; ++k) entry.key[k] = clusters[indices[i + k]];
    std::sort(entry.key.begin(), entry.key.end());
    if (std::adjacent_find(entry.key.begin(), entry.key.end()) == entry.key.end()) entries.push_back(entry);
  }
  std::sort(entries.begin(), entries.end(),
            [](const Entry& a, const Entry& b) { return std::tie(a.key, a.at) < std::tie(b.key, b.at); });
  const auto last =
      std::unique(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.key == b.key; });
  entries.erase(last, entries.end());
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.at < b.at; });
  std::vector<std::uint32_t> left;
  left.reserve(count * entries.size());
  for (const Entry& entry : entries) {
    left.insert(left.end(), indices.begin() + entry.at, indices.begin() + entry.at + count);
  }
  return left;
}

}  // namespace

ReducedSurface::ReducedSurface(const MeshItem& item, std::span<const Index> places) {
  const Clusters clusters = fitting_clusters(item, places);
  choose_vertices(item, clusters.of, clusters.count, places);
  const auto mapped = [&](const SharedArray<std::uint32_t>& indices) {
    std::vector<std::uint32_t> result;
    result.reserve(indices.size());
    for (const std::uint32_t vertex : indices) result.push_back(vertex_of_[vertex]);
    return result;
  };
  triangles_ = without_repeats<3>(mapped(item.triangles), cluster_of_);
  edges_ = without_repeats<2>(mapped(item.edges), cluster_of_);
}

void ReducedSurface::choose_vertices(const MeshItem& item, std::span<const Index> clusters, std::size_t cluster_count,
                                     std::span<const Index> places) {
  const std::vector<Index> chosen = chosen_places(item, places, clusters, cluster_count);
  // One vertex for every patch in a cluster, at the cluster's place, with the look of the patch's vertex next to it.
  struct Entry {
    Index cluster;
    std::uint32_t patch;
    float away;
    std::uint32_t vertex;
  };
  std::vector<Entry> entries;
  entries.reserve(item.vertices.size());
  for (std::uint32_t v = 0; v < item.vertices.size(); ++v) {
    const glm::vec3& place = item.vertices[chosen[clusters[v]]].position;
    entries.push_back({clusters[v], item.paint[v].patch, glm::distance(item.vertices[v].position, place), v});
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.cluster, a.patch, a.away, a.vertex) < std::tie(b.cluster, b.patch, b.away, b.vertex);
  });
  vertex_of_.resize(item.vertices.size());
  std::vector<SurfacePaint> paint;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Entry& entry = entries[i];
    const bool goes_on = i > 0 && entries[i - 1].cluster == entry.cluster && entries[i - 1].patch == entry.patch;
    if (!goes_on) {
      sources_.push_back({static_cast<std::uint32_t>(chosen[entry.cluster]), entry.vertex});
      cluster_of_.push_back(entry.cluster);
      paint.push_back(item.paint[entry.vertex]);
    }
    vertex_of_[entry.vertex] = static_cast<std::uint32_t>(sources_.size() - 1);
  }
  paint_ = std::move(paint);
}

std::shared_ptr<const MeshItem> ReducedSurface::of(const MeshItem& item) const {
  auto reduced = std::make_shared<MeshItem>();
  reduced->origin = item.origin;
  reduced->scale = item.scale;
  reduced->bounds = item.bounds;
  reduced->vertices.reserve(sources_.size());
  for (const Source& source : sources_) {
    reduced->vertices.push_back({item.vertices[source.place].position, item.vertices[source.look].normal});
  }
  reduced->paint = paint_;
  reduced->triangles = triangles_;
  reduced->edges = edges_;
  reduced->line_vertices = item.line_vertices;
  reduced->segments = item.segments;
  reduced->patch_count = item.patch_count;
  reduced->edge_length = item.edge_length;
  return reduced;
}

std::vector<std::uint32_t> ReducedSurface::reduced(std::span<const std::uint32_t> triangles) const {
  std::vector<std::uint32_t> mapped;
  mapped.reserve(triangles.size());
  for (const std::uint32_t vertex : triangles) mapped.push_back(vertex_of_[vertex]);
  return without_repeats<3>(mapped, cluster_of_);
}

}  // namespace croquis::render
