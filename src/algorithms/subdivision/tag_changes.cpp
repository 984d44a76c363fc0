// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/subdivision/tag_changes.h"

#include <algorithm>

namespace croquis::subdivision {
namespace {

std::array<Index, 2> sorted(std::array<Index, 2> vertices) {
  if (vertices[1] < vertices[0]) std::swap(vertices[0], vertices[1]);
  return vertices;
}

}  // namespace

Index edge_between(const MeshTopology& topology, Index a, Index b) {
  for (const Index corner : topology.vertex_corners(a)) {
    if (topology.vertex(topology.next(corner)) == b) return topology.edge(corner);
    const Index before = topology.previous(corner);
    if (topology.vertex(before) == b) return topology.edge(before);
  }
  return no_index;
}

std::vector<double> edge_sharpness(const MeshTags& tags, const MeshTopology& topology) {
  std::vector<double> sharpness(topology.edge_count(), 0);
  for (const Crease& crease : tags.creases) {
    if (std::max(crease.vertices[0], crease.vertices[1]) >= topology.vertex_count()) continue;
    const Index edge = edge_between(topology, crease.vertices[0], crease.vertices[1]);
    if (edge != no_index && crease.sharpness > 0) sharpness[edge] = crease.sharpness;
  }
  return sharpness;
}

TagChanges::TagChanges(MeshTags& tags) : tags_(tags) {
  for (std::size_t i = 0; i < tags_.creases.size(); ++i) crease_of_[sorted(tags_.creases[i].vertices)] = i;
}

void TagChanges::add_crease(std::array<Index, 2> vertices) {
  vertices = sorted(vertices);
  const auto [place, is_new] = crease_of_.try_emplace(vertices, tags_.creases.size());
  if (is_new) {
    tags_.creases.push_back({vertices, infinite_sharpness});
    return;
  }
  if (tags_.creases[place->second].sharpness == infinite_sharpness) return;
  tags_.creases[place->second].sharpness = infinite_sharpness;
  for (CreaseSet& set : tags_.sets) std::erase(set.edges, vertices);  // members share the set's sharpness
}

void TagChanges::add_pin(Index vertex) { tags_.pins.push_back(vertex); }

void TagChanges::finish() {
  std::sort(tags_.pins.begin(), tags_.pins.end());
  tags_.pins.erase(std::unique(tags_.pins.begin(), tags_.pins.end()), tags_.pins.end());
}

}  // namespace croquis::subdivision
