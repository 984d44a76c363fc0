// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace croquis::test {

/// The most bytes that `new` gave out at a time since this was made, above what was out then. Counts the whole program:
/// one at a time.
class AllocationPeak {
 public:
  AllocationPeak();
  std::size_t bytes() const;

 private:
  std::ptrdiff_t before_;
};

}  // namespace croquis::test
