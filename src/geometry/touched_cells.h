// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "croquis/geometry/poly_mesh.h"
#include "geometry/packed_box.h"

namespace croquis {

/// The cells of a coarse grid that the boxes of some faces touch: a fast test which other faces may be near them.
class TouchedCells {
 public:
  /// Visits every vertex once. Keeps a reference.
  TouchedCells(const PolyMesh& mesh, std::span<const Index> faces);

  /// False only for a face whose box meets none of theirs.
  bool may_be_near(Index face) const;

 private:
  void number_cells(const Vec3& low, const Vec3& high);  ///< of the faces' bounds
  PackedBox cells_of(Index face) const;

  const PolyMesh& mesh_;
  std::size_t cells_per_axis_;
  std::vector<PackedPlace> cells_;  ///< per vertex
  std::vector<bool> touched_;
};

}  // namespace croquis
