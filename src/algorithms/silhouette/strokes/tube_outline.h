// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "algorithms/silhouette/strokes/clean_line.h"
#include "croquis/geometry/drawing.h"
#include "croquis/silhouette/labelled_figure.h"

/// Tubes that are drawn as their centre lines (stroke_data.h), and how they pass over one another.
namespace croquis::silhouette {

/// A tip lies so many radii beyond the end of the centre line.
inline constexpr double tube_tip = 2;
/// Within so many radii a bend makes a loop on the tube's inner side; strands of one that are farther apart overlap.
inline constexpr double tube_loop_reach = 6;

/// The largest radius that a stroke gives; 0 where it is no centre line, or gives none that can be read.
double largest_radius(const Stroke& stroke);

/// Adds a stroke's centre line, smoothed so that no bend is much smaller than the tube is thick; one whose end comes
/// back to its beginning is closed. Says what is wrong where that can't be done (E_TUBE).
void add_centre_line(const Drawing& drawing, Index stroke, SampledDrawing& sampled);

/// The outlines of tubes: one closed line for each that has ends, two for each that is closed. Where a bend is narrower
/// than the tube the inner side has a corner in place of a loop. Lines may cross themselves and one another.
std::vector<CleanLine> outlines_of_tubes(const std::vector<CentreLine>& tubes, const DrawingScale& scale);

/// Two tubes, or two places of one, pass over one another.
struct TubePassing {
  TubeCrossing crossing;
  std::array<Index, 2> tube{};  ///< that of the lower place first
  std::array<double, 2> along{};
  std::array<double, 2> reach{};   ///< along either: their outlines cross no farther away
  std::array<double, 2> period{};  ///< length of a closed centre line; infinite for others
  bool first_over = true;          ///< the first of both lies in front
};

struct TubePassings {
  std::vector<TubePassing> all;
  LineFindings findings;  ///< E_TUBE where strands overlap side by side
};

/// Where the outlines of two tubes, or of one with itself, cross.
struct PassingAt {
  Index passing = no_index;
  Index over = 0;  ///< which of the two places lies in front
};

/// @returns no passing where the two places belong to none
PassingAt passing_at(const std::vector<TubePassing>& passings, const TubePlace& a, const TubePlace& b);

/// Where tubes pass over one another, and which one lies in front there: at crossings of a tube with itself it comes
/// over and under by turns, of two tubes the later one is in front; "over" and "behind" of the strokes say otherwise.
/// @param lines among them the outlines of the tubes
TubePassings find_passings(const Drawing& drawing, const std::vector<CentreLine>& tubes,
                           const std::vector<CleanLine>& lines, const DrawingScale& scale);

}  // namespace croquis::silhouette
