// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "croquis/base/parameter.h"
#include "croquis/hole_filling/fill_holes.h"

namespace croquis {

/// What the parameters of `fill` ask for.
struct FillSettings {
  hole_filling::FillOptions options;
  bool list_only = false;  ///< holes are looked at, none is filled
};

std::vector<ParameterDescription> fill_parameters();

/// @param parameters complete (see croquis::complete)
/// @throws Error (E_PARAMETER) for a list of ids that can't be read
FillSettings read_fill_settings(const ParameterValues& parameters);

/// Ids of holes: numbers and ranges ("0,3-5"), separated by commas, semicolons or spaces. Ascending, each once.
/// @throws Error (E_PARAMETER) naming every part that is neither
std::vector<Index> parse_hole_ids(const std::string& text);

}  // namespace croquis
