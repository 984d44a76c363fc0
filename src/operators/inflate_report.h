// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/base/report.h"
#include "croquis/geometry/drawing.h"
#include "croquis/silhouette/labelled_figure.h"
#include "croquis/silhouette/solid.h"

namespace croquis {

/// The figures of every stage. Places are in the sketch's own frame, y down.
Report inflate_details(const Drawing& drawing, const silhouette::LabelledDrawing& labelled,
                       const silhouette::Solid& solid);

/// One stroke per arc, hidden ones included; data: "contour", "depth", "object" (its name) and "visible" ("true" or
/// "false").
Drawing label_drawing(const Drawing& drawing, const silhouette::LabelledDrawing& labelled);

}  // namespace croquis
