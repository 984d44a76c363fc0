// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <ctime>
#include <vector>

namespace croquis::bench {

/// Processor time of a call, in milliseconds.
template <typename Work>
double cpu_ms(Work&& work) {
  const std::clock_t began = std::clock();
  work();
  return 1e3 * static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC;
}

/// The median of `runs` calls after one that isn't counted. Processor time, not the clock's: everything measured has
/// one thread, and a busy machine stretches long runs more than short ones.
template <typename Work>
double median_cpu_ms(int runs, Work&& work) {
  work();
  std::vector<double> times;
  for (int run = 0; run < runs; ++run) times.push_back(cpu_ms(work));
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

}  // namespace croquis::bench
