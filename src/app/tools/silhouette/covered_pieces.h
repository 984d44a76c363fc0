// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "croquis/document/evaluation.h"
#include "croquis/geometry/drawing.h"

/// What is covered of strokes that are drawn through behind others.
namespace croquis::app {

/// Of a solid's result: the strokes that lie behind others which they cross in full view, and the hidden contours.
struct CoveredStrokes {
  std::vector<std::string> ids;
  std::vector<std::vector<Vec2>> hidden;  ///< polylines, sketch units
  double reach = 0;                       ///< how far a covered line may lie from its contour, which is smoothed
};

/// None for a result that isn't there, or has failed.
CoveredStrokes covered_strokes(const Evaluation* solid);

/// Whether each sample of a stroke is covered; empty where none is.
std::vector<bool> covered_samples(const Stroke& stroke, const CoveredStrokes& covered);

}  // namespace croquis::app
