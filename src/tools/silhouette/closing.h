// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "croquis/tools/silhouette/stroke_edit.h"

namespace croquis {

/// The samples from `first` to `last` (both kept) make the loop that was meant.
struct Closing {
  std::size_t first = 0;
  std::size_t last = 0;
};

/// How a drawn stroke closes, if its ends meet (see ends_meet). A pen seldom stops where it began: what overshoots is
/// left out, so that the loop neither crosses itself at the seam nor folds back, and no more of it than that takes.
/// O(samples); the search at the seam is bounded by a count.
std::optional<Closing> find_closing(std::span<const StrokeSample> samples, const CloseOptions& options);

/// Whether an outline stops and goes on where other strokes pass before it: then it stays open, however near its ends
/// are. Something passes between them, or both rest on other strokes, farther from each other than ends that close by
/// themselves. O(samples of the drawing).
bool passes_behind(const Drawing& drawing, std::span<const StrokeSample> samples, const CloseOptions& options);

}  // namespace croquis
