// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/analysis/welding.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <numeric>

#include "algorithms/hole_filling/triangulation/cancel_check.h"

namespace croquis::hole_filling {
namespace {

/// The same for equal positions, and as good as random else.
std::uint32_t hash_of(const Vec3& position) {
  constexpr std::array<std::uint64_t, 3> odd = {0x9e3779b97f4a7c15U, 0xbf58476d1ce4e5b9U, 0x94d049bb133111ebU};
  std::uint64_t hash = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    // Adding zero makes both zeros one.
    const auto bits = std::bit_cast<std::uint64_t>(position[static_cast<Eigen::Index>(axis)] + 0.0);
    hash = std::rotl(hash, 21) + (bits ^ bits >> 32) * odd[axis];
  }
  return static_cast<std::uint32_t>((hash ^ hash >> 29) * odd[0] >> 32);
}

std::vector<std::uint8_t> used_vertices(const PolyMesh& mesh) {
  std::vector<std::uint8_t> used(mesh.vertex_count(), 0);
  for (const Index vertex : mesh.corners) used[vertex] = 1;
  return used;
}

/// Whether each hash came, and came again, in two bits: a table that stays in the caches where one of indices
/// wouldn't.
class HashCounts {
 public:
  explicit HashCounts(std::size_t expected)
      : bits_(std::clamp(static_cast<int>(std::bit_width(places_per_hash * expected)), fewest_bits, 31)),
        words_((std::size_t{1} << bits_) / places_per_word, 0) {}

  void fetch(std::uint32_t hash) const { __builtin_prefetch(&words_[place(hash) / places_per_word]); }

  void add(std::uint32_t hash) {
    std::uint64_t& word = words_[place(hash) / places_per_word];
    const auto at = 2 * (place(hash) % places_per_word);
    word |= (word & std::uint64_t{1} << at) << 1 | std::uint64_t{1} << at;
  }

  bool came_again(std::uint32_t hash) const {
    return (words_[place(hash) / places_per_word] >> (2 * (place(hash) % places_per_word)) & 2) != 0;
  }

 private:
  static constexpr std::size_t places_per_word = 32;
  static constexpr std::size_t places_per_hash = 4;  ///< or up to twice as many
  static constexpr int fewest_bits = 5;

  std::size_t place(std::uint32_t hash) const { return hash >> (32 - bits_); }

  int bits_;
  std::vector<std::uint64_t> words_;
};

/// Vertices by ascending numbers that may be at the place of another one: all that are, and few others.
struct Candidates {
  std::vector<Index> vertices;
  std::vector<std::uint32_t> hashes;
};

Candidates find_candidates(const PolyMesh& mesh, CancelCheck& cancel) {
  constexpr std::size_t block = 64;  // so many hashes at a time have their places fetched
  const std::vector<std::uint8_t> used = used_vertices(mesh);
  std::vector<std::uint32_t> hashes(mesh.vertex_count());
  HashCounts counts(mesh.vertex_count());
  for (std::size_t begin = 0; begin < hashes.size(); begin += block) {
    const std::size_t end = std::min(begin + block, hashes.size());
    for (std::size_t v = begin; v < end; ++v) counts.fetch(hashes[v] = hash_of(mesh.positions[v]));
    for (std::size_t v = begin; v < end; ++v) {
      cancel.step();
      if (used[v] != 0) counts.add(hashes[v]);
    }
  }
  Candidates found;
  for (std::size_t begin = 0; begin < hashes.size(); begin += block) {
    const std::size_t end = std::min(begin + block, hashes.size());
    for (std::size_t v = begin; v < end; ++v) counts.fetch(hashes[v]);
    for (std::size_t v = begin; v < end; ++v) {
      if (used[v] == 0 || !counts.came_again(hashes[v])) continue;
      found.vertices.push_back(static_cast<Index>(v));
      found.hashes.push_back(hashes[v]);
    }
  }
  return found;
}

}  // namespace

Welding weld_identical(const PolyMesh& mesh, Progress& progress) {
  CancelCheck cancel(progress);
  const Candidates candidates = find_candidates(mesh, cancel);
  const std::size_t places = std::bit_ceil(2 * candidates.vertices.size() + 2);
  std::vector<Index> table(places, no_index);
  Welding result;
  for (std::size_t i = 0; i < candidates.vertices.size(); ++i) {
    cancel.step();
    const Index vertex = candidates.vertices[i];
    std::size_t place = candidates.hashes[i] & (places - 1);
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
