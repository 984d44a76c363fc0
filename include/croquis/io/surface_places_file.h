// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "croquis/base/finding.h"
#include "croquis/base/report.h"
#include "croquis/geometry/attribute_network.h"

/// Places of faces at which a surface is to be evaluated, in the format croquis-abs-places/1, which is JSON once it is
/// written:
///
///     {"format": "croquis-abs-places/1", "places": [{"face": TEXT, "fan": [CORNER, A, B]}]}
namespace croquis {

struct SurfacePlaceQuestion {
  std::string face;
  FanPlace fan;

  friend bool operator==(const SurfacePlaceQuestion&, const SurfacePlaceQuestion&) = default;
};

Report report_of(const std::vector<SurfacePlaceQuestion>& places);

/// [corner, a, b], as files and reports have a place.
Report report_of(const FanPlace& fan);

struct SurfacePlacesReadResult {
  std::vector<SurfacePlaceQuestion> places;
  Findings warnings;  ///< W_IGNORED, for each name of a member that the format doesn't have
};

/// Reads places; whether a network has them is not looked at.
/// @throws Error Malformed, all findings together (at most 100), each naming its place (such as `places[3]`): E_SYNTAX
///         for another format and for what isn't of this one, E_NOT_FINITE
SurfacePlacesReadResult read_surface_places(const Report& report);

}  // namespace croquis
