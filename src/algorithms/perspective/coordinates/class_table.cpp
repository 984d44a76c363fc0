// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/perspective/coordinates/class_table.h"

#include <algorithm>

#include "croquis/geometry/disjoint_sets.h"

namespace croquis {
namespace {

void tie_stroke(StrokeGroup group, const std::array<Index, 2>& ends, DisjointSets& slots) {
  const int axis = axis_of(group);
  for (int k = 0; k < 3; ++k) {
    if ((k == axis) == is_parallel(group)) continue;
    slots.unite(3 * ends[0] + static_cast<Index>(k), 3 * ends[1] + static_cast<Index>(k));
  }
}

void set_components(ClassTable& table) {
  DisjointSets sets(table.vertex_count());
  std::vector<Index> first(table.class_count(), no_index);
  for (Index v = 0; v < table.vertex_count(); ++v) {
    for (const Index c : table.of_vertex[v]) {
      if (first[c] == no_index) first[c] = v;
      sets.unite(first[c], v);
    }
  }
  table.components = sets.number(table.component);
}

}  // namespace

ClassTable make_classes(std::size_t vertex_count, const CoordinateTies& ties) {
  DisjointSets slots(3 * vertex_count);
  for (std::size_t s = 0; s < ties.of_stroke.size(); ++s) {
    const std::array<Index, 2>& ends = ties.of_stroke[s];
    if (ties.groups[s] == StrokeGroup::Unknown || ends[0] == no_index || ends[1] == no_index) continue;
    tie_stroke(ties.groups[s], ends, slots);
  }
  for (const auto& [one, other] : ties.equal) slots.unite(one, other);
  std::vector<Index> numbers;
  const Index count = slots.number(numbers);
  ClassTable table;
  table.axis.resize(count);
  table.of_vertex.resize(vertex_count);
  for (std::size_t v = 0; v < vertex_count; ++v) {
    for (int k = 0; k < 3; ++k) {
      const Index number = numbers[3 * v + static_cast<std::size_t>(k)];
      table.of_vertex[v][static_cast<std::size_t>(k)] = number;
      table.axis[number] = k;
    }
  }
  set_components(table);
  return table;
}

bool has_coincident_vertices(const ClassTable& table) {
  std::vector<std::array<Index, 3>> sorted = table.of_vertex;
  std::sort(sorted.begin(), sorted.end());
  return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
}

}  // namespace croquis
