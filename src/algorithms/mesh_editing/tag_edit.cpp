// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/mesh_editing/tag_edit.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "algorithms/mesh_editing/mesh_rebuild.h"
#include "croquis/base/error.h"

namespace croquis {
namespace {

VertexPair lower_first(const VertexPair& pair) { return ordered_pair(pair[0], pair[1]); }

[[noreturn]] void refuse_tags(const std::string& sentence) {
  throw Error(make_error(Category::Usage, "E_INPUT", sentence));
}

/// A sorted list of edges by their vertices.
std::vector<VertexPair> pairs_of(const MeshTopology& topology, std::span<const Index> edges) {
  std::vector<VertexPair> pairs;
  for (const Index edge : edges) {
    if (edge < topology.edge_count()) pairs.push_back(lower_first(topology.edge_vertices(edge)));
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

bool holds(const auto& sorted, const auto& value) { return std::binary_search(sorted.begin(), sorted.end(), value); }

void drop_empty_sets(MeshTags& tags) {
  std::erase_if(tags.sets, [](const CreaseSet& set) { return set.edges.empty() && set.pins.empty(); });
}

void leave_sets(MeshTags& tags, const std::vector<VertexPair>& edges, const Elements& vertices) {
  for (CreaseSet& set : tags.sets) {
    std::erase_if(set.edges, [&](const VertexPair& edge) { return holds(edges, lower_first(edge)); });
    std::erase_if(set.pins, [&](Index vertex) { return holds(vertices, vertex); });
  }
  drop_empty_sets(tags);
}

/// Gives each edge what `change` makes of its sharpness (0 for none).
/// @param edges sorted, lower vertex first
MeshTags changed(MeshTags tags, const std::vector<VertexPair>& edges, const std::function<double(double)>& change) {
  std::vector<char> seen(edges.size(), 0);
  std::vector<VertexPair> untagged;
  for (Crease& crease : tags.creases) {
    const auto found = std::lower_bound(edges.begin(), edges.end(), lower_first(crease.vertices));
    if (found == edges.end() || *found != lower_first(crease.vertices)) continue;
    seen[static_cast<std::size_t>(found - edges.begin())] = 1;
    crease.sharpness = normal_sharpness(change(crease.sharpness));
    if (crease.sharpness == 0) untagged.push_back(*found);
  }
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const double sharpness = seen[i] != 0 ? 0 : normal_sharpness(change(0));
    if (sharpness > 0) tags.creases.push_back({edges[i], sharpness});
  }
  if (untagged.empty()) return tags;
  std::erase_if(tags.creases, [](const Crease& crease) { return crease.sharpness == 0; });
  std::sort(untagged.begin(), untagged.end());
  leave_sets(tags, untagged, {});
  return tags;
}

void add_pins(MeshTags& tags, const Elements& vertices) {
  const Elements before = sorted_unique(tags.pins);
  for (const Index vertex : vertices) {
    if (!holds(before, vertex)) tags.pins.push_back(vertex);
  }
}

/// The set's place in the list.
std::size_t place_of(const MeshTags& tags, std::string_view name) {
  for (std::size_t i = 0; i < tags.sets.size(); ++i) {
    if (tags.sets[i].name == name) return i;
  }
  refuse_tags("There is no set \"" + std::string(name) + "\"");
}

void require_free_name(const MeshTags& tags, const std::string& name) {
  if (name.empty()) refuse_tags("A set needs a name");
  if (find_set(tags, name) != nullptr) refuse_tags("There is a set \"" + name + "\" already: choose another name");
}

std::vector<VertexPair> sorted_members(const CreaseSet& set) {
  std::vector<VertexPair> members = set.edges;
  for (VertexPair& pair : members) pair = lower_first(pair);
  std::sort(members.begin(), members.end());
  return members;
}

}  // namespace

Elements tagged_edges(const MeshTags& tags, const MeshTopology& topology) {
  std::vector<VertexPair> pairs;
  for (const Crease& crease : tags.creases) pairs.push_back(crease.vertices);
  return edges_of(topology, pairs);
}

MeshTags with_sharpness(const MeshTags& tags, const MeshTopology& topology, std::span<const Index> edges,
                        double sharpness) {
  return changed(tags, pairs_of(topology, edges), [sharpness](double) { return sharpness; });
}

MeshTags with_sharpness_changed(const MeshTags& tags, const MeshTopology& topology, std::span<const Index> edges,
                                double by) {
  return changed(tags, pairs_of(topology, edges), [by](double before) {
    if (by == 0) return before;
    return std::min(before, greatest_sharpness) + by;
  });
}

MeshTags with_pins(const MeshTags& tags, std::span<const Index> vertices, bool pinned) {
  MeshTags result = tags;
  const Elements chosen = sorted_unique(Elements(vertices.begin(), vertices.end()));
  if (pinned) {
    add_pins(result, chosen);
  } else {
    std::erase_if(result.pins, [&](Index vertex) { return holds(chosen, vertex); });
    leave_sets(result, {}, chosen);
  }
  return result;
}

// ---- Sets

const CreaseSet* find_set(const MeshTags& tags, std::string_view name) {
  for (const CreaseSet& set : tags.sets) {
    if (set.name == name) return &set;
  }
  return nullptr;
}

std::string new_set_name(const MeshTags& tags) {
  for (std::size_t number = 1;; ++number) {
    std::string name = "crease set " + std::to_string(number);
    if (find_set(tags, name) == nullptr) return name;
  }
}

MeshTags with_set(const MeshTags& tags, const MeshTopology& topology, const std::string& name,
                  std::span<const Index> edges, std::span<const Index> vertices, double sharpness) {
  require_free_name(tags, name);
  CreaseSet set{name, normal_sharpness(sharpness), pairs_of(topology, edges),
                sorted_unique(Elements(vertices.begin(), vertices.end()))};
  std::erase_if(set.pins, [&](Index vertex) { return vertex >= topology.vertex_count(); });
  if (set.sharpness == 0) refuse_tags("A set needs a sharpness above 0");
  if (set.edges.empty() && set.pins.empty()) refuse_tags("A set needs at least one edge or vertex: select some");
  MeshTags result = changed(tags, set.edges, [&](double) { return set.sharpness; });
  add_pins(result, set.pins);
  leave_sets(result, set.edges, set.pins);
  result.sets.push_back(std::move(set));
  return result;
}

MeshTags with_set_renamed(const MeshTags& tags, std::string_view name, const std::string& new_name) {
  MeshTags result = tags;
  const std::size_t place = place_of(tags, name);
  if (tags.sets[place].name == new_name) return result;
  require_free_name(tags, new_name);
  result.sets[place].name = new_name;
  return result;
}

MeshTags with_set_sharpness(const MeshTags& tags, std::string_view name, double sharpness) {
  MeshTags result = tags;
  CreaseSet& set = result.sets[place_of(tags, name)];
  const double normal = normal_sharpness(sharpness);
  if (normal > 0) set.sharpness = normal;
  const std::vector<VertexPair> members = sorted_members(set);
  return changed(std::move(result), members, [normal](double) { return normal; });
}

MeshTags with_sets_merged(const MeshTags& tags, std::string_view into, std::string_view from) {
  const std::size_t target = place_of(tags, into);
  const std::size_t source = place_of(tags, from);
  if (target == source) refuse_tags("A set can't be merged with itself: choose two sets");
  MeshTags result = tags;
  CreaseSet& set = result.sets[target];
  const CreaseSet& other = tags.sets[source];
  set.edges.insert(set.edges.end(), other.edges.begin(), other.edges.end());
  set.pins.insert(set.pins.end(), other.pins.begin(), other.pins.end());
  const double sharpness = set.sharpness;
  result.sets.erase(result.sets.begin() + static_cast<std::ptrdiff_t>(source));
  return changed(std::move(result), sorted_members(other), [sharpness](double) { return sharpness; });
}

MeshTags without_set(const MeshTags& tags, std::string_view name, bool untag) {
  const std::size_t place = place_of(tags, name);
  const CreaseSet set = tags.sets[place];
  MeshTags result = tags;
  result.sets.erase(result.sets.begin() + static_cast<std::ptrdiff_t>(place));
  if (!untag) return result;
  result = changed(std::move(result), sorted_members(set), [](double) { return 0.0; });
  return with_pins(result, set.pins, false);
}

Elements set_edges(const CreaseSet& set, const MeshTopology& topology) { return edges_of(topology, set.edges); }

Elements set_vertices(const CreaseSet& set, const MeshTopology& topology) {
  Elements vertices = sorted_unique(set.pins);
  std::erase_if(vertices, [&](Index vertex) { return vertex >= topology.vertex_count(); });
  return vertices;
}

}  // namespace croquis
