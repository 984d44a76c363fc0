// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/run_limits.h"

#include <algorithm>
#include <chrono>
#include <csignal>

#include <sys/resource.h>

namespace croquis::cli {
namespace {

// A signal handler may touch nothing but this.
volatile std::sig_atomic_t interrupted = 0;

extern "C" void note_interrupt(int signal) {
  interrupted = 1;
  std::signal(signal, SIG_DFL);  // a second Ctrl-C ends the process at once
}

constexpr auto poll_interval = std::chrono::milliseconds(20);

void limit_address_space(std::int64_t bytes) {
  rlimit limit{};
  getrlimit(RLIMIT_AS, &limit);
  limit.rlim_cur = std::min(static_cast<rlim_t>(bytes), limit.rlim_max);
  setrlimit(RLIMIT_AS, &limit);
}

}  // namespace

RunLimits::RunLimits(double timeout, std::int64_t memory_limit) {
  interrupted = 0;
  std::signal(SIGINT, note_interrupt);
  std::signal(SIGTERM, note_interrupt);
  watcher_ = std::thread([this, timeout] { watch(timeout); });
  if (memory_limit > 0) limit_address_space(memory_limit);
}

RunLimits::~RunLimits() {
  {
    const std::lock_guard lock(mutex_);
    done_ = true;
  }
  finished_.notify_all();
  watcher_.join();
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

StopReason RunLimits::reason() const { return reason_.load(); }

void RunLimits::watch(double timeout) {
  const auto began = std::chrono::steady_clock::now();
  std::unique_lock lock(mutex_);
  while (!finished_.wait_for(lock, poll_interval, [this] { return done_; })) {
    const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    if (interrupted != 0) {
      reason_ = StopReason::Interrupted;
    } else if (timeout > 0 && elapsed >= timeout) {
      reason_ = StopReason::TimedOut;
    } else {
      continue;
    }
    cancel_ = true;
    return;
  }
}

}  // namespace croquis::cli
