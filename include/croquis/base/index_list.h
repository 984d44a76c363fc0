// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// Lists of elements' numbers as people write them: "0,3-5".
namespace croquis {

/// Appends the numbers that a word stands for: "7", or "3-5" for 3, 4 and 5.
/// @return false, nothing appended, for any other word, and for ranges that descend or hold over ten million numbers
bool append_indices(std::string_view word, std::vector<std::uint32_t>& numbers);

/// The shortest text of these numbers, in their order: "5-7,2".
std::string index_list_text(const std::vector<std::uint32_t>& numbers, char separator);

}  // namespace croquis
