// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "algorithms/remeshing/remesh_backing.h"
#include "algorithms/remeshing/remesh_improvement.h"
#include "algorithms/remeshing/remesh_memory.h"
#include "algorithms/remeshing/remesh_openings.h"
#include "algorithms/remeshing/remesh_pieces.h"
#include "algorithms/remeshing/remesh_points.h"
#include "algorithms/remeshing/remesh_room.h"
#include "algorithms/remeshing/remesh_topology.h"
#include "croquis/implicit/partition_of_unity.h"

namespace croquis::remeshing {

/// What all pieces of a model have in common.
struct RemeshModel {
  const PolyMesh& mesh;
  const hole_filling::HoleAnalysis& analysis;
  const RemeshOptions& options;
  RemeshPieces& pieces;
  const std::vector<Vec3>& normals;              ///< of the view's vertices
  const TriangleFans& fans;                      ///< of the view
  const std::vector<TriangleFans::Link>& links;  ///< of the view's vertices
  double edge = 0;                               ///< typical, model units
  double cell = 0;                               ///< as asked for, model units
  const RemeshMemory& memory;

  int threads() const { return options.fill.threads; }
  double share_of(const RemeshPiece& piece) const {
    return static_cast<double>(piece.triangles.size()) / static_cast<double>(analysis.view.triangles.size());
  }
};

/// The surface of one piece.
struct PieceShape {
  PolyMesh mesh;
  Openings openings;  ///< that are left
  PatchedHoles patched;
  implicit::DomainReport domains;
  SurfaceTopology topology;
  std::optional<SurfaceTopology> wanted;   ///< see wanted_topology
  std::optional<SurfaceTopology> implied;  ///< where nothing is wanted: see implied_topology
  std::optional<double> volume;            ///< of a closed one
  std::optional<PieceRoom> given_room;     ///< what the scan takes, where that was compared
  RoomChange room;                         ///< what it takes beside that
  std::vector<Index> lost;                 ///< vertices given without a surface
  double lost_share = 0;                   ///< of the piece's area
  std::vector<LooseVertex> loose;          ///< vertices that are left farther than half a cell off the scan
  double cell = 0;                         ///< of its cubes, model units
  std::size_t slabs = 1;                   ///< that it was made in
  std::size_t cuts = 0;                    ///< pairs of its faces that intersect
  bool runs_away = false;                  ///< leads far out of the model
  std::vector<Index> left_to_patches;      ///< holes where it did, and was ended therefore
  bool retried = false;                    ///< with smaller cells
  bool refused = false;                    ///< and emptied, since it didn't represent its piece

  bool is_closed() const { return openings.none() && openings.meant == 0; }

  /// Of loops that shouldn't be, components and handles, counted, and whether it takes other room than the scan.
  std::size_t torn() const {
    return openings.loops.size() + (wanted ? difference(topology, *wanted) : 0) + (room.any() ? 1 : 0);
  }
};

/// Remeshes one piece: without the holes where the field leaves openings, which patches close then, with smaller cells
/// where it comes out torn, grown together or with points lost, then with patches.
/// @throws Cancelled
PieceShape make_shape(const RemeshModel& model, std::size_t piece, Progress& progress);

/// What lies farther off the scan is told, but in holes; model units.
double near_of(const RemeshModel& model);

/// What of a surface of a piece isn't backed by the scan. @param open holes that stay open, or are so far
Strays strays_of(const RemeshModel& model, const RemeshPiece& piece, const RemeshPoints& points,
                 const PolyMesh& surface, std::span<const Index> open, Progress& progress);

/// How surfaces made of cubes of this size are improved.
ImprovementOptions improvement_of(const RemeshOptions& options, double cell);

/// Points that no vertex of a surface is within 1.25 cells of, and how many of them are few.
std::vector<Index> lost_points(const PolyMesh& surface, std::span<const Vec3> points, double cell, int threads,
                               Progress& progress);
bool are_few(std::size_t lost, std::size_t points);

}  // namespace croquis::remeshing
