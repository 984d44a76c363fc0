// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>
#include <tuple>
#include <vector>

#include "croquis/base/members.h"
#include "croquis/base/parameter.h"
#include "croquis/operators/subdivide_result.h"
#include "croquis/subdivision/rules.h"

namespace croquis {

/// What decides, with the cage, how it is refined.
struct PlanSettings {
  SubdivisionScheme scheme = SubdivisionScheme::DooSabin;
  subdivision::Rules rules;
  int levels = 2;
};
constexpr auto members(const PlanSettings& settings) {
  return std::tie(settings.scheme, settings.rules, settings.levels);
}
static_assert(lists_every_member<PlanSettings>);

/// The parameters of `subdivide`, parsed.
struct SubdivideSettings {
  PlanSettings plan;
  double sharp_angle = 0;                ///< radians; 0 tags nothing
  double keep_kinks = std::numbers::pi;  ///< radians; chains keep corners where they turn by more
  bool limit = false;                    ///< vertices are moved to where they end
  bool provenance = false;               ///< the result lists what its elements come from
};

std::vector<ParameterDescription> subdivide_parameters();

/// @param parameters complete (see croquis::complete)
SubdivideSettings read_subdivide_settings(const ParameterValues& parameters);

}  // namespace croquis
