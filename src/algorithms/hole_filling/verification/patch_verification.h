// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "croquis/base/progress.h"
#include "croquis/hole_filling/fill_options.h"
#include "croquis/hole_filling/hole_analysis.h"
#include "croquis/hole_filling/hole_patch.h"

namespace croquis::hole_filling {

/// Lets nothing into a mesh but what closes holes soundly.
///
/// A patch is sound when it is connected, manifold and turned one way; its border is exactly its holes' rims, against
/// the direction of their faces; it has as many handles as a sphere with that many holes (none), pinched at most where
/// two of its rims share a vertex; none of its inner edges joins vertices that the mesh or an accepted patch joins
/// already; no triangle is without area; and no triangle of it meets another one, of the mesh, of an accepted patch or
/// its own, anywhere but in shared vertices and edges, exactly, on coordinates as they will be written. A twisted strip
/// between two rims passes all but the last.
class PatchVerifier {
 public:
  /// Keeps references to both. Linear; copies positions and triangles at the first judgement.
  /// @param threads used at the same time, 0: all of the machine's; they change nothing
  PatchVerifier(const PolyMesh& mesh, const HoleAnalysis& analysis, Precision precision = Precision::Double,
                int threads = 1);

  /// Judges each candidate by itself and against the mesh, whatever was accepted: the verdict depends on nothing else.
  /// Near-linear in the candidates and what lies near them, beside one look at every triangle of the mesh.
  /// @throws Cancelled
  std::vector<PatchVerdict> judge(std::span<const HolePatch> candidates, Progress& progress);

  /// Compares the candidates, in order, with all that was accepted before them, and accepts the sound.
  /// @param verdicts what `judge` said of them: those with a fault stay outside
  /// @throws Cancelled, having accepted nothing
  std::vector<PatchVerdict> accept_sound(std::span<const HolePatch> candidates, std::vector<PatchVerdict> verdicts,
                                         Progress& progress);

  /// Both, one after the other.
  std::vector<PatchVerdict> accept_sound(std::span<const HolePatch> candidates, Progress& progress);

  /// Pairs (low, high) of vertices on rims, by their representatives, that an edge joins: sorted.
  const std::vector<std::array<Index, 2>>& rim_edges() const { return rim_edges_; }

 private:
  using Edges = std::vector<std::array<Index, 2>>;

  PatchVerdict judge_structure(const HolePatch& patch) const;
  bool joins_any(const HolePatch& patch, const Edges& edges) const;
  void judge_against_mesh(std::span<const HolePatch> candidates, std::vector<PatchVerdict>& verdicts,
                          Progress& progress);
  void judge_against_each_other(std::span<const HolePatch> candidates, std::vector<PatchVerdict>& verdicts,
                                Progress& progress);
  void make_scene(std::span<const HolePatch> candidates);
  Eigen::AlignedBox3d append_to_patches(const HolePatch& patch);
  void accept(const HolePatch& patch);

  const PolyMesh& mesh_;
  const HoleAnalysis& analysis_;
  Precision precision_;
  int threads_;
  PolyMesh scene_;    ///< the view's triangles, with coordinates as written; empty before the first judgement
  PolyMesh patches_;  ///< all vertices on rims and the accepted patches, likewise
  std::vector<Eigen::AlignedBox3d> accepted_boxes_;  ///< of the accepted patches
  std::vector<Index> rim_vertices_;                  ///< of the view, ascending: the first of `patches_`
  Edges mesh_edges_;                                 ///< between vertices on rims
  Edges rim_edges_;                                  ///< and those of accepted patches
  std::unique_ptr<PatchVerifier> as_given_;          ///< judges in double precision besides, where that differs
};

}  // namespace croquis::hole_filling
