// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/tools/silhouette/stroke_edit.h"

/// Drawings that are symmetric: what is done on one side of a vertical line is done on the other one, too.
namespace croquis {

/// The edit with what it did to strokes that have a "mirror" (stroke_data.h) done on the other side. A stroke that lies
/// on one side gets a twin there. One that reaches the line is cut there, and its longer part is completed by that
/// part's mirror image, so that it is closed where both its ends come to the line. A closed stroke of that kind that is
/// opened is no longer symmetric. Ends go to the line from within 12 pixels of the view that they were drawn in.
DrawingEdit on_both_sides(const Drawing& before, DrawingEdit edit);

}  // namespace croquis
