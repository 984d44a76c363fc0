// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/tools/silhouette/stroke_edit.h"

namespace croquis {

/// Lets the ends of open strokes that rest on a changed stroke follow it: each goes to the place that it rested on, and
/// the last piece of its stroke bends smoothly. A stroke that rests on what changed with both ends is moved as far as
/// both go the same way. What follows may have ends resting on itself: these follow as well.
///
/// An end rests on the stroke that it is nearest to, within 12 pixels of the view it was drawn in.
/// @param before the drawing before the edit
/// @param edit its changed strokes have as many samples as before; strokes that followed are added to them
void let_ends_follow(const Drawing& before, DrawingEdit& edit);

}  // namespace croquis
