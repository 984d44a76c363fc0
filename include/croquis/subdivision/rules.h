// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tuple>

#include "croquis/base/members.h"

namespace croquis::subdivision {

/// The two sets of rules people choose between; they differ in positions alone, never in connectivity.
enum class Preset {
  Refined,  ///< round faces, uniform rows beside creases, smooth chain ends, exact B-spline boundaries
  Paper     ///< Lee, Joo, Hong 2002
};

/// How the corners of a face weigh in its new corners.
enum class Weights {
  Classical,  ///< Doo, Sabin 1978: own (n+5)/4n, others (3 + 2 cos(2πj/n))/4n
  Average     ///< mean of face point, two edge points and vertex; uneven shrinking unless n = 4
};

/// The rows of faces beside a crease.
enum class Profile {
  Clamped,  ///< halve at each level, as at the clamped end of a B-spline
  Plain     ///< shrink by 3/4 only: flat beside the crease
};

/// Where a chain of sharp edges ends inside a surface.
enum class ChainEnds {
  Smooth,   ///< runs out into the surface
  Retract,  ///< draws back to the middle of its last edge, leaving a kink
  Pin       ///< stays where it is
};

/// Boundary vertices with a single face.
enum class BoundaryCorners {
  Corner,  ///< stay where they are
  Smooth   ///< are rounded like the rest of the boundary
};

struct Rules {
  Weights weights = Weights::Classical;
  Profile profile = Profile::Clamped;
  ChainEnds chain_ends = ChainEnds::Smooth;
  BoundaryCorners boundary_corners = BoundaryCorners::Corner;

  static Rules of(Preset preset) {
    if (preset == Preset::Refined) return {};
    return {Weights::Average, Profile::Plain, ChainEnds::Retract, BoundaryCorners::Corner};
  }
};

constexpr auto members(const Rules& rules) {
  return std::tie(rules.weights, rules.profile, rules.chain_ends, rules.boundary_corners);
}

static_assert(lists_every_member<Rules>);

}  // namespace croquis::subdivision
