// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "croquis/geometry/vector.h"

namespace croquis {

/// Appends the ids that a word stands for: "7", or "3-5" for 3, 4 and 5.
/// @return false, nothing appended, for any other word, ranges that descend or hold more than ten million ids
bool append_hole_ids(std::string_view word, std::vector<Index>& ids);

/// Ids of holes: numbers and ranges ("0,3-5"), separated by commas, semicolons or spaces. Ascending, each once.
/// @throws Error (E_PARAMETER) naming every part that is neither
std::vector<Index> parse_hole_ids(const std::string& text);

/// The shortest text of these ids, in their order: "5-7,2".
std::string hole_ids_text(const std::vector<Index>& ids, char separator);

}  // namespace croquis
