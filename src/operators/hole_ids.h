// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "croquis/geometry/vector.h"

namespace croquis {

/// Ids of holes: numbers and ranges ("0,3-5"), separated by commas, semicolons or spaces. Ascending, each once.
/// @throws Error (E_PARAMETER) naming every part that is neither
std::vector<Index> parse_hole_ids(const std::string& text);

}  // namespace croquis
