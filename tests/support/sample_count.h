// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>

namespace croquis::test {

/// How many random inputs a test tries: `usual`, or `full` when CROQUIS_FULL is set (scripts/test --full).
inline int sample_count(int usual, int full) {
  const char* wanted = std::getenv("CROQUIS_FULL");
  return wanted != nullptr && *wanted != '\0' ? full : usual;
}

}  // namespace croquis::test
