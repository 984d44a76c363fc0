// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "croquis/implicit/marching_cubes.h"
#include "implicit/sparse_lattice.h"

namespace croquis::implicit {

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
