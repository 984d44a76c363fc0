// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "croquis/implicit/slab_polygonizer.h"
#include "implicit/sparse_lattice.h"

namespace croquis::implicit {

/// Makes the mesh of a lattice layer by layer: of every layer the vertices on its crossed edges, in the order of its
/// blocks' places, then those in the middles of loops; triangles in the order of blocks and cubes.
class CubeLayers {
 public:
  /// @param made gets vertices and triangles
  CubeLayers(SparseLattice& lattice, const PolygonizerOptions& options, LayeredMesh& made);

  /// The next layer's vertices; layers come without gaps. Nothing more may be found in it.
  void place(int layer, Progress& progress);

  /// Triangles of the layer before the one that was placed last, or of that one when there is nothing above.
  void finish(Progress& progress);

  /// Held beside the mesh.
  std::size_t bytes() const;

 private:
  /// A block with the numbers of its vertices in their layer.
  struct NumberedBlock {
    LatticeBlock* block;
    std::array<Index, 3 * BlockBits::word_count> first = {};  // vertex of every word's first edge

    Index vertex(std::size_t axis, unsigned local) const;
  };

  /// What one part of the blocks gives.
  struct Piece {
    std::vector<std::uint32_t> corners;  // three per triangle: a vertex of this layer, the next one's, or a middle
    std::vector<Vec3> middles;
  };

  struct Layer {
    int number = 0;
    std::vector<NumberedBlock> blocks;
    std::vector<Vec3> points;
    std::vector<std::uint8_t> covered;
  };

  Layer numbered(int layer);
  void place_vertices(const NumberedBlock& numbered, Layer& layer);
  void add_triangles(LatticeBlock& block, Piece& piece);
  void add_loop(const LatticePlace& cube, std::span<const std::uint8_t> edges, Piece& piece);
  void append_points(const Layer& layer);

  SparseLattice& lattice_;
  const PolygonizerOptions& options_;
  LayeredMesh& made_;
  Layer below_, above_;  // the layer to be finished next and the one after it
  bool has_below_ = false;
};

}  // namespace croquis::implicit
