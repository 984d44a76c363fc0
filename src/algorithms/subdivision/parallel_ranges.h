// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <system_error>
#include <thread>
#include <vector>

namespace croquis::subdivision {

/// Calls work(begin, end) for consecutive parts of 0 … count, one per thread. For work of which each item writes its
/// own result: then the number of threads changes no bit.
/// @param least items that are worth a thread
template <typename Work>
void parallel_ranges(std::size_t count, int threads, std::size_t least, const Work& work) {
  const std::size_t parts = std::clamp<std::size_t>(count / least, 1, static_cast<std::size_t>(std::max(threads, 1)));
  std::vector<std::jthread> others;
  for (std::size_t part = 1; part < parts; ++part) {
    const auto compute = [&, part] { work(count * part / parts, count * (part + 1) / parts); };
    try {
      others.emplace_back(compute);
    } catch (const std::system_error&) {
      compute();  // the system gives no more threads
    }
  }
  work(std::size_t{0}, count / parts);
}

}  // namespace croquis::subdivision
