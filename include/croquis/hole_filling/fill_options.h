// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "croquis/base/members.h"
#include "croquis/base/stage_cache.h"
#include "croquis/geometry/vector.h"
#include "croquis/hole_filling/hole_analysis.h"
#include "croquis/implicit/kernels.h"

namespace croquis::hole_filling {

/// How Fairness::Implicit continues the surface: a radial basis function is fitted to vertices and normals around the
/// hole, and the patch lies where it is 0 (after Yoo 2005).
struct ImplicitOptions {
  /// Hermite takes r^5 for single holes up to a quarter of the component's size, r^3 for others.
  implicit::Kernel kernel = implicit::Kernel::Hermite;
  double reach = 0.4;              ///< how far around the rim the surface counts, × the rim's diameter
  std::size_t most_centres = 200;  ///< of one fit; time grows with the third power

  /// As implicit::FitOptions has it. Around holes, by Hermite kernels, both follow the surface's roughness; what is
  /// said here, compared with these defaults, is a factor of that.
  double value_smoothing = 1;
  double gradient_smoothing = 5;

  bool both_sides = true;  ///< points off the surface, where the kernel needs them: false as in Yoo 2005
};
constexpr auto members(const ImplicitOptions& options) {
  return std::tie(options.kernel, options.reach, options.most_centres, options.value_smoothing,
                  options.gradient_smoothing, options.both_sides);
}
static_assert(lists_every_member<ImplicitOptions>);

/// How patches continue the surface.
enum class Fairness {
  Flat,     ///< the triangulation of least area, no new vertices
  Tangent,  ///< continuity 1 across the rim
  Implicit  ///< the zero set of a function fitted to the surface around (Yoo 2005)
};

/// What kind of surface is to be continued.
enum class Preset {
  Auto,      ///< Standard, but where creases run into a hole these go on in it, as by Sharp
  Standard,  ///< smooth shapes, scanned with little noise
  Paper,     ///< offset points on one side, as in Yoo 2005 with Kernel::ThinPlate: for comparison
  Sharp,     ///< machined parts: creases go on in holes of any width, also where the sides between them are rougher
  Noisy      ///< rough scans: patches follow their rims less closely
};

/// How one patch is to be made.
struct PatchSettings {
  Fairness fairness = Fairness::Implicit;
  ImplicitOptions implicit;   ///< of Fairness::Implicit
  double bulge = 0;           ///< -1..1: turns the surface at the rim outwards (+) or inwards; 0: as it comes
  std::vector<Vec3> through;  ///< places that the patch goes through, model units
};
constexpr auto members(const PatchSettings& settings) {
  return std::tie(settings.fairness, settings.implicit, settings.bulge, settings.through);
}
static_assert(lists_every_member<PatchSettings>);

/// What is asked for single holes instead of the options for all; absent: the options count. Of several requests for a
/// hole the later ones win, each in what it sets.
struct HoleRequest {
  std::vector<Index> holes = {};  ///< ids
  bool bridge = false;            ///< one patch joins these rims, two or more, as a band
  std::optional<bool> fill = {};  ///< whatever the selection says; every other setting but `trim_rim` fills too
  std::optional<Fairness> fairness = {};
  std::optional<implicit::Kernel> kernel = {};
  std::optional<double> bulge = {};  ///< -1..1
  std::optional<int> trim_rim = {};  ///< 0..3 rings of faces
  std::vector<Vec3> through = {};    ///< places that the patch goes through, model units

  friend bool operator==(const HoleRequest&, const HoleRequest&) = default;
};

/// How coordinates will be stored, which is how they are judged. A mesh that is given in double precision and will be
/// stored in single is judged as both: somebody looks at it before, or stores it otherwise after all.
enum class Precision { Double, Single };

/// Which holes are filled, before `only` and `max_diameter` are asked.
enum class Selection {
  Inner,          ///< all that are not OUTER
  All,            ///< OUTER ones too
  AllButLargest,  ///< all but the one with the greatest diameter
  None            ///< only what requests name
};

struct FillOptions {
  Selection selection = Selection::Inner;
  std::vector<Index> only;  ///< ids of the holes to fill, instead of a selection; empty for the selection
  double max_diameter = std::numeric_limits<double>::infinity();  ///< wider holes stay open; model units
  Fairness fairness = Fairness::Implicit;
  ImplicitOptions implicit;  ///< of Fairness::Implicit
  Preset preset = Preset::Auto;
  double bulge = 0;                          ///< -1..1, see PatchSettings
  int trim_rim = 0;                          ///< 0..3 rings of faces around chosen holes that are removed first
  std::vector<HoleRequest> requests;         ///< for single holes
  bool flat_caps = true;                     ///< OUTER holes that are chosen with all others get flat patches:
                                             ///< smooth ones of an open tube would bulge by about a radius
  Precision precision = Precision::Double;   ///< how the result will be stored
  std::size_t most_patch_triangles = 40000;  ///< a patch that would need more is made of larger triangles
  bool mark_patches = true;  ///< mark the patches by a face channel "patch_id" (int32, -1 for the faces given), and
                             ///< how they are backed by a vertex channel "confidence" (float, 1 for the vertices given)
  HoleAnalysisOptions analysis;
  int threads = 1;               ///< 0: as many as the machine has. The result is the same for any
  std::size_t memory_limit = 0;  ///< bytes; a mesh predicted to need more is refused. 0: none
  StageCache* cache = nullptr;   ///< analysis and patches of earlier runs, not owned; null: everything is computed
  std::string scan_key;          ///< distinguishes the mesh from all others in the cache; empty: all its bytes do
};

}  // namespace croquis::hole_filling
