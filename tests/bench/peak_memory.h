// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>
#include <fstream>
#include <string>

#include <malloc.h>

namespace croquis::bench {

/// Watches how much memory this process holds (Linux).
class PeakMemory {
 public:
  PeakMemory() {
    malloc_trim(0);
    before_ = mebibytes("VmRSS:");
  }

  /// Peaks count from now on; `used` is still above what was held at the beginning.
  void restart() { std::ofstream("/proc/self/clear_refs") << "5"; }

  double used() const { return mebibytes("VmHWM:") - before_; }

  /// A line of the process's status in the kernel's words: "VmRSS:" is what it holds.
  static double mebibytes(const std::string& wanted) {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;) {
      double kibibytes = 0;
      if (word == wanted && status >> kibibytes) return kibibytes / 1024;
    }
    return 0;
  }

 private:
  double before_ = 0;
};

}  // namespace croquis::bench
