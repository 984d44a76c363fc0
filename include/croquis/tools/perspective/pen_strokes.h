// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "croquis/tools/perspective/sheet_units.h"

namespace croquis {

struct PenStrokeOptions {
  double units_per_pixel = 1;                ///< px of the sheet per pixel of the view drawn in, > 0
  double snap_pixels = 14;                   ///< of the view: an end this near to a vertex goes to it
  std::optional<StrokeGroup> group;          ///< none: by where it points
  StrokeGroup plane = StrokeGroup::Unknown;  ///< for what points along no axis and could be in several planes
  std::vector<StrokeGroup> groups;           ///< without a group: of each stroke, known before; empty: guessed
  StrokeRole role = StrokeRole::Edge;
  const SolvedDrawing* solved = nullptr;
};

/// Adds what a gesture of the pen was meant as: see shapes_of. Ends of edges near a vertex go to it.
/// @param places #P by 2, px of the sheet, finite
/// @return ids of the strokes added; empty for a tap
std::vector<std::string> draw_strokes(PerspectiveDrawing& drawing, std::span<const Vec2> places,
                                      const PenStrokeOptions& options);

}  // namespace croquis
