// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <tuple>

#include "croquis/base/finding.h"
#include "croquis/base/members.h"
#include "croquis/base/progress.h"
#include "croquis/geometry/poly_mesh.h"
#include "croquis/subdivision/rules.h"

namespace croquis::subdivision {

struct FairingOptions {
  Rules rules;               ///< of the Doo-Sabin surface that is made fair
  int levels = 2;            ///< >= 0; at which its curvature is measured
  bool fair_chains = false;  ///< moves the vertices of tagged edges too, each chain as a curve of its own first
  bool keep_planes = true;   ///< planar faces beside tagged edges stay in their planes, and so do planar chains; the
                             ///< angles across tags then stay as they are
};

constexpr auto members(const FairingOptions& options) {
  return std::tie(options.rules, options.levels, options.fair_chains, options.keep_planes);
}

static_assert(lists_every_member<FairingOptions>);

struct FairCage {
  PolyMesh mesh;             ///< the cage with moved points
  double energy_before = 0;  ///< of the surface; no unit: the same for a cage of another size
  double energy = 0;
  double greatest_move = 0;  ///< model units
  double mean_move = 0;      ///< over the points that may move
};

/// Moves a cage's points so that its subdivision surface has less and more even curvature.
///
/// Minimises |L S X|^2 + w |X - X0|^2 over the free points X. S: the points of `levels` refinements as weights of the
/// cage's. L: the cotangent Laplacian of that level at the start, on polygons by a point in the middle of each (Bunge,
/// Herholz, Kazhdan, Botsch 2020), each row over the root of its vertex' area, so that the sum is the surface integral
/// of the squared mean curvature; without rows at tags, boundaries and corners. Not free: pins, vertices on the
/// boundary and vertices of tagged edges. With `fair_chains` the latter are moved before, to the minimum of
/// |second differences|^2 / h^2 + w |X - X0|^2 along each chain (h: median edge length), ends and pins held.
/// The energy is least for a point: where nothing holds a surface, weights far below the default shrink it.
/// Everything up to the order of elimination is computed once; each weight costs one factorisation (Eigen's LDLT). The
/// energy never grows as w falls.
class Fairing {
 public:
  /// @param mesh tags are read from it
  /// @throws Error as make_cage and DooSabinPlan; Cancelled
  Fairing(const PolyMesh& mesh, const FairingOptions& options, Progress& progress);

  /// A weight that takes out noise and keeps the shape: 10 / h^2.
  double default_weight() const;

  std::size_t free_point_count() const;
  const Findings& warnings() const;  ///< of make_cage

  /// The same weight again costs nothing but the solution. Not for several threads at once.
  /// @param weight > 0, in 1 / model units^2
  /// @throws Error: E_PARAMETER for other weights, E_FAIRING for weights too small for doubles; Cancelled
  FairCage solve(double weight, Progress& progress);

 private:
  struct State;
  std::shared_ptr<State> state_;
};

}  // namespace croquis::subdivision
