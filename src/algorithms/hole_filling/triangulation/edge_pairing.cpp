// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/triangulation/edge_pairing.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "algorithms/hole_filling/triangulation/cancel_check.h"
#include "croquis/hole_filling/surface_view.h"

namespace croquis::hole_filling {
namespace {

/// The rest of an edge's key when its low end is known: high end, then corner.
using Entry = std::uint64_t;

Index high_end(Entry entry) { return static_cast<Index>(entry >> 32); }
Index corner_of(Entry entry) { return static_cast<Index>(entry); }

/// Valences are about 6: insertion beats std::sort there.
constexpr std::ptrdiff_t insertion_limit = 24;

void sort_entries(std::span<Entry> entries) {
  if (std::ssize(entries) > insertion_limit) {
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

/// Entries of all edges behind one another, by their low ends.
struct Buckets {
  std::vector<std::uint32_t> ends;  ///< #V, one past each vertex' last entry
  std::vector<Entry> entries;       ///< #3T
};

Buckets bucket_by_low_end(std::span<const std::array<Index, 3>> triangles, std::size_t vertex_count,
                          Progress& progress) {
  Buckets buckets;
  // Shifted by one, so that placing the entries turns beginnings into ends.
  buckets.ends.assign(vertex_count + 1, 0);
  for (const auto& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) ++buckets.ends[std::min(t[i], t[i == 2 ? 0 : i + 1]) + std::size_t{1}];
  }
  std::partial_sum(buckets.ends.begin(), buckets.ends.end(), buckets.ends.begin());
  buckets.entries.resize(3 * triangles.size());
  CancelCheck cancel(progress);
  Index corner = 0;
  for (const auto& t : triangles) {
    cancel.step();
    for (std::size_t i = 0; i < 3; ++i, ++corner) {
      const auto [low, high] = std::minmax({t[i], t[i == 2 ? 0 : i + 1]});
      buckets.entries[buckets.ends[low]++] = (Entry{high} << 32) | corner;
    }
  }
  return buckets;
}

/// Links the corners of one edge.
void pair_run(std::span<const Entry> run, EdgePairing& pairing) {
  const Index first = corner_of(run.front());
  if (run.size() == 2) {
    pairing.opposite[first] = corner_of(run[1]);
    pairing.opposite[corner_of(run[1])] = first;
  } else if (run.size() > 2) {
    ++pairing.crowded_edges;
    for (const Entry entry : run) pairing.opposite[corner_of(entry)] = crowded_edge;
    for (const Entry entry : run.subspan(1)) pairing.crowded_corners.push_back({first, corner_of(entry)});
  }
}

}  // namespace

EdgePairing pair_edges(std::span<const std::array<Index, 3>> triangles, std::size_t vertex_count, Progress& progress) {
  Buckets buckets = bucket_by_low_end(triangles, vertex_count, progress);
  EdgePairing pairing;
  pairing.opposite.assign(3 * triangles.size(), no_index);
  CancelCheck cancel(progress);
  std::size_t begin = 0;
  for (std::size_t vertex = 0; vertex < vertex_count; ++vertex) {
    cancel.step();
    const std::span<Entry> bucket(buckets.entries.data() + begin, buckets.ends[vertex] - begin);
    begin = buckets.ends[vertex];
    sort_entries(bucket);
    for (std::size_t i = 0; i < bucket.size();) {
      std::size_t end = i + 1;
      while (end < bucket.size() && high_end(bucket[end]) == high_end(bucket[i])) ++end;
      pair_run(bucket.subspan(i, end - i), pairing);
      i = end;
    }
  }
  return pairing;
}

}  // namespace croquis::hole_filling
