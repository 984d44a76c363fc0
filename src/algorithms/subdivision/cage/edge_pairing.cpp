// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/subdivision/cage/edge_pairing.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace croquis::subdivision {
namespace {

/// Calls use(corner, low end, high end) for each corner of the faces that count.
template <typename Use>
void for_each_half_edge(const PolyMesh& mesh, const std::vector<bool>& left_out, Use&& use) {
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    if (left_out[face]) continue;
    const Index begin = mesh.face_offsets[face], end = mesh.face_offsets[face + 1];
    Index from = mesh.corners[end - 1];
    for (Index corner = end - 1, next = begin; next < end; corner = next++) {
      const Index to = mesh.corners[next];
      use(corner, std::min(from, to), std::max(from, to));
      from = to;
    }
  }
}

}  // namespace

EdgePairing::EdgePairing(const PolyMesh& mesh, const std::vector<bool>& left_out)
    : low_offsets_(mesh.vertex_count() + 1, 0) {
  for_each_half_edge(mesh, left_out, [&](Index, Index low, Index) { ++low_offsets_[low + std::size_t{1}]; });
  std::partial_sum(low_offsets_.begin(), low_offsets_.end(), low_offsets_.begin());

  std::vector<std::pair<Index, Index>> high_and_corner(low_offsets_.back());
  std::vector<Index> free_place(low_offsets_.begin(), low_offsets_.end() - 1);
  for_each_half_edge(mesh, left_out, [&](Index corner, Index low, Index high) {
    high_and_corner[free_place[low]++] = {high, corner};
  });

  entries_.resize(high_and_corner.size());
  corners_.resize(high_and_corner.size());
  for (Index low = 0; low < mesh.vertex_count(); ++low) {
    const Index begin = low_offsets_[low], end = low_offsets_[low + std::size_t{1}];
    std::sort(high_and_corner.begin() + begin, high_and_corner.begin() + end);
    for (Index i = begin; i < end; ++i) {
      entries_[i] = {low, high_and_corner[i].first};
      corners_[i] = high_and_corner[i].second;
    }
  }
}

std::span<const Index> EdgePairing::corners(Index a, Index b) const {
  const auto [low, high] = std::minmax(a, b);
  if (high + std::size_t{1} >= low_offsets_.size()) return {};
  const auto begin = entries_.begin() + low_offsets_[low];
  const auto end = entries_.begin() + low_offsets_[low + std::size_t{1}];
  const auto first = std::lower_bound(begin, end, high, [](const Entry& e, Index value) { return e.high < value; });
  const auto last = std::upper_bound(first, end, high, [](Index value, const Entry& e) { return value < e.high; });
  return std::span<const Index>(corners_).subspan(static_cast<std::size_t>(first - entries_.begin()),
                                                  static_cast<std::size_t>(last - first));
}

}  // namespace croquis::subdivision
