// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "croquis/base/parallel.h"

namespace croquis {

/// Threads that a query may use: all of the machine's, up to a few.
inline int query_threads() {
  constexpr std::size_t most_query_threads = 8;
  return static_cast<int>(std::min(thread_count(0), most_query_threads));
}

}  // namespace croquis
