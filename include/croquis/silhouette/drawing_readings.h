// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "croquis/base/progress.h"
#include "croquis/geometry/drawing.h"
#include "croquis/silhouette/labelled_figure.h"
#include "croquis/silhouette/options.h"

/// A drawing whose parts hide one another may be read in more than one way.
namespace croquis::silhouette {

/// One way to read a drawing.
struct DrawingReading {
  Drawing drawing;                   ///< the same strokes; their data says what differs, see stroke_data.h
  double cost = 0;                   ///< how much more it supposes than the first one; dimensionless
  std::vector<std::string> differs;  ///< from the first one, one sentence each
};

/// The readings of a drawing from the likeliest on: the first is the drawing's own. Each of the others comes from one
/// before it by one change: a stroke has another kind, hidden ends are joined in another way, or another part lies in
/// front. What a stroke says already stays. Readings differ in kinds, joined ends, orders or Euler numbers, and have no
/// more errors than the first one.
///
/// Which one is next doesn't depend on how many are asked for: what is tried is bounded by counts alone.
class DrawingReadings {
 public:
  /// @param options without swaps and cache
  DrawingReadings(Drawing drawing, Options options);
  ~DrawingReadings();
  DrawingReadings(DrawingReadings&&) noexcept;

  /// Whoever asks computes the solid: a reading without one is none.
  /// @returns none when there are no more, or so many were tried that it isn't worth more
  /// @throws Error when the first one can't be labelled; Cancelled
  std::optional<DrawingReading> next(Progress& progress);

 private:
  class Search;
  std::unique_ptr<Search> search_;
};

}  // namespace croquis::silhouette
