// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <system_error>
#include <thread>
#include <vector>

namespace croquis {

/// Threads that a query may use: all of the machine's, up to a few.
inline std::size_t usable_threads() {
  constexpr std::size_t most_threads = 8;
  return std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, most_threads);
}

/// Divides a range among threads, in blocks. For work whose results depend on the element alone.
/// @param work called with [begin, end), from several threads at once; doesn't throw
template <typename Work>
void in_blocks(std::size_t count, std::size_t block, Work work) {
  std::atomic<std::size_t> next = 0;
  const auto run = [&] {
    for (std::size_t begin = next.fetch_add(block); begin < count; begin = next.fetch_add(block))
      work(begin, std::min(begin + block, count));
  };
  const std::size_t wanted = std::min(usable_threads(), (count + block - 1) / block);
  std::vector<std::thread> helpers;
  try {
    for (std::size_t i = 1; i < wanted; ++i) helpers.emplace_back(run);
  } catch (const std::system_error&) {
    // Without more threads this one does all.
  }
  run();
  for (std::thread& helper : helpers) helper.join();
}

}  // namespace croquis
