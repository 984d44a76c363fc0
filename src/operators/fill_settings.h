// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "croquis/base/parameter.h"
#include "croquis/hole_filling/fill_holes.h"

namespace croquis {

/// The words for Fairness and implicit::Kernel, the default first; `kernel` has "auto" before them: what the preset
/// says.
inline constexpr std::array<std::string_view, 3> fairness_names = {"rbf", "smooth", "flat"};
inline constexpr std::array<std::string_view, 4> kernel_names = {"hermite", "triharmonic", "biharmonic", "thin-plate"};

/// What the parameters of `fill` ask for.
struct FillSettings {
  hole_filling::FillOptions options;
  bool list_only = false;  ///< holes are looked at, none is filled
};

std::vector<ParameterDescription> fill_parameters();

/// @param parameters complete (see croquis::complete)
/// @throws Error (E_PARAMETER) for a list of ids, or wishes for single holes, that can't be read
FillSettings read_fill_settings(const ParameterValues& parameters);

}  // namespace croquis
