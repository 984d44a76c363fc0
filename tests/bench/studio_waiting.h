// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "bench/window_watch.h"

namespace croquis::bench {

/// Prints how long the window's thread takes no event while somebody works at human speed.
void bench_waiting(WatchedApplication& application);

/// Prints what the process holds after 400 and 800 random events: a process should do only this.
void bench_memory(std::uint64_t seed);

}  // namespace croquis::bench
