// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/position_joiner.h"

#include <bit>

namespace croquis {
namespace {

constexpr std::size_t first_slots = 64;  // a power of two, as are all later sizes

// The mixer of splitmix64 (Steele, Lea and Flood 2014).
std::uint64_t mix(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31);
}

std::size_t hash(const Vec3& point) {
  std::uint64_t state = 0x9e3779b97f4a7c15U;
  for (const double x : point) state = mix(state ^ std::bit_cast<std::uint64_t>(x + 0.0));  // -0 becomes 0
  return static_cast<std::size_t>(state);
}

}  // namespace

PositionJoiner::PositionJoiner() : slots_(first_slots, no_index) {}

Index PositionJoiner::add(const Vec3& point, std::vector<Vec3>& positions) {
  if (2 * positions.size() >= slots_.size()) grow(positions);
  if (!point.allFinite()) {  // NaN equals nothing, and all NaNs would look for a slot at the same place
    positions.push_back(point);
    return static_cast<Index>(positions.size() - 1);
  }
  std::size_t slot = hash(point) & (slots_.size() - 1);
  for (; slots_[slot] != no_index; slot = (slot + 1) & (slots_.size() - 1)) {
    if (positions[slots_[slot]] == point) return slots_[slot];
  }
  slots_[slot] = static_cast<Index>(positions.size());
  positions.push_back(point);
  return slots_[slot];
}

void PositionJoiner::grow(const std::vector<Vec3>& positions) {
  slots_.assign(2 * slots_.size(), no_index);
  for (Index i = 0; i < positions.size(); ++i) {
    if (!positions[i].allFinite()) continue;
    std::size_t slot = hash(positions[i]) & (slots_.size() - 1);
    while (slots_[slot] != no_index) slot = (slot + 1) & (slots_.size() - 1);
    slots_[slot] = i;
  }
}

}  // namespace croquis
