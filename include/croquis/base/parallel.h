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

}  // namespace croquis
