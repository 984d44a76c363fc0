// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <tuple>

#include "croquis/base/members.h"
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

}  // namespace croquis::hole_filling
