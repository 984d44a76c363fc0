// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/attribute_surface/bridges/rim_sides.h"

#include <algorithm>
#include <numbers>
#include <utility>

namespace croquis {
namespace {

constexpr std::size_t most_rim_sides = 12;
constexpr std::size_t round_sides = 4;  // of a rim with fewer corners than a face has sides
constexpr std::size_t fewest_sides = 3;
constexpr std::size_t coarse_rim = 16;  // edges: turns of longer ones are taken over two

/// The sharpest corners, ascending; at most `most`.
std::vector<std::size_t> sharpest_corners(std::span<const Vec3> loop, double corner, std::size_t most) {
  const std::size_t n = loop.size(), reach = n < coarse_rim ? 1 : 2;
  const double least = corner + 2 * std::numbers::pi * static_cast<double>(reach) / static_cast<double>(n);
  std::vector<std::pair<double, std::size_t>> turns;  // less the turn, so that the sharpest come first
  for (std::size_t i = 0; i < n; ++i) {
    const double turn = angle_between(loop[i] - loop[(i + n - reach) % n], loop[(i + reach) % n] - loop[i]);
    if (turn > least) turns.emplace_back(-turn, i);
  }
  std::ranges::sort(turns);
  std::vector<std::size_t> found;
  for (const auto& [turn, i] : turns) {
    const auto is_near = [&, at = i](std::size_t other) {
      const std::size_t apart = at > other ? at - other : other - at;
      return std::min(apart, n - apart) < reach;
    };
    if (found.size() < most && std::ranges::none_of(found, is_near)) found.push_back(i);
  }
  std::ranges::sort(found);
  return found;
}

/// A stretch of the loop between two corners, or all of it.
struct Stretch {
  std::size_t first = 0;
  std::size_t edges = 0;
  double length = 0;
  std::size_t parts = 1;
};

/// Lengths from the stretch's first point to each of its points.
std::vector<double> lengths_along(std::span<const Vec3> loop, const Stretch& stretch) {
  std::vector<double> lengths{0};
  for (std::size_t e = 0; e < stretch.edges; ++e) {
    const std::size_t i = (stretch.first + e) % loop.size();
    lengths.push_back(lengths.back() + (loop[(i + 1) % loop.size()] - loop[i]).norm());
  }
  return lengths;
}

std::vector<Stretch> stretches_between(std::span<const Vec3> loop, std::vector<std::size_t> corners) {
  if (corners.empty()) corners.push_back(0);
  std::vector<Stretch> stretches;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const std::size_t next = corners[(k + 1) % corners.size()];
    Stretch stretch{corners[k], (next + loop.size() - corners[k]) % loop.size(), 0, 1};
    if (stretch.edges == 0) stretch.edges = loop.size();
    stretch.length = lengths_along(loop, stretch).back();
    stretches.push_back(stretch);
  }
  return stretches;
}

/// Divides the stretch with the longest parts, again and again.
void share_out(std::vector<Stretch>& stretches, std::size_t sides) {
  const auto part_length = [](const Stretch& s) {
    return s.parts < s.edges ? s.length / static_cast<double>(s.parts) : -1;
  };
  for (std::size_t count = stretches.size(); count < sides; ++count) {
    Stretch& longest = *std::ranges::max_element(stretches, {}, part_length);
    if (longest.parts < longest.edges) ++longest.parts;
  }
}

void cut_evenly(std::span<const Vec3> loop, const Stretch& stretch, std::vector<std::size_t>& cuts) {
  const std::vector<double> lengths = lengths_along(loop, stretch);
  std::size_t before = 0;
  cuts.push_back(stretch.first % loop.size());
  for (std::size_t k = 1; k < stretch.parts; ++k) {
    const double wanted = stretch.length * static_cast<double>(k) / static_cast<double>(stretch.parts);
    auto e = static_cast<std::size_t>(std::ranges::lower_bound(lengths, wanted) - lengths.begin());
    if (e > 0 && wanted - lengths[e - 1] < lengths[e] - wanted) --e;
    e = std::clamp(e, before + 1, stretch.edges - (stretch.parts - k));
    cuts.push_back((stretch.first + e) % loop.size());
    before = e;
  }
}

}  // namespace

RimCuts cut_rim(std::span<const Vec3> loop, double corner, std::size_t sides) {
  const std::vector<std::size_t> corners = sharpest_corners(loop, corner, sides == 0 ? most_rim_sides : sides);
  const std::size_t automatic = corners.size() < fewest_sides ? round_sides : corners.size();
  const std::size_t wanted = sides != 0 ? sides : automatic;
  std::vector<Stretch> stretches = stretches_between(loop, corners);
  share_out(stretches, std::min(wanted, loop.size()));
  RimCuts cuts;
  for (const Stretch& stretch : stretches) cut_evenly(loop, stretch, cuts.at);
  std::ranges::sort(cuts.at);
  for (const std::size_t at : cuts.at) cuts.is_corner.push_back(std::ranges::binary_search(corners, at));
  return cuts;
}

}  // namespace croquis
