// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/base/report.h"
#include "croquis/geometry/drawing.h"
#include "croquis/operators/inflate_result.h"
#include "croquis/silhouette/labelled_figure.h"
#include "croquis/silhouette/solid.h"

namespace croquis {

/// What is known of a drawing and its solid after all stages.
InflateResult result_of_inflating(const Drawing& drawing, const silhouette::LabelledDrawing& labelled,
                                  const silhouette::Solid& solid);

/// The figures of every stage. Places are in the sketch's own frame, y down.
Report to_report(const InflateResult& result);

/// One stroke per arc, hidden ones included; data: "contour", "depth", "object" (its name) and "visible" ("true" or
/// "false").
/// @param arcs labels of all arcs, in the order of the figures
Drawing label_drawing(const Drawing& drawing, const silhouette::LabelledDrawing& labelled,
                      const std::vector<ArcLabel>& arcs);

}  // namespace croquis
