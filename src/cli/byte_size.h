// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

namespace croquis::cli {

/// "512M", "2G", "1.5GiB", "1000000": a number of bytes, with K, M, G or T as powers of 1024.
/// @throws Error (E_PARAMETER, Category::Usage)
std::int64_t parse_byte_size(const std::string& text);

}  // namespace croquis::cli
