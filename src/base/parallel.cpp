// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <limits>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace croquis {
namespace {

constexpr std::size_t most_threads = 256;

/// The parts of one call. Parts are taken in ascending order: whatever lies below a part that failed was begun before
/// it and is finished, so that the lowest failure is the same for any number of threads.
class Parts {
 public:
  Parts(std::size_t count, std::size_t grain, const Progress& progress,
        const std::function<void(std::size_t, std::size_t)>& work)
      : count_(count), grain_(grain), progress_(progress), work_(work) {}

  /// False when there is none left.
  bool run_next() {
    const std::size_t begin = next_.fetch_add(grain_);
    if (begin >= count_ || stopped_.load() || progress_.cancelled()) return false;
    try {
      work_(begin, std::min(begin + grain_, count_));
    } catch (...) {
      stop();
      const std::lock_guard lock(mutex_);
      if (begin < failed_) failed_ = begin, failure_ = std::current_exception();
    }
    return true;
  }

  void stop() { stopped_.store(true); }
  double fraction() const { return static_cast<double>(std::min(next_.load(), count_)) / static_cast<double>(count_); }
  bool stopped() const { return stopped_.load(); }

  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  const std::size_t count_;
  const std::size_t grain_;
  const Progress& progress_;
  const std::function<void(std::size_t, std::size_t)>& work_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<bool> stopped_ = false;
  std::mutex mutex_;
  std::size_t failed_ = std::numeric_limits<std::size_t>::max();
  std::exception_ptr failure_;
};

/// A machine that gives fewer threads than asked for is slower, not wrong.
std::vector<std::jthread> start_helpers(std::size_t count, Parts& parts) {
  std::vector<std::jthread> helpers;
  try {
    for (std::size_t i = 0; i < count; ++i)
      helpers.emplace_back([&parts] {
        while (parts.run_next()) {
        }
      });
  } catch (const std::system_error&) {
  }
  return helpers;
}

}  // namespace

std::size_t thread_count(int threads) {
  if (threads > 0) return std::min(static_cast<std::size_t>(threads), most_threads);
  static const std::size_t all = std::max(1U, std::thread::hardware_concurrency());  // it reads a file
  return std::min(all, most_threads);
}

std::size_t even_grain(std::size_t count, int threads, std::size_t least) {
  const std::size_t parts = std::clamp<std::size_t>(count / least, 1, thread_count(threads));
  return std::max<std::size_t>(1, (count + parts - 1) / parts);
}

void for_each_part(std::size_t count, std::size_t grain, int threads, Progress& progress,
                   const std::function<void(std::size_t, std::size_t)>& work) {
  progress.check();
  if (count == 0) return;
  Parts parts(count, grain, progress, work);
  const std::size_t part_count = (count + grain - 1) / grain;
  {
    const auto helpers = start_helpers(std::min(thread_count(threads), part_count) - 1, parts);
    try {
      while (!parts.stopped() && parts.run_next()) progress.report(parts.fraction());
    } catch (...) {
      parts.stop();
      throw;
    }
  }
  parts.rethrow();
  progress.report(1);
}

void for_each_part(std::size_t count, std::size_t grain, int threads,
                   const std::function<void(std::size_t, std::size_t)>& work) {
  Progress silent;
  for_each_part(count, grain, threads, silent, work);
}

}  // namespace croquis
