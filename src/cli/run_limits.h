// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>

namespace croquis::cli {

/// Why a run was stopped from outside.
enum class StopReason { None, Interrupted, TimedOut };

/// The bounds of one run: Ctrl-C, --timeout and --max-memory, all of which end it through one cancel flag (memory:
/// through std::bad_alloc). Only one may exist at a time, since signals belong to the process.
class RunLimits {
 public:
  /// @param timeout      seconds, 0 for none
  /// @param memory_limit bytes of address space, 0 for none
  RunLimits(double timeout, std::int64_t memory_limit);
  ~RunLimits();

  RunLimits(const RunLimits&) = delete;
  RunLimits& operator=(const RunLimits&) = delete;

  const std::atomic<bool>* cancel_flag() const { return &cancel_; }
  StopReason reason() const;

 private:
  void watch(double timeout);

  std::atomic<bool> cancel_{false};
  std::atomic<StopReason> reason_{StopReason::None};
  std::mutex mutex_;
  std::condition_variable finished_;
  bool done_ = false;
  std::thread watcher_;
};

}  // namespace croquis::cli
