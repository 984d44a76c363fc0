// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <tuple>
#include <vector>

#include "croquis/base/members.h"
#include "croquis/geometry/vector.h"
#include "croquis/hole_filling/implicit_options.h"

namespace croquis::hole_filling {

/// How patches continue the surface.
enum class Fairness {
  Flat,     ///< the triangulation of least area, no new vertices
  Tangent,  ///< continuity 1 across the rim
  Curved,   ///< continuity 2
  Implicit  ///< the zero set of a function fitted to the surface around (Yoo 2005)
};

/// What kind of surface is to be continued.
enum class Preset {
  Auto,      ///< Standard, but where creases run into a hole these go on in it, as by Sharp
  Standard,  ///< smooth shapes, scanned with little noise
  Paper,     ///< offset points on one side, as in Yoo 2005 with Kernel::ThinPlate: for comparison
  Sharp,     ///< machined parts: per hole the method that repairs known surface beside it best
  Noisy      ///< rough scans: patches follow their rims less closely
};

/// How one patch is to be made.
struct PatchWish {
  Fairness fairness = Fairness::Implicit;
  ImplicitOptions implicit;   ///< of Fairness::Implicit
  double bulge = 0;           ///< -1..1: turns the surface at the rim outwards (+) or inwards; 0: as it comes
  std::vector<Vec3> through;  ///< places that the patch goes through, model units
};
constexpr auto members(const PatchWish& wish) {
  return std::tie(wish.fairness, wish.implicit, wish.bulge, wish.through);
}
static_assert(lists_every_member<PatchWish>);

/// What is wanted of single holes instead of the options for all. Of several requests for a hole the later
/// ones win, each in what it sets.
struct HoleRequest {
  std::vector<Index> holes;  ///< ids, ascending
  bool bridge = false;       ///< one patch joins these rims, two or more, as a band
  std::optional<bool>
      fill;  ///< whether it is filled, whatever the selection; every other wish but `trim_rim` fills too
  std::optional<Fairness> fairness;
  std::optional<implicit::Kernel> kernel;
  std::optional<double> bulge;
  std::optional<int> trim_rim;  ///< 0..3 rings of faces
  std::vector<Vec3> through;
};

}  // namespace croquis::hole_filling
