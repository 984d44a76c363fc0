// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

namespace croquis::test {

/// The most bytes that `new` gave out at a time since this was made, above what was out then. Counts the whole program:
/// one at a time. Sanitizers have their own `new`: nothing is counted then.
class AllocationPeak {
 public:
  AllocationPeak();
  std::optional<std::size_t> bytes() const;

 private:
  std::ptrdiff_t before_;
};

}  // namespace croquis::test
