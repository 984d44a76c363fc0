// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "algorithms/hole_filling/continuation/rim_field.h"
#include "algorithms/hole_filling/triangulation/triangulations.h"
#include "croquis/base/progress.h"
#include "croquis/hole_filling/hole_patch.h"
#include "croquis/hole_filling/hole_site.h"

/// The methods that make patches, and the order in which they are tried: see "Methods" in
/// docs/algorithms/hole_filling.md. The caller verifies every patch, and goes on to the next method when one makes none
/// that is sound.
namespace croquis::hole_filling {

enum class Maker {
  Creased,   ///< each smooth side of the surface around continued by itself, creases where they meet
  Implicit,  ///< a triangulation of the rims moved onto the zero set of a fitted function (Yoo 2005)
  Cubes,     ///< the zero set of the same function polygonised beside the hole alone, and joined to the rims
  Smooth,    ///< triangulated, refined to the density of the rim, faired (Liepa 2003)
  Band,      ///< between two rims, without new vertices
  Flat       ///< the triangulation of least area, without new vertices
};

/// A maker as it is set for one attempt.
struct Method {
  Maker maker = Maker::Flat;

  /// Clear of what is near, and slower. Implicit and cubes: smoothed more, and clear of other sheets. Smooth: begun
  /// with the flat triangulation that cuts nothing, and untangled. Flat: the one that folds least, where it cuts
  /// nothing, or that of least area of triangles that cut nothing; for long rims the Delaunay triangulation in their
  /// plane. Band: of the shortest edges instead of the least area.
  bool careful = false;
};

/// The name in reports: "creased", "implicit", "implicit-cubes", "cgal-c1", "band", "minimal"; careful ones have
/// "-careful" behind it, but for "band-shortest" and "avoiding".
std::string name_of(const Method& method);

/// The methods for a site in the order in which they are tried.
/// @param is_cap closes an open section, whatever the settings say: flat
std::vector<Method> methods_for(const HoleSite& site, bool is_cap);

/// A patch for the site, or nothing when the method has none.
/// @throws Cancelled
std::optional<HolePatch> make_patch(const Method& method, const HoleSite& site, Progress& progress);

/// Each of the makers, as make_patch calls it.
std::optional<HolePatch> creased_patch(const HoleSite& site, Progress& progress);
std::optional<HolePatch> implicit_patch(const HoleSite& site, bool careful, Progress& progress);
std::optional<HolePatch> cubes_patch(const HoleSite& site, bool careful, Progress& progress);
std::optional<HolePatch> smooth_patch(const HoleSite& site, bool careful, Progress& progress);
std::optional<HolePatch> band_patch(const HoleSite& site, bool shortest, Progress& progress);
std::optional<HolePatch> flat_patch(const HoleSite& site, bool careful, Progress& progress);

/// What implicit patches begin with: triangulated in the rims' plane where that can be, refined to twice the edges of
/// the rim, faired evenly (see refine_evenly, fair_evenly).
std::optional<HolePatch> even_patch(const HoleSite& site, Progress& progress);

/// Moves a patch of correct connectivity onto the surface continued, in rounds of smoothing, projection, splits,
/// collapses and flips; it meets the rims and goes through the places that the site is to go through.
/// @param rounds of these
/// @return nothing when the patch moves away from its rims or doesn't come to rest
/// @throws Cancelled
std::optional<HolePatch> lay_onto(const HoleSite& site, const RimField& surface, const HolePatch& start, int rounds,
                                  Progress& progress);

/// Of patches that begin with cubes or creases, or are careful: their triangles are worse at first.
inline constexpr int most_rounds = 5;

/// The triangulation of least area whose triangles meet neither the surface nor one another where they shouldn't:
/// triangles that do are forbidden and the search is repeated, 25 times for long rims and up to 300 times for short
/// ones. A triangulation lies within the convex hull of its rim, so the surface is looked at there alone.
/// @return triangles of the site's polygon; nothing for more than 300 points, or when none was found
/// @throws Cancelled
std::optional<Triangles> avoiding_triangulation(const HoleSite& site, Progress& progress);

/// The triangulation of one rim that folds least, together with the faces around (see dihedral_triangulation), whatever
/// it cuts; nothing for more than 1500 points.
std::optional<Triangles> least_folding_triangulation(const HoleSite& site, Progress& progress);

/// Whether a patch rises farther than half the diameter of its widest rim, and 1.3 times as far as the one that
/// smooth_patch makes, or as the rims themselves. Where that one folds back at its rim there is nothing to compare
/// with: then no patch does. Bands and patches with places or a bulge to follow never do: what they are is wanted.
/// Linear, unless it rises so far: then that other patch is made.
bool rises_too_far(const HoleSite& site, const HolePatch& patch, Progress& progress);

/// Whether one band is wanted between two rims: they are to be bridged, or are a tunnel's.
bool joins_two_rims(const HoleSite& site);

/// What several methods for one site begin with. Used by one thread at a time.
class SiteMemory {
 public:
  /// That of the site; nothing where it has none. Forgets what was made while fewer or more edges were blocked.
  static SiteMemory* of(const HoleSite& site);

  std::map<bool, std::optional<HolePatch>> smooth;   ///< by whether they are careful
  std::optional<std::optional<Triangles>> avoiding;  ///< see avoiding_triangulation
  std::optional<HolePatch> folded;                   ///< what the site comes back to if nothing is better

  using Smoothness = std::tuple<double, bool, bool>;  ///< stiffness, with other sheets, with every normal
  std::map<Smoothness, std::optional<RimField>> fields;
  std::optional<double> crease_cosine;  ///< see there; whatever edges are blocked

 private:
  std::vector<std::array<Index, 2>> blocked_;  ///< when these were made
};

/// The fit of fit_rims, made now or before.
std::optional<RimField> fitted_once(const HoleSite& site, const RimFitOptions& how);

}  // namespace croquis::hole_filling
