// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "croquis/base/progress.h"

namespace croquis::hole_filling {

/// Looks at the cancel flag once in so many steps of a cheap loop.
class CancelCheck {
 public:
  explicit CancelCheck(const Progress& progress) : progress_(progress) {}

  /// @throws Cancelled
  void step() {
    if (++steps_ % interval == 0) progress_.check();
  }

 private:
  static constexpr std::size_t interval = 1 << 16;  ///< some milliseconds of linear work

  const Progress& progress_;
  std::size_t steps_ = 0;
};

}  // namespace croquis::hole_filling
