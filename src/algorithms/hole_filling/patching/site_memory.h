// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "algorithms/hole_filling/continuation/rim_field.h"
#include "croquis/hole_filling/hole_patch.h"
#include "croquis/hole_filling/hole_site.h"

namespace croquis::hole_filling {

/// What several methods for one site begin with. Used by one thread at a time.
class SiteMemory {
 public:
  using Triangulation = std::optional<std::vector<std::array<Index, 3>>>;

  /// That of the site; nothing where it has none. Forgets what was made while fewer or more edges were blocked.
  static SiteMemory* of(const HoleSite& site);

  std::map<std::string, std::optional<HolePatch>> patches;  ///< by method
  std::optional<Triangulation> avoiding;                    ///< see avoiding_triangulation
  std::optional<HolePatch> folded;                          ///< what the site comes back to if nothing is better

  using Smoothness = std::tuple<double, bool, bool>;  ///< stiffness, with other sheets, with every normal
  std::map<Smoothness, std::optional<RimField>> fields;
  std::optional<double> crease_cosine;  ///< see there; whatever edges are blocked

 private:
  std::vector<std::array<Index, 2>> blocked_;  ///< when these were made
};

/// What a method made of a site before, or else makes of it now.
std::optional<HolePatch> made_once(const HoleSite& site, const std::string& method,
                                   const std::function<std::optional<HolePatch>()>& make);

/// The fit of fit_rims, made now or before.
/// @param options the same for all methods of a site
std::optional<RimField> fitted_once(const HoleSite& site, const ImplicitOptions& options, const RimFitOptions& how);

}  // namespace croquis::hole_filling
