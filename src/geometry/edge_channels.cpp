// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/geometry/edge_channels.h"

#include <algorithm>
#include <array>
#include <limits>
#include <type_traits>
#include <utility>
#include <variant>

namespace croquis {
namespace {

/// Per edge of the new mesh the old one between the same vertices, or no_index.
std::vector<Index> edge_sources(const MeshTopology& before, std::span<const Index> vertex_source,
                                const MeshTopology& after) {
  const auto source = [&](Index vertex) { return vertex_source.empty() ? vertex : vertex_source[vertex]; };
  std::vector<Index> sources(after.edge_count(), no_index);
  for (Index edge = 0; edge < sources.size(); ++edge) {
    const auto [a, b] = after.edge_vertices(edge);
    sources[edge] = find_edge(before, source(a), source(b));
  }
  return sources;
}

}  // namespace

Index find_edge(const MeshTopology& topology, Index a, Index b) {
  if (a >= topology.vertex_count() || b >= topology.vertex_count()) return no_index;
  for (const Index corner : topology.vertex_corners(a)) {
    const Index before = topology.previous(corner);
    if (topology.vertex(topology.next(corner)) == b && topology.edge(corner) != no_index) return topology.edge(corner);
    if (topology.vertex(before) == b && topology.edge(before) != no_index) return topology.edge(before);
  }
  return no_index;
}

double normal_sharpness(double sharpness) {
  if (!(sharpness > 0)) return 0;
  return sharpness >= greatest_sharpness ? infinite_sharpness : sharpness;
}

std::vector<double> edge_sharpness(const MeshTags& tags, const MeshTopology& topology) {
  std::vector<double> sharpness(topology.edge_count(), 0);
  for (const Crease& crease : tags.creases) {
    const Index edge = find_edge(topology, crease.vertices[0], crease.vertices[1]);
    if (edge != no_index) sharpness[edge] = std::max(sharpness[edge], normal_sharpness(crease.sharpness));
  }
  return sharpness;
}

AttributeChannel gathered(const AttributeChannel& channel, std::span<const Index> sources) {
  AttributeChannel result{channel.name, channel.domain, channel.width, {}, channel.labels};
  const auto width = static_cast<std::size_t>(channel.width);
  std::visit(
      [&](const auto& values) {
        using T = typename std::decay_t<decltype(values)>::value_type;
        std::vector<T> some;
        some.reserve(sources.size() * width);
        for (const Index source : sources) {
          for (std::size_t i = 0; i < width; ++i) {
            // Whole numbers have no NaN: quiet_NaN() of them is 0.
            some.push_back(source == no_index ? std::numeric_limits<T>::quiet_NaN() : values[source * width + i]);
          }
        }
        result.data = std::move(some);
      },
      channel.data);
  return result;
}

void renumber_edge_channels(const PolyMesh& before, std::span<const Index> vertex_source, PolyMesh& after) {
  if (!after.has_edge_channels()) return;
  const MeshTopology old_edges(before);
  const std::vector<Index> sources = edge_sources(old_edges, vertex_source, MeshTopology(after));
  for (AttributeChannel& channel : after.channels) {
    if (channel.domain != Domain::Edge || channel.width < 1) continue;
    if (channel.size() != old_edges.edge_count() * static_cast<std::size_t>(channel.width)) continue;
    channel = gathered(channel, sources);
  }
}

}  // namespace croquis
