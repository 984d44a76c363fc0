// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "croquis/geometry/drawing.h"
#include "croquis/geometry/vector.h"
#include "croquis/tools/silhouette/stroke_edit.h"
#include "croquis/tools/strokes/stroke_source.h"

namespace croquis {

/// Moves the samples near the first one so that it lies on `place`; the movement fades out smoothly over `run`, an arc
/// length.
template <typename Iterator>
void bend_end(Iterator first, Iterator last, const Vec2& place, double run) {
  const Vec2 shift = place - first->position;
  Vec2 before = first->position;
  double length = 0;
  for (Iterator sample = first; sample != last; ++sample) {
    const Vec2 drawn = sample->position;
    length += (drawn - before).norm();
    before = drawn;
    const double t = run > 0 ? length / run : (length > 0 ? 1 : 0);
    if (t >= 1) return;
    sample->position += (1 - t * t * (3 - 2 * t)) * shift;
  }
}

struct RedrawLimits {
  double distance = 10;  ///< sketch units, how near both ends of the new stroke run to the old one
  double degrees = 35;   ///< how much they may differ in direction there
};

struct Redrawn {
  std::vector<StrokeSample> samples;  ///< of the old stroke, a part of them replaced
  double distance = 0;                ///< of the new ends to the old stroke, summed
};

/// The old stroke with the part between the new stroke's ends replaced by the new one, or nothing when the new stroke
/// is no correction of it: both ends must run along the old stroke, in one sense. A line that ends on another from the
/// side (a limb that goes behind a body) doesn't. Samples that are kept keep every bit; the new ones are shifted onto
/// the old line near their ends, and their times fitted in between.
/// O(samples of the old stroke + samples of the new one).
std::optional<Redrawn> redraw(const Stroke& old, const Stroke& drawn, const RedrawLimits& limits);

/// Lets the ends of open strokes that rest on a changed stroke follow it: each goes to the place that it rested on, and
/// the last piece of its stroke bends smoothly. A stroke that rests on what changed with both ends is moved as far as
/// both go the same way. What follows may have ends resting on itself: these follow as well.
///
/// An end rests on the stroke that it is nearest to, within 12 pixels of the view it was drawn in.
/// @param before the drawing before the edit
/// @param edit its changed strokes have as many samples as before; strokes that followed are added to them
void let_ends_follow(const Drawing& before, DrawingEdit& edit);

}  // namespace croquis
