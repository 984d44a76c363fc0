// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/base/finding.h"

namespace croquis {

/// The answer of every program of Croquis to its caller.
enum ExitCode : int {
  exit_done = 0,
  exit_warnings = 1,  ///< done, with warnings under --strict
  exit_usage = 2,
  exit_malformed = 3,
  exit_no_result = 4,
  exit_limit = 5,
  exit_cannot_write = 6,
  exit_internal = 70,
  exit_interrupted = 130
};

inline ExitCode exit_code_of(Category category) {
  switch (category) {
    case Category::Malformed: return exit_malformed;
    case Category::Geometry: return exit_no_result;
    case Category::Limit: return exit_limit;
    case Category::Io: return exit_cannot_write;
    case Category::Usage: return exit_usage;
    case Category::Internal: return exit_internal;
  }
  return exit_internal;
}

}  // namespace croquis
