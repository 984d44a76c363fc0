// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <span>
#include <vector>

#include "algorithms/mesh_editing/mesh_rebuild.h"
#include "croquis/geometry/disjoint_sets.h"

/// What extruding and insetting share: faces part from their neighbours, and walls join them to where they were.
namespace croquis {

/// The faces to lift, and which of their vertices part from the rest.
class LiftedRegion {
 public:
  LiftedRegion(const MeshTopology& topology, std::span<const Index> faces);

  bool lifts(Index face) const { return lifted_[face] != 0; }
  bool empty() const;

  /// Whether a wall rises from the edge that this corner of a lifted face starts.
  bool on_rim(Index corner) const;

  /// The corners of a vertex that stay together share one number.
  Index umbrella(Index corner) { return umbrellas_.root(corner); }

  /// Whether the vertex stays below and a copy of it rises.
  bool parts(Index corner) { return parts_.contains(umbrella(corner)); }

 private:
  void join_corners();
  void join(Index a, Index b);
  void find_rims();

  const MeshTopology& topology_;
  std::vector<char> lifted_;
  DisjointSets umbrellas_;
  std::set<Index> parts_;
};

/// Old corners to the vertices that they have now.
struct LiftedVertices {
  std::vector<Index> vertex;              ///< #C
  std::vector<Index> moved;               ///< new numbers of all vertices that go with the faces
  std::vector<std::vector<Index>> above;  ///< #V: of old vertices the ones lifted; empty where none is
};

/// The mesh with the region lifted by nothing: every vertex at its old place, walls without area.
struct LiftedMesh {
  MeshEdit edit;
  LiftedVertices vertices;
};

/// Tags of the lifted faces' edges and vertices go with them, the rim's too; the walls' own edges have none.
/// @param region not empty
LiftedMesh lift_region(const PolyMesh& mesh, const MeshTopology& topology, LiftedRegion& region);

}  // namespace croquis
