// SPDX-License-Identifier: GPL-3.0-or-later
#include "implicit/thinning.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace croquis::implicit {
namespace {

constexpr double growth = 1.15;  // of the cells, per attempt

struct Candidate {
  std::array<std::int32_t, 3> cell;
  double distance;  // squared, to the middle of the box
  Index index;

  auto operator<=>(const Candidate&) const = default;
};

std::vector<Index> one_per_cell(std::span<const Vec3> positions, const std::vector<Index>& candidates, const Box& box,
                                double cell) {
  std::vector<Candidate> sorted;
  sorted.reserve(candidates.size());
  for (const Index i : candidates) {
    const Vec3 place = (positions[i] - box.low) / cell;
    Candidate candidate = {{}, (positions[i] - box.middle()).squaredNorm(), i};
    for (int axis = 0; axis < 3; ++axis)
      candidate.cell[static_cast<std::size_t>(axis)] = static_cast<std::int32_t>(std::floor(place[axis]));
    sorted.push_back(candidate);
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<Index> kept;
  for (std::size_t i = 0; i < sorted.size(); ++i)
    if (i == 0 || sorted[i].cell != sorted[i - 1].cell) kept.push_back(sorted[i].index);
  return kept;
}

}  // namespace

std::vector<Index> thinned(std::span<const Vec3> positions, std::vector<Index> candidates, const Box& box,
                           std::size_t most) {
  std::sort(candidates.begin(), candidates.end());
  const double side = box.size().maxCoeff();
  if (candidates.size() <= most || !(side > 0)) {
    candidates.resize(std::min(candidates.size(), most));
    return candidates;
  }
  // A surface through the whole box meets about (side / cell)^2 cells; begin with finer ones.
  for (double cell = 0.5 * side / std::sqrt(static_cast<double>(most));; cell *= growth) {
    std::vector<Index> kept = one_per_cell(positions, candidates, box, cell);
    if (kept.size() > most) continue;
    std::sort(kept.begin(), kept.end());
    return kept;
  }
}

}  // namespace croquis::implicit
