// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "croquis/base/finding.h"
#include "croquis/base/parameter.h"
#include "croquis/remeshing/remesh.h"

namespace croquis {

/// The words for Selection, Fairness and implicit::Kernel, the default first.
inline constexpr std::array<std::string_view, 4> selection_names = {"inner", "all", "all-but-largest", "none"};
inline constexpr std::array<std::string_view, 3> fairness_names = {"rbf", "smooth", "flat"};
inline constexpr std::array<std::string_view, 4> kernel_names = {"hermite", "triharmonic", "biharmonic", "thin-plate"};

/// The parameters of `fill`, parsed.
struct FillSettings {
  remeshing::RemeshOptions options;  ///< of both modes: patches go by options.fill alone
  bool remesh = false;               ///< the whole model is remeshed
  bool list_only = false;            ///< holes are looked at, none is filled
  Findings warnings;                 ///< W_PARAMETER_UNUSED
};

std::vector<ParameterDescription> fill_parameters();

/// @param parameters complete (see croquis::complete)
/// @throws Error (E_PARAMETER) for a list of ids, wishes for single holes or a range of points that can't be read
FillSettings read_fill_settings(const ParameterValues& parameters);

}  // namespace croquis
