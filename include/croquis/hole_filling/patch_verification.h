// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "croquis/base/progress.h"
#include "croquis/hole_filling/hole_analysis.h"
#include "croquis/hole_filling/hole_patch.h"

namespace croquis::hole_filling {

/// How coordinates will be stored, which is how they are judged.
enum class Precision { Double, Single };

/// Lets nothing into a mesh but what closes holes soundly.
///
/// A patch is sound when it is connected, manifold and turned one way; its border is exactly its holes' rims, against
/// the direction of their faces; it has as many handles as a sphere with that many holes (none), pinched at most where
/// two of its rims share a vertex; none of its inner
/// edges joins vertices that the mesh or an accepted patch joins already; no triangle is without area; and no triangle
/// of it meets another one, of the mesh, of an accepted patch or its own, anywhere but in shared vertices and edges,
/// exactly, on coordinates as they will be written. A twisted strip between two rims passes all but the last.
class PatchVerifier {
 public:
  /// Keeps references to both. Linear; copies positions and triangles.
  PatchVerifier(const PolyMesh& mesh, const HoleAnalysis& analysis, Precision precision = Precision::Double);

  /// Judges the candidates in order, each against the mesh and all that was accepted before it, and accepts the sound.
  /// Near-linear in the candidates and what lies near them.
  /// @throws Cancelled, having accepted nothing
  std::vector<PatchVerdict> accept_sound(std::span<const HolePatch> candidates, Progress& progress);

  /// Pairs (low, high) of vertices on rims, by their representatives, that an edge joins: sorted.
  const std::vector<std::array<Index, 2>>& rim_edges() const { return rim_edges_; }

 private:
  PatchVerdict judge_alone(const HolePatch& patch) const;
  void judge_intersections(std::span<const HolePatch> candidates, std::vector<PatchVerdict>& verdicts,
                           Progress& progress);
  bool clashes_with_accepted(const HolePatch& patch) const;
  void accept(const HolePatch& patch);

  const PolyMesh& mesh_;
  const HoleAnalysis& analysis_;
  PolyMesh scene_;  ///< the view's triangles and all accepted patches, with coordinates as written
  std::vector<std::array<Index, 2>> rim_edges_;
};

}  // namespace croquis::hole_filling
