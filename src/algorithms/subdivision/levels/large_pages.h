// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace croquis::subdivision {

/// The size of a large page on the machines we build for.
inline constexpr std::size_t large_page = std::size_t{2} << 20;

/// Asks the system for large pages in memory that is still untouched; where it refuses pages are small.
void wish_large_pages(void* block, std::size_t bytes);

}  // namespace croquis::subdivision
