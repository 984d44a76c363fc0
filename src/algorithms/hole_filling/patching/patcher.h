// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/hole_filling/continuation/crease_field.h"
#include "croquis/base/progress.h"
#include "croquis/hole_filling/hole_patch.h"
#include "croquis/hole_filling/hole_site.h"
#include "croquis/hole_filling/implicit_options.h"

namespace croquis::hole_filling {

/// One method to make a patch. The caller verifies every patch and tries the next method when this one has none that
/// is sound.
class Patcher {
 public:
  virtual ~Patcher() = default;

  /// The name in reports.
  virtual const char* method() const = 0;

  /// A patch for the site, or nothing when this method has none.
  /// @throws Cancelled
  virtual std::optional<HolePatch> attempt(const HoleSite& site, Progress& progress) const = 0;
};

/// Methods in the order in which they are tried.
using Ladder = std::vector<std::shared_ptr<const Patcher>>;

/// "minimal": the triangulation of least area, without new vertices.
std::shared_ptr<const Patcher> minimal_patcher();

/// "avoiding": the triangulation of least area of triangles that cut through nothing, for short rims.
std::shared_ptr<const Patcher> avoiding_patcher();

/// "plane": the Delaunay triangulation of the rims in their plane, as it is, without new vertices.
std::shared_ptr<const Patcher> plane_patcher();

/// "dihedral": by dihedral angles and area, without new vertices; one rim only.
std::shared_ptr<const Patcher> dihedral_patcher();

/// "cgal-c1", "cgal-c2", with "-careful" behind it when so asked: triangulated, refined to the density of the rim,
/// faired.
/// @param continuity 1 or 2
/// @param most_triangles a patch that would get more is refined less
/// @param careful whether to begin with the triangulation of `avoiding_patcher`, where there is one, and to flip edges
///        until nothing is cut; slower
std::shared_ptr<const Patcher> faired_patcher(unsigned continuity, std::size_t most_triangles, bool careful = false);

/// "even": triangulated in the rims' plane where that can be, refined to twice the edges of the rim, faired evenly (see
/// refine_evenly, fair_evenly): quick, for methods that only begin with it.
std::shared_ptr<const Patcher> evenly_faired_patcher(std::size_t most_triangles);

/// "zip" for one rim: its two sides joined by a band. "band" for two rims: the band between them. No new vertices.
/// @param shortest whether the band has the shortest edges ("-shortest" in the name), else the least area
std::shared_ptr<const Patcher> zip_patcher();
std::shared_ptr<const Patcher> band_patcher(bool shortest);

/// "creased": each smooth side of the surface around continued by itself, creases where they meet (see CreaseField);
/// nothing for a hole that no crease runs into, or where the sides don't fit the surface around to `most_residual` (see
/// fit_sides).
std::shared_ptr<const Patcher> creased_patcher(const ImplicitOptions& options, std::size_t most_triangles,
                                               double most_residual = usual_side_residual);

/// Of several methods for a patch the one that repairs known surface beside the hole best (see CrossValidation), or
/// the second best, and so on. Its patch carries the name of the method taken and the expected error.
/// @param ways each has to be better by a fifth than those before it; a probe of which one makes nothing doesn't count
///        against it
/// @param rank 0 for the best
std::shared_ptr<const Patcher> validated_patcher(std::vector<std::shared_ptr<const Patcher>> ways, std::size_t rank);

/// "implicit", or "implicit-careful": what "even" (large holes: "cgal-c1") or "cgal-c1-careful" makes, moved onto the
/// zero set of a radial basis function fitted to the surface around (Yoo 2005), with triangles kept at the size of the
/// rim's edges.
/// @param careful smoothed more, clear of other sheets, and untangled
std::shared_ptr<const Patcher> implicit_patcher(const ImplicitOptions& options, std::size_t most_triangles,
                                                bool careful = false);

/// "implicit-cubes": the zero set of the same function polygonised beside the hole alone, zipped to the rims and
/// brought to the size of their edges. Needs no triangulation of the rims, so several, huge or crooked rims make no
/// difference. Where the continuation arrives at further rims, the patch lists those instead of triangles.
/// @param careful smoothed more, and clear of other sheets from the beginning ("-careful" in the name)
std::shared_ptr<const Patcher> polygonised_patcher(const ImplicitOptions& options, std::size_t most_triangles,
                                                   bool careful = false);

}  // namespace croquis::hole_filling
