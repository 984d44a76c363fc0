// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "croquis/implicit/box_weight.h"
#include "croquis/implicit/marching_cubes.h"

namespace croquis::implicit {

/// 512 bits, one for each corner or cube of a block.
class BlockBits {
 public:
  bool test(unsigned i) const { return (words_[i / 64] >> (i % 64) & 1U) != 0; }
  void set(unsigned i) { words_[i / 64] |= std::uint64_t{1} << (i % 64); }

  /// Sets the bit; false when it was set before.
  bool insert(unsigned i) {
    if (test(i)) return false;
    set(i);
    return true;
  }

  std::uint64_t word(unsigned w) const { return words_[w]; }
  static constexpr unsigned word_count = 8;

 private:
  std::array<std::uint64_t, word_count> words_ = {};
};

/// 8 by 8 by 8 corners of the lattice, each with the cube and the three edges that begin there.
struct LatticeBlock {
  static constexpr int side = 8;
  static constexpr unsigned size = 512;

  std::array<std::int32_t, 3> first = {};   ///< lattice coordinates of corner 0
  std::array<double, size> values;          ///< of the corners that are known
  BlockBits known, visited, active;         ///< corners with values; cubes looked at; cubes with surface
  std::array<BlockBits, 3> crossed;         ///< edges along x, y, z that active cubes cross
  std::array<BlockBits, 3> covered;         ///< of these, the ones that a surface covers already
  std::array<LatticeBlock*, 8> upper = {};  ///< neighbours, one bit per axis; null until needed
  std::size_t number = 0;                   ///< for who walks over the blocks
};

/// Values of a cube's eight corners.
using CornerValues = std::array<double, 8>;

/// One corner (and the cube and edges that begin there).
struct LatticePlace {
  LatticeBlock* block = nullptr;
  std::uint16_t local = 0;  ///< x + 8 y + 64 z in the block

  std::array<std::int32_t, 3> coordinates() const {
    return {block->first[0] + (local & 7), block->first[1] + (local >> 3 & 7), block->first[2] + (local >> 6)};
  }
};

/// Cubes of one size within a box, of which only the blocks that are asked for exist. Blocks never move.
class SparseLattice {
 public:
  /// @param axis across which blocks lie in layers
  /// @throws Error E_PARAMETER when cell or bounds can't be used
  SparseLattice(const Vec3& origin, double cell, const Box& bounds, int axis = 2);

  /// Model coordinates of a corner: the same bits in every lattice of this origin and cell.
  Vec3 position(const std::array<std::int32_t, 3>& corner) const;
  Vec3 position(const LatticePlace& place) const { return position(place.coordinates()); }

  /// Lattice coordinates of the cube that holds a place; it may lie out of the bounds.
  std::array<std::int64_t, 3> cube_at(const Vec3& place) const;

  /// True when the whole cube lies in the bounds.
  bool has_cube(const std::array<std::int64_t, 3>& cube) const;

  /// @param corner within the bounds
  LatticePlace place(const std::array<std::int64_t, 3>& corner);

  /// The corner one step up along the axes of `bits`. May make its block; after link, threads may look up corners
  /// whose blocks exist.
  LatticePlace upper(const LatticePlace& place, unsigned bits);

  /// The cube on the other side of a face (2 axis + side), unless that is out of the bounds.
  std::optional<LatticePlace> neighbour(const LatticePlace& cube, unsigned face);

  /// @param cube its corners are known
  CornerValues values(const LatticePlace& cube);

  /// Blocks by layers; a layer is as thick as a block.
  using Layers = std::map<int, std::deque<LatticeBlock>>;
  Layers& layers() { return layers_; }
  int layer_of(const LatticeBlock& block) const { return block.first[axis_] / LatticeBlock::side; }
  int layer_of(const std::array<std::int64_t, 3>& cube) const {
    return static_cast<int>(cube[axis_] / LatticeBlock::side);
  }
  double bottom(int layer) const;  ///< model coordinate along the axis of its lowest corners

  /// Lets the blocks of one layer know their neighbours.
  void link(int layer);

  /// Frees one layer. Nothing below may still use it, nor what leads up from there.
  void drop(int layer);

  std::size_t bytes() const;

 private:
  static std::uint64_t key_of(const std::array<std::int32_t, 3>& first);
  LatticeBlock& block(const std::array<std::int32_t, 3>& first);

  Vec3 origin_;
  double cell_;
  std::array<double, 3> base_ = {};          // of lattice coordinate 0, in cells from the origin: whole numbers
  std::array<std::int64_t, 3> counts_ = {};  // of cubes per axis
  std::size_t axis_;
  Layers layers_;
  std::unordered_map<std::uint64_t, LatticeBlock*> by_key_;  // looked up, never walked through
};

/// Where a crossed edge meets the surface: by linear interpolation, off its ends.
/// @param edge begins at the place, along the axis; both ends are known
Vec3 crossing(SparseLattice& lattice, const LatticePlace& edge, int axis);

/// @throws Error (E_PARAMETER) for limits out of range
void require_polygonizer(const PolygonizerOptions& options);

/// Goes over the surface front by front, until nothing is left to visit or a limit is met. Marks active cubes, crossed
/// and covered edges in the lattice, and counts in the result.
class SurfaceSearch {
 public:
  SurfaceSearch(SparseLattice& lattice, const Field& field, const PolygonizerOptions& options, Polygonized& result);

  /// Begins at seeds, cubes, and where earlier slabs led, and stays within layers below `end`. Cubes in layers below
  /// `begin` are not visited any more: they come into `missed`, unless they were visited before.
  void run_slab(std::span<const Vec3> seeds, std::span<const std::array<std::int64_t, 3>> cubes, int begin, int end,
                Progress& progress);
  const std::vector<std::array<std::int64_t, 3>>& missed() const { return missed_; }

 private:
  struct Edge {
    LatticePlace place;
    int axis;
  };

  /// A cube with surface; bit c of its signs is set where corner c is inside.
  struct ActiveCube {
    LatticePlace place;
    std::uint8_t signs;
  };

  void go_on(std::vector<LatticePlace> front, Progress& progress);
  std::vector<LatticePlace> first_front(std::span<const Vec3> seeds);
  void visit(const LatticePlace& cube, std::vector<LatticePlace>& front);
  void evaluate_corners(const std::vector<LatticePlace>& front, Progress& progress);
  std::vector<ActiveCube> active_cubes(const std::vector<LatticePlace>& front);
  void mark_crossings(const std::vector<ActiveCube>& cubes, Progress& progress);
  void ask_covered(const std::vector<Edge>& edges, Progress& progress);
  std::vector<LatticePlace> next_front(const std::vector<ActiveCube>& cubes);
  bool leads_on(const ActiveCube& cube, unsigned face);

  SparseLattice& lattice_;
  const Field& field_;
  const PolygonizerOptions& options_;
  Polygonized& result_;
  bool from_seeds_ = true;                       // the front under way
  int begin_ = std::numeric_limits<int>::min();  // layers that are open
  int end_ = std::numeric_limits<int>::max();
  std::vector<LatticePlace> ahead_;  // visited, in layers that come later
  std::vector<std::array<std::int64_t, 3>> missed_;
};

}  // namespace croquis::implicit
