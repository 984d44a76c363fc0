// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "croquis/geometry/drawing.h"
#include "croquis/operators/inflate_result.h"

/// Readings of outlines that people may change: hole or part, in front or behind. They follow what the drawing says
/// now, which may be newer than the result.
namespace croquis::app {

/// The inner outlines of strokes that are still there.
std::vector<NestedStroke> nested_outlines(const InflateResult& inflated, const Drawing& drawing);

/// The pairs of strokes that cross in full view and are still there, each once.
std::vector<StrokesInView> crossings_in_view(const InflateResult& inflated, const Drawing& drawing);

/// What a stroke was read as.
struct ReadStroke {
  std::string stroke;
  silhouette::StrokeKind kind = silhouette::StrokeKind::Contour;
  bool chosen = false;  ///< by the drawing
  Vec2 at = Vec2::Zero();
};

/// Strokes that are no plain outlines, as long as they are few, and those that are selected.
std::vector<ReadStroke> read_strokes(const InflateResult& inflated, const Drawing& drawing,
                                     const std::vector<std::string>& selected);

/// The part that the selected strokes belong to; its thickness is set at the first of its strokes.
struct ChosenPart {
  std::string stroke;
  std::string object;      ///< its name in the result
  Vec2 at = Vec2::Zero();  ///< the middle of its upper border, sketch units
};

/// Nothing where strokes of several parts are selected, or of none: then `stroke` is empty.
ChosenPart chosen_part(const InflateResult& inflated, const Drawing& drawing, const std::vector<std::string>& selected);

}  // namespace croquis::app
