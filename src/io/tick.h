// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "croquis/base/progress.h"

namespace croquis {

/// Called for every element written; looks now and then whether to stop.
class WriteTick {
 public:
  explicit WriteTick(const Progress& progress) : progress_(progress) {}

  /// @throws Cancelled
  void operator()() {
    if (++count_ % (std::size_t{1} << 16) == 0) progress_.check();
  }

 private:
  const Progress& progress_;
  std::size_t count_ = 0;
};

}  // namespace croquis
