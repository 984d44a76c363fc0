// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/analysis/welding.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

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

/// The vertices of rims; their places here are their numbers in what follows.
struct RimVertices {
  std::vector<Index> vertices;  ///< ascending
  std::vector<double> reach;    ///< half of the shortest rim edge at each
  const PolyMesh& mesh;

  const Vec3& place(Index number) const { return mesh.positions[vertices[number]]; }
};

RimVertices rim_vertices(const PolyMesh& mesh, const SurfaceView& view) {
  RimVertices rims{{}, {}, mesh};
  for (const Index corner : view.rim_corners)
    rims.vertices.insert(rims.vertices.end(), {view.origin(corner), view.target(corner)});
  std::ranges::sort(rims.vertices);
  rims.vertices.erase(std::unique(rims.vertices.begin(), rims.vertices.end()), rims.vertices.end());
  rims.reach.assign(rims.vertices.size(), std::numeric_limits<double>::infinity());
  for (const Index corner : view.rim_corners) {
    const double half = (mesh.positions[view.origin(corner)] - mesh.positions[view.target(corner)]).norm() / 2;
    for (const Index end : {view.origin(corner), view.target(corner)}) {
      double& reach =
          rims.reach[static_cast<std::size_t>(std::ranges::lower_bound(rims.vertices, end) - rims.vertices.begin())];
      reach = std::min(reach, half);
    }
  }
  return rims;
}

struct NearPair {
  double distance = 0;
  Index low = 0, high = 0;  ///< numbers among the rims' vertices
};

/// All that may become one, the nearest first.
std::vector<NearPair> near_pairs(const RimVertices& rims, double tolerance, CancelCheck& cancel) {
  std::vector<Index> along(rims.vertices.size());
  std::iota(along.begin(), along.end(), Index{0});
  std::ranges::sort(along, {}, [&](Index number) { return std::pair(rims.place(number).x(), number); });
  std::vector<NearPair> pairs;
  for (std::size_t i = 0; i < along.size(); ++i) {
    for (std::size_t j = i + 1; j < along.size(); ++j) {
      cancel.step();
      const Index a = along[i], b = along[j];
      if (rims.place(b).x() - rims.place(a).x() > tolerance) break;
      const double distance = (rims.place(a) - rims.place(b)).norm();
      if (distance <= tolerance && distance < std::min(rims.reach[a], rims.reach[b]))
        pairs.push_back({distance, std::min(a, b), std::max(a, b)});
    }
  }
  std::ranges::sort(pairs, {}, [](const NearPair& pair) { return std::tuple(pair.distance, pair.low, pair.high); });
  return pairs;
}

/// Vertices of rims that count as one, each group known by its lowest. All of a group are nearer to that one than the
/// reach of any: so two ends of an edge never are in one group.
class RimGroups {
 public:
  explicit RimGroups(const RimVertices& rims) : rims_(rims), reach_(rims.reach), lowest_(reach_.size()) {
    std::iota(lowest_.begin(), lowest_.end(), Index{0});
    last_ = lowest_;
    next_.assign(lowest_.size(), no_index);
  }

  Index lowest(Index number) const { return lowest_[number]; }

  /// @return whether two groups became one
  bool join(Index a, Index b) {
    const auto [low, high] = std::minmax({lowest_[a], lowest_[b]});
    const double reach = std::min(reach_[low], reach_[high]);
    if (low == high || radius(low, low) >= reach || radius(high, low) >= reach) return false;
    for (Index member = high; member != no_index; member = next_[member]) lowest_[member] = low;
    next_[last_[low]] = high;
    last_[low] = last_[high];
    reach_[low] = reach;
    return true;
  }

 private:
  /// The greatest distance of a group to a place.
  double radius(Index group, Index from) const {
    double greatest = 0;
    for (Index member = group; member != no_index; member = next_[member])
      greatest = std::max(greatest, (rims_.place(member) - rims_.place(from)).norm());
    return greatest;
  }

  const RimVertices& rims_;
  std::vector<double> reach_;                ///< of a group, at its lowest
  std::vector<Index> lowest_, last_, next_;  ///< a group is a list from its lowest on
};

}  // namespace

Welding weld_rims(const PolyMesh& mesh, const SurfaceView& view, double tolerance, Progress& progress) {
  Welding result;
  if (!(tolerance > 0) || view.rim_corners.empty()) return result;
  CancelCheck cancel(progress);
  const RimVertices rims = rim_vertices(mesh, view);
  RimGroups groups(rims);
  for (const auto& [distance, low, high] : near_pairs(rims, tolerance, cancel)) {
    if (!groups.join(low, high)) continue;
    ++result.welded;
    result.widest_gap = std::max(result.widest_gap, distance);
  }
  if (result.welded == 0) return result;
  std::vector<Index> becomes(mesh.vertex_count());
  std::iota(becomes.begin(), becomes.end(), Index{0});
  for (Index number = 0; number < rims.vertices.size(); ++number)
    becomes[rims.vertices[number]] = rims.vertices[groups.lowest(number)];
  result.representative.resize(mesh.vertex_count());
  for (Index vertex = 0; vertex < mesh.vertex_count(); ++vertex)
    result.representative[vertex] = becomes[view.representative_of(vertex)];
  return result;
}

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
