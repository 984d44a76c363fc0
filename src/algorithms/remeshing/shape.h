// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "algorithms/remeshing/backing.h"
#include "algorithms/remeshing/comparison.h"
#include "algorithms/remeshing/memory.h"
#include "algorithms/remeshing/openings.h"
#include "algorithms/remeshing/pieces.h"
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
  bool is_paper() const { return options.fill.preset == hole_filling::Preset::Paper; }
  double share_of(const RemeshPiece& piece) const {
    return static_cast<double>(piece.triangles.size()) / static_cast<double>(analysis.view.triangles.size());
  }
  RemeshPoints points_of(const RemeshPiece& piece) const {
    return remeshing::points_of(mesh, analysis, piece, normals, edge);
  }
};

/// The surface of one piece.
struct PieceShape {
  PolyMesh mesh;
  Openings openings;  ///< that are left
  PatchedOpenings patched;
  implicit::DomainReport domains;
  SurfaceTopology topology;
  std::optional<ExpectedTopology> expected;
  std::optional<double> volume;        ///< of a closed one
  std::optional<PieceExtent> given;    ///< the scan's, where that was compared
  ExtentChange change;                 ///< of it
  std::vector<Index> lost;             ///< vertices given without a surface, by their places in the piece's list
  double lost_share = 0;               ///< of the piece's area
  std::vector<LooseVertex> loose;      ///< vertices that are left farther than half a cell off the scan
  double cell = 0;                     ///< of its cubes, model units
  std::size_t slabs = 1;               ///< that it was made in
  std::size_t cuts = 0;                ///< pairs of its faces that intersect
  std::vector<Index> left_to_patches;  ///< holes where the field led away or stayed open
  bool retried = false;                ///< with smaller cells

  bool is_closed() const { return openings.loops.empty() && openings.meant == 0; }

  /// Whether it should have other components or handles, as far as that is clear or not.
  bool differs(bool clearly) const {
    return expected && expected->is_clear == clearly && difference(topology, expected->topology) > 0;
  }

  /// Of loops that shouldn't be, components and handles, counted, and whether it has another extent than the scan.
  std::size_t torn() const {
    return openings.loops.size() + (differs(true) ? difference(topology, expected->topology) : 0) +
           (change.any() ? 1 : 0);
  }
};

/// Remeshes one piece: without the holes where the field leaves openings, which patches close then, with smaller cells
/// where it comes out torn, grown together or with points lost, then with patches.
/// @throws Cancelled
PieceShape make_shape(const RemeshModel& model, std::size_t piece, Progress progress);

/// What lies farther off the scan is reported, but in holes; model units.
double near_of(const RemeshModel& model);

/// What of a surface of a piece isn't backed by the scan. @param open holes that stay open, or are so far
UnbackedVertices unbacked_in(const RemeshModel& model, const RemeshPiece& piece, const RemeshPoints& points,
                             const PolyMesh& surface, std::span<const Index> open, Progress progress);

}  // namespace croquis::remeshing
