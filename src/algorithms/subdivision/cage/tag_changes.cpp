// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/subdivision/cage/tag_changes.h"

#include <algorithm>

namespace croquis::subdivision {
namespace {

std::array<Index, 2> sorted(std::array<Index, 2> vertices) {
  if (vertices[1] < vertices[0]) std::swap(vertices[0], vertices[1]);
  return vertices;
}

}  // namespace

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
