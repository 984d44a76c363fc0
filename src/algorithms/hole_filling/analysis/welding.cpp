// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/analysis/welding.h"

#include <bit>
#include <cstdint>
#include <numeric>

#include "algorithms/hole_filling/triangulation/cancel_check.h"

namespace croquis::hole_filling {
namespace {

/// One round of splitmix64's finaliser, so that neighbouring coordinates spread.
std::uint64_t mixed(std::uint64_t bits) {
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9U;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebU;
  return bits ^ (bits >> 31);
}

std::uint64_t hash_of(const Vec3& position) {
  std::uint64_t hash = 0x9e3779b97f4a7c15U;
  for (const double coordinate : position) hash = mixed(hash ^ std::bit_cast<std::uint64_t>(coordinate + 0.0));
  return hash;
}

std::vector<std::uint8_t> used_vertices(const PolyMesh& mesh) {
  std::vector<std::uint8_t> used(mesh.vertex_count(), 0);
  for (const Index vertex : mesh.corners) used[vertex] = 1;
  return used;
}

}  // namespace

Welding weld_identical(const PolyMesh& mesh, Progress& progress) {
  const std::vector<std::uint8_t> used = used_vertices(mesh);
  const std::size_t places = std::bit_ceil(2 * mesh.vertex_count() + 2);
  std::vector<Index> table(places, no_index);
  Welding result;
  CancelCheck cancel(progress);
  for (Index vertex = 0; vertex < mesh.vertex_count(); ++vertex) {
    cancel.step();
    if (used[vertex] == 0) continue;
    std::size_t place = hash_of(mesh.positions[vertex]) & (places - 1);
    while (table[place] != no_index && mesh.positions[table[place]] != mesh.positions[vertex])
      place = (place + 1) & (places - 1);
    if (table[place] == no_index) {
      table[place] = vertex;
      continue;
    }
    if (result.welded++ == 0) {
      result.representative.resize(mesh.vertex_count());
      std::iota(result.representative.begin(), result.representative.end(), Index{0});
    }
    result.representative[vertex] = table[place];
  }
  return result;
}

}  // namespace croquis::hole_filling
