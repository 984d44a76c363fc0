// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

#include "algorithms/hole_filling/analysis/analysis_steps.h"
#include "algorithms/hole_filling/analysis/box_search.h"
#include "algorithms/hole_filling/analysis/sorted_lists.h"
#include "algorithms/hole_filling/triangulation/cancel_check.h"

namespace croquis::hole_filling {
namespace {

/// The same for equal positions, and as good as random else.
std::uint64_t hash_of(const Vec3& position) {
  constexpr std::array<std::uint64_t, 3> odd = {0x9e3779b97f4a7c15U, 0xbf58476d1ce4e5b9U, 0x94d049bb133111ebU};
  std::uint64_t hash = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    // Adding zero makes both zeros one.
    const auto bits = std::bit_cast<std::uint64_t>(position[static_cast<Eigen::Index>(axis)] + 0.0);
    hash = std::rotl(hash, 21) + (bits ^ bits >> 32) * odd[axis];
  }
  return (hash ^ hash >> 29) * odd[0] >> 32;
}

std::vector<std::uint8_t> used_vertices(const PolyMesh& mesh) {
  std::vector<std::uint8_t> used(mesh.vertex_count(), 0);
  for (const Index vertex : mesh.corners) used[vertex] = 1;
  return used;
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
  sort_unique(rims.vertices);
  rims.reach.assign(rims.vertices.size(), std::numeric_limits<double>::infinity());
  for (const Index corner : view.rim_corners) {
    const double half = (mesh.positions[view.origin(corner)] - mesh.positions[view.target(corner)]).norm() / 2;
    for (const Index end : {view.origin(corner), view.target(corner)}) {
      double& reach = rims.reach[place_in(rims.vertices, end)];
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
  const Vec3 around = Vec3::Constant(tolerance);
  const BoxSearch search(rims.vertices.size(), [&](Index number) { return Box(rims.place(number)); });
  std::vector<NearPair> pairs;
  for (Index low = 0; low < rims.vertices.size(); ++low) {
    search.visit(Box(rims.place(low) - around, rims.place(low) + around), [&](Index high) {
      cancel.step();
      const double distance = (rims.place(low) - rims.place(high)).norm();
      if (low < high && distance <= tolerance && distance < std::min(rims.reach[low], rims.reach[high]))
        pairs.push_back({distance, low, high});
    });
  }
  std::ranges::sort(pairs, {}, [](const NearPair& pair) { return std::tuple(pair.distance, pair.low, pair.high); });
  return pairs;
}

/// The rest of an edge's key when its low end is known: high end, then corner.
using Entry = std::pair<Index, Index>;

/// Links the corners of one edge.
void pair_run(std::span<const Entry> run, EdgePairing& result) {
  const Index first = run[0].second;
  if (run.size() == 1) {
    result.opposite[first] = no_index;
  } else if (run.size() == 2) {
    result.opposite[first] = run[1].second;
    result.opposite[run[1].second] = first;
  } else {
    ++result.nonmanifold_edges;
    for (const auto& [high, corner] : run) {
      result.opposite[corner] = nonmanifold_edge;
      if (corner != first) result.nonmanifold_corners.push_back({first, corner});
    }
  }
}

}  // namespace

/// Groups of vertices that count as one are lists from their lowest on. All of a group are nearer to that one than the
/// reach of any: so two ends of an edge never are in one group.
Welding weld_rims(const PolyMesh& mesh, const SurfaceView& view, double tolerance, Progress& progress) {
  Welding result;
  if (!(tolerance > 0) || view.rim_corners.empty()) return result;
  CancelCheck cancel(progress);
  const RimVertices rims = rim_vertices(mesh, view);
  std::vector<double> reach = rims.reach;  // of a group, at its lowest
  std::vector<Index> lowest(reach.size()), next(reach.size(), no_index);
  std::iota(lowest.begin(), lowest.end(), Index{0});
  std::vector<Index> last = lowest;
  // The greatest distance of a group to a place.
  const auto radius = [&](Index group, Index from) {
    double greatest = 0;
    for (Index member = group; member != no_index; member = next[member])
      greatest = std::max(greatest, (rims.place(member) - rims.place(from)).norm());
    return greatest;
  };
  for (const NearPair& pair : near_pairs(rims, tolerance, cancel)) {
    const auto [low, high] = std::minmax({lowest[pair.low], lowest[pair.high]});
    const double least = std::min(reach[low], reach[high]);
    if (low == high || radius(low, low) >= least || radius(high, low) >= least) continue;
    for (Index member = high; member != no_index; member = next[member]) lowest[member] = low;
    next[last[low]] = high;
    last[low] = last[high];
    reach[low] = least;
    ++result.welded;
    result.widest_gap = std::max(result.widest_gap, pair.distance);
  }
  if (result.welded == 0) return result;
  std::vector<Index> becomes(mesh.vertex_count());
  std::iota(becomes.begin(), becomes.end(), Index{0});
  for (Index number = 0; number < rims.vertices.size(); ++number)
    becomes[rims.vertices[number]] = rims.vertices[lowest[number]];
  result.representative.resize(mesh.vertex_count());
  for (Index vertex = 0; vertex < mesh.vertex_count(); ++vertex)
    result.representative[vertex] = becomes[view.representative_of(vertex)];
  return result;
}

Welding weld_identical(const PolyMesh& mesh, Progress& progress) {
  CancelCheck cancel(progress);
  const std::vector<std::uint8_t> used = used_vertices(mesh);
  const std::size_t places = std::bit_ceil(2 * mesh.vertex_count() + 2);
  std::vector<Index> table(places, no_index);
  Welding result;
  for (Index vertex = 0; vertex < used.size(); ++vertex) {
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

/// Until they are paired `opposite` links the corners whose edges have the same low end, the last one first: no memory
/// but the result's is touched, and where neighbours have near numbers that stays in the caches.
EdgePairing pair_edges(std::span<const std::array<Index, 3>> triangles, std::size_t vertex_count, Progress& progress) {
  CancelCheck cancel(progress);
  const auto origin = [&](Index corner) { return triangles[corner / 3][corner % 3]; };
  const auto target = [&](Index corner) { return origin(SurfaceView::next(corner)); };
  EdgePairing result;
  result.opposite.resize(3 * triangles.size());
  std::vector<Index> last(vertex_count, no_index);
  for (Index corner = 0; corner < result.opposite.size(); ++corner) {
    cancel.step();
    const Index low = std::min(origin(corner), target(corner));
    result.opposite[corner] = std::exchange(last[low], corner);
  }
  std::vector<Entry> entries;
  for (Index low = 0; low < last.size(); ++low) {
    cancel.step();
    entries.clear();
    for (Index corner = last[low]; corner != no_index; corner = result.opposite[corner])
      entries.emplace_back(std::max(origin(corner), target(corner)), corner);
    std::ranges::sort(entries);
    for (std::size_t i = 0; i < entries.size();) {
      std::size_t end = i + 1;
      while (end < entries.size() && entries[end].first == entries[i].first) ++end;
      pair_run(std::span(entries).subspan(i, end - i), result);
      i = end;
    }
  }
  return result;
}

}  // namespace croquis::hole_filling
