// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "croquis/base/finding.h"
#include "croquis/base/parameter_list.h"
#include "croquis/remeshing/remesh.h"

namespace croquis {

/// The words for Selection, Fairness and implicit::Kernel, the default first.
inline constexpr std::array<std::string_view, 4> selection_names = {"inner", "all", "all-but-largest", "none"};
inline constexpr std::array<std::string_view, 3> fairness_names = {"rbf", "smooth", "flat"};
inline constexpr std::array fairnesses = {hole_filling::Fairness::Implicit, hole_filling::Fairness::Tangent,
                                          hole_filling::Fairness::Flat};
inline constexpr std::array<std::string_view, 4> kernel_names = {"hermite", "triharmonic", "biharmonic", "thin-plate"};

/// What people set of `fill`.
struct FillSettings {
  remeshing::RemeshOptions options;                  ///< of both modes: patches go by options.fill alone
  bool remesh = false;                               ///< the whole model is remeshed
  bool list_only = false;                            ///< holes are looked at, none is filled
  std::optional<double> max_diameter, memory_limit;  ///< model units, MiB
};

void list_fill_parameters(FillSettings& settings, ParameterList& list);

/// The settings with what follows from the mode.
/// @param parameters complete (see croquis::complete)
/// @throws Error (E_PARAMETER) for a list of ids, requests for single holes or a range of points that can't be read
FillSettings read_fill_settings(const ParameterValues& parameters);

/// At most one W_PARAMETER_UNUSED: parameters that are given and that the mode doesn't look at.
Findings unused_parameters(const ParameterValues& parameters);

}  // namespace croquis
