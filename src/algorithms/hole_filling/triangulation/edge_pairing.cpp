// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/triangulation/edge_pairing.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>

#include "algorithms/hole_filling/triangulation/cancel_check.h"
#include "croquis/hole_filling/surface_view.h"

namespace croquis::hole_filling {
namespace {

/// The rest of an edge's key when its low end is known: high end, then corner.
using Entry = std::uint64_t;

Entry entry_of(Index high, Index corner) { return Entry{high} << 32 | corner; }
Index high_end(Entry entry) { return static_cast<Index>(entry >> 32); }
Index corner_of(Entry entry) { return static_cast<Index>(entry); }

/// Valences are about 6: insertion beats std::sort there.
constexpr std::size_t insertion_limit = 24;

void sort_entries(std::span<Entry> entries) {
  if (entries.size() > insertion_limit) {
    std::sort(entries.begin(), entries.end());
    return;
  }
  for (std::size_t i = 1; i < entries.size(); ++i) {
    const Entry entry = entries[i];
    std::size_t place = i;
    for (; place > 0 && entries[place - 1] > entry; --place) entries[place] = entries[place - 1];
    entries[place] = entry;
  }
}

/// Every so many triangles one is compared with the next.
constexpr std::size_t sample_distance = 64;

/// Vertices that far apart, as a share of all, aren't neighbours in memory.
constexpr std::size_t far_apart = 16;

/// Whether triangles behind one another mostly have vertices with numbers far apart, as in shuffled meshes.
bool are_scattered(std::span<const std::array<Index, 3>> triangles, std::size_t vertex_count) {
  std::size_t seen = 0, scattered = 0;
  for (std::size_t t = 1; t < triangles.size(); t += sample_distance, ++seen) {
    const auto [low, high] = std::minmax(triangles[t - 1][0], triangles[t][0]);
    if (high - low > vertex_count / far_apart) ++scattered;
  }
  return 2 * scattered > seen;
}

class Pairing {
 public:
  Pairing(std::span<const std::array<Index, 3>> triangles, std::size_t vertex_count, Progress& progress)
      : vertices_(reinterpret_cast<const Index*>(triangles.data()), 3 * triangles.size()),
        vertex_count_(vertex_count),
        cancel_(progress) {}

  /// Until they are paired `opposite` links the corners whose edges have the same low end, the last one first: no
  /// memory but the result's is touched, and where neighbours have near numbers that stays in the caches.
  EdgePairing by_lists() {
    std::vector<Index> last(vertex_count_, no_index);
    result_.opposite.resize(vertices_.size());
    visit_edges([&](Index corner, Index low, Index) {
      result_.opposite[corner] = last[low];
      last[low] = corner;
    });
    std::vector<Entry> entries;
    for (Index low = 0; low < last.size(); ++low) {
      cancel_.step();
      entries.clear();
      for (Index corner = last[low]; corner != no_index; corner = result_.opposite[corner]) {
        const Index from = vertices_[corner];
        entries.push_back(entry_of(from == low ? vertices_[SurfaceView::next(corner)] : from, corner));
      }
      pair_entries(entries);
    }
    return std::move(result_);
  }

  /// Counts on the low ends first and writes the entries behind one another: each corner costs one cache miss
  /// where lists would take several.
  EdgePairing by_buckets() {
    // Shifted by one, so that placing the entries turns beginnings into ends.
    std::vector<std::uint32_t> ends(vertex_count_ + 1, 0);
    visit_edges([&](Index, Index low, Index) { ++ends[low + std::size_t{1}]; });
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    std::vector<Entry> entries(vertices_.size());
    visit_edges([&](Index corner, Index low, Index high) { entries[ends[low]++] = entry_of(high, corner); });
    result_.opposite.resize(vertices_.size());
    for (std::size_t low = 0; low < vertex_count_; ++low) {
      cancel_.step();
      const std::size_t begin = low == 0 ? 0 : ends[low - 1];
      pair_entries({entries.data() + begin, ends[low] - begin});
    }
    return std::move(result_);
  }

 private:
  template <typename Visit>
  void visit_edges(Visit&& visit) {
    const auto visit_ordered = [&](Index corner, Index a, Index b) { visit(corner, std::min(a, b), std::max(a, b)); };
    for (Index corner = 0; corner < vertices_.size(); corner += 3) {
      cancel_.step();
      const Index a = vertices_[corner], b = vertices_[corner + 1], c = vertices_[corner + 2];
      visit_ordered(corner, a, b);
      visit_ordered(corner + 1, b, c);
      visit_ordered(corner + 2, c, a);
    }
  }

  /// @param entries of one low end
  void pair_entries(std::span<Entry> entries) {
    sort_entries(entries);
    for (std::size_t i = 0; i < entries.size();) {
      std::size_t end = i + 1;
      while (end < entries.size() && high_end(entries[end]) == high_end(entries[i])) ++end;
      pair_run(entries.subspan(i, end - i));
      i = end;
    }
  }

  /// Links the corners of one edge.
  void pair_run(std::span<const Entry> run) {
    const Index first = corner_of(run.front());
    if (run.size() == 1) {
      result_.opposite[first] = no_index;
    } else if (run.size() == 2) {
      const Index second = corner_of(run[1]);
      result_.opposite[first] = second;
      result_.opposite[second] = first;
    } else {
      ++result_.nonmanifold_edges;
      for (const Entry entry : run) result_.opposite[corner_of(entry)] = nonmanifold_edge;
      for (const Entry entry : run.subspan(1)) result_.nonmanifold_corners.push_back({first, corner_of(entry)});
    }
  }

  std::span<const Index> vertices_;  ///< #3T, where each corner's edge begins
  std::size_t vertex_count_;
  CancelCheck cancel_;
  EdgePairing result_;
};

}  // namespace

EdgePairing pair_edges(std::span<const std::array<Index, 3>> triangles, std::size_t vertex_count, Progress& progress) {
  Pairing pairing(triangles, vertex_count, progress);
  return are_scattered(triangles, vertex_count) ? pairing.by_buckets() : pairing.by_lists();
}

}  // namespace croquis::hole_filling
