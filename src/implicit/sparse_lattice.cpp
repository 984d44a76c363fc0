// SPDX-License-Identifier: GPL-3.0-or-later
#include "implicit/sparse_lattice.h"

#include <algorithm>
#include <cmath>

#include "implicit/point_checks.h"

namespace croquis::implicit {
namespace {

constexpr double most_cubes = 4194304;  // per axis: block numbers of three axes fit one key
constexpr double most_steps = 1e15;     // from the origin: lattice coordinates stay whole in a double
constexpr double farthest_seed = 1e9;   // in cubes; seeds beyond are out of every box

std::array<std::int32_t, 3> first_of_upper(const LatticeBlock& block, unsigned bits) {
  std::array<std::int32_t, 3> first = block.first;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if ((bits >> axis & 1U) != 0) first[axis] += LatticeBlock::side;
  return first;
}

}  // namespace

SparseLattice::SparseLattice(const Vec3& origin, double cell, const Box& bounds, int layer_axis)
    : origin_(origin), cell_(cell), axis_(static_cast<std::size_t>(layer_axis)) {
  require_parameter(std::isfinite(cell) && cell > 0, "cell", "the cubes' edge length must be positive");
  require_parameter(origin.allFinite() && bounds.low.allFinite() && bounds.high.allFinite() &&
                        (bounds.low.array() <= bounds.high.array()).all(),
                    "bounds", "origin and box must be finite, and the box not inside out");
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<Eigen::Index>(axis);
    base_[axis] = std::ceil((bounds.low[i] - origin[i]) / cell);
    const double count = std::floor((bounds.high[i] - origin[i]) / cell) - base_[axis];
    require_parameter(std::abs(base_[axis]) < most_steps && count <= most_cubes, "cell",
                      "the box holds more than 4194304 cubes along one axis; choose larger ones");
    counts_[axis] = static_cast<std::int64_t>(std::max(count, 0.0));
  }
}

Vec3 SparseLattice::position(const std::array<std::int32_t, 3>& corner) const {
  return {origin_.x() + cell_ * (base_[0] + corner[0]), origin_.y() + cell_ * (base_[1] + corner[1]),
          origin_.z() + cell_ * (base_[2] + corner[2])};
}

std::array<std::int64_t, 3> SparseLattice::cube_at(const Vec3& place) const {
  std::array<std::int64_t, 3> cube;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<Eigen::Index>(axis);
    const double steps = std::floor((place[i] - origin_[i]) / cell_) - base_[axis];
    cube[axis] = static_cast<std::int64_t>(std::isfinite(steps) ? std::clamp(steps, -farthest_seed, farthest_seed)
                                                                : -farthest_seed);
  }
  return cube;
}

bool SparseLattice::has_cube(const std::array<std::int64_t, 3>& cube) const {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (cube[axis] < 0 || cube[axis] >= counts_[axis]) return false;
  return true;
}

LatticePlace SparseLattice::place(const std::array<std::int64_t, 3>& corner) {
  std::array<std::int32_t, 3> first;
  unsigned local = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    first[axis] = static_cast<std::int32_t>(corner[axis] & ~std::int64_t{7});
    local |= static_cast<unsigned>(corner[axis] & 7) << (3 * axis);
  }
  return {&block(first), static_cast<std::uint16_t>(local)};
}

LatticePlace SparseLattice::upper(const LatticePlace& place, unsigned bits) {
  unsigned local = place.local;
  unsigned over = 0;
  for (unsigned axis = 0; axis < 3; ++axis) {
    if ((bits >> axis & 1U) == 0) continue;
    const unsigned shift = 3 * axis;
    if ((local >> shift & 7U) == 7U) {
      local &= ~(7U << shift);
      over |= 1U << axis;
    } else {
      local += 1U << shift;
    }
  }
  if (over == 0) return {place.block, static_cast<std::uint16_t>(local)};
  LatticeBlock*& neighbour = place.block->upper[over];
  if (neighbour == nullptr) neighbour = &block(first_of_upper(*place.block, over));
  return {neighbour, static_cast<std::uint16_t>(local)};
}

std::optional<LatticePlace> SparseLattice::neighbour(const LatticePlace& cube, unsigned face) {
  const unsigned axis = face / 2;
  const bool up = (face & 1U) != 0;
  const auto here = cube.coordinates();
  std::array<std::int64_t, 3> there = {here[0], here[1], here[2]};
  there[axis] += up ? 1 : -1;
  if (!has_cube(there)) return std::nullopt;
  const unsigned step = 1U << (3 * axis);
  if ((cube.local >> (3 * axis) & 7) == (up ? 7 : 0)) return place(there);
  return LatticePlace{cube.block, static_cast<std::uint16_t>(up ? cube.local + step : cube.local - step)};
}

CornerValues SparseLattice::values(const LatticePlace& cube) {
  CornerValues values;
  const bool at_rim = (cube.local & 7) == 7 || (cube.local >> 3 & 7) == 7 || cube.local >> 6 == 7;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const unsigned step = (corner & 1U) + 8 * (corner >> 1 & 1U) + 64 * (corner >> 2);
    const LatticePlace place =
        at_rim ? upper(cube, corner) : LatticePlace{cube.block, static_cast<std::uint16_t>(cube.local + step)};
    values[corner] = place.block->values[place.local];
  }
  return values;
}

double SparseLattice::bottom(int layer) const {
  std::array<std::int32_t, 3> corner = {};
  corner[axis_] = layer * LatticeBlock::side;
  return position(corner)[static_cast<Eigen::Index>(axis_)];
}

void SparseLattice::link(int layer) {
  const auto here = layers_.find(layer);
  if (here == layers_.end()) return;
  for (LatticeBlock& block : here->second) {
    for (unsigned bits = 1; bits < 8; ++bits) {
      const auto found = by_key_.find(key_of(first_of_upper(block, bits)));
      block.upper[bits] = found == by_key_.end() ? nullptr : found->second;
    }
  }
}

void SparseLattice::drop(int layer) {
  const auto here = layers_.find(layer);
  if (here == layers_.end()) return;
  for (const LatticeBlock& block : here->second) by_key_.erase(key_of(block.first));
  layers_.erase(here);
}

std::uint64_t SparseLattice::key_of(const std::array<std::int32_t, 3>& first) {
  std::uint64_t key = 0;
  for (const std::int32_t coordinate : first)
    key = key << 20 | static_cast<std::uint64_t>(coordinate / LatticeBlock::side);
  return key;
}

LatticeBlock& SparseLattice::block(const std::array<std::int32_t, 3>& first) {
  LatticeBlock*& found = by_key_[key_of(first)];
  if (found == nullptr) {
    found = &layers_[first[axis_] / LatticeBlock::side].emplace_back();
    found->first = first;
  }
  return *found;
}

std::size_t SparseLattice::bytes() const {
  constexpr std::size_t entry = 48;  // of the table: key, pointer, link and bucket, about
  std::size_t count = 0;
  for (const auto& [layer, blocks] : layers_) count += blocks.size();
  return count * (sizeof(LatticeBlock) + entry);
}

}  // namespace croquis::implicit
