// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>

#include <Eigen/SparseCore>

#include "croquis/base/finding.h"
#include "croquis/base/progress.h"
#include "croquis/geometry/poly_mesh.h"
#include "croquis/subdivision/cage.h"
#include "croquis/subdivision/doo_sabin.h"
#include "croquis/subdivision/level.h"
#include "croquis/subdivision/rules.h"

namespace croquis::subdivision {

enum class UniformScheme {
  CatmullClark,  ///< Catmull, Clark 1978: bicubic where regular
  Loop           ///< Loop 1987: triangles
};

struct UniformRules {
  UniformScheme scheme = UniformScheme::CatmullClark;
  BoundaryCorners boundary_corners = BoundaryCorners::Corner;
};

/// Catmull-Clark or Loop refinement of a cage with the tags of Doo-Sabin, computed by OpenSubdiv in doubles.
///
/// Sharp edges follow DeRose, Kass, Truong 1998: sharpness counts down by one per level, chains tend to cubic
/// B-splines, pins are vertices of infinite sharpness, boundaries are sharp. As in DooSabinPlan, everything that
/// depends on connectivity, tags and rules alone is here; positions follow as often as points are dragged. Loop first
/// cuts faces of more than three corners along diagonals without tags, chosen by connectivity alone so that dragging
/// can't flip them (W_TRIANGULATED); a face of which every diagonal joins vertices already joined gets a vertex at its
/// centre. Immutable and cheap to copy; threads may share it.
class UniformPlan {
 public:
  /// Time and memory linear in the last level's faces.
  /// @throws Error: E_TOO_MANY_FACES with the predicted counts, before anything is allocated; E_SUBDIVISION with
  /// OpenSubdiv's own words, for vertices or faces with more than 65535 edges; Cancelled
  UniformPlan(const Cage& cage, const UniformRules& rules, const Depth& depth, Progress& progress);

  const UniformRules& rules() const;
  const Findings& warnings() const;
  int levels() const;  ///< the last one

  /// @param k 0 (the cage; for Loop its triangles) … levels()
  const Level& level(int k) const;

  /// The points of all levels; level 0 repeats the cage's and adds centres of faces, where Loop needed some. The same
  /// bits for any number of threads.
  /// @param cage #V of the cage; @param buffers resized where needed; @param threads >= 1
  void positions(std::span<const Vec3> cage, PositionBuffers& buffers, int threads = 1) const;

  /// The points of level k as weights of those of level k-1: rows sum to 1.
  /// @param k 1 … levels()
  Eigen::SparseMatrix<double, Eigen::RowMajor> weights(int k) const;

  /// The face of the cage that holds a face of level k (0 …).
  Index cage_face(int k, Index face) const;

 private:
  struct State;
  std::shared_ptr<const State> state_;
};

/// A level as a mesh with its tags, and per face the channels "cage_kind" and "cage_element" of Doo-Sabin's levels:
/// always a face, and which.
/// @param k 0 … plan.levels(); @param positions #V of that level
PolyMesh to_mesh(const UniformPlan& plan, int k, std::span<const Vec3> positions);

}  // namespace croquis::subdivision
