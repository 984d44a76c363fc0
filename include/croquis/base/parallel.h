// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

#include "croquis/base/progress.h"

namespace croquis {

/// Calls work(begin, end) for parts of [0, count) of `grain` elements, on several threads, and waits for all.
///
/// The calling thread works too, and alone reports progress, to 1 at the end. What a part throws ends the whole; when
/// several throw, the lowest part's exception is passed on. Parts must not share what they write.
/// @param threads 0: as many as the machine has
/// @throws Cancelled, and whatever work throws
void for_each_part(std::size_t count, std::size_t grain, int threads, Progress& progress,
                   const std::function<void(std::size_t begin, std::size_t end)>& work);

/// The same for short work that is neither shown nor cancelled.
void for_each_part(std::size_t count, std::size_t grain, int threads,
                   const std::function<void(std::size_t begin, std::size_t end)>& work);

/// How many threads that number stands for: 0 for all of the machine's. At least 1, at most 256.
std::size_t thread_count(int threads);

/// The grain that gives every thread one part, for work whose elements all take about as long.
/// @param least elements that are worth a thread of their own, at least 1
std::size_t even_grain(std::size_t count, int threads, std::size_t least);

}  // namespace croquis
