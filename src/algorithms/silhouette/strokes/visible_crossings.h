// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "algorithms/silhouette/strokes/clean_line.h"
#include "algorithms/silhouette/strokes/tube_outline.h"
#include "croquis/base/progress.h"
#include "croquis/geometry/drawing.h"
#include "croquis/silhouette/labelled_figure.h"

/// Outlines beside, within and across one another.
namespace croquis::silhouette {

/// Whether a closed outline within another looks like the hole of a ring, rather than like a part that lies in front.
///
/// Holes are what rings of even width go round, along most of the outline. The thicker the ring for its hole, the more
/// do other things speak for a part: a belly or an eye on a body rather than a ring.
/// O(#inner + 64 #outer).
/// @param things what covers the outer outline or is covered by it, and what else lies within it
bool is_hole_of_ring(const Points& inner, const Points& outer, std::size_t things);

/// Whether the "kind" of an outline's strokes says that it bounds a hole; none where it says nothing of it.
/// @param strokes indices into Drawing::strokes
std::optional<bool> hole_by_kind(const Drawing& drawing, const std::vector<Index>& strokes);

/// Whether one of some strokes is set to lie behind one of others, by its id.
bool is_set_behind(const Drawing& drawing, const std::vector<Index>& strokes, const std::vector<Index>& others);

/// Leads closed lines into larger ones that they lie beside, no farther than hands miss by, where nothing ends
/// at them or crosses them: a head that was drawn next to its body grows out of it. Lines that lie within others stay,
/// and so do all where tolerances don't go by size. O(n) for evenly spread samples.
void lead_into_neighbours(std::vector<CleanLine>& lines, const DrawingScale& scale);

struct VisibleCrossings {
  std::set<std::pair<Index, Index>> in_front;  ///< pairs of lines that cross; the first one lies in front
  std::set<Index> behind;                      ///< the second ones of these pairs, and outlines of tubes
  std::vector<int> sides;                      ///< per line in front: its surface is on the left (+1) or right (-1)
  std::vector<TubePassing> passings;           ///< of tubes with centre lines
  std::vector<CrossingInView> pairs;           ///< but of lines that grow out of one another, and holes
  Findings findings;                           ///< W_CROSS for every pair
};

/// Reads lines that cross in full view, as two full circles over one another do: one of them passes behind.
///
/// Of two closed lines the one drawn later is in front, unless its strokes say that it lies behind (stroke_data.h). A
/// closed line covers an open one. Two open lines, and a line that crosses itself, stay as they are: nothing says which
/// part is in front. Where two lines nearly touch, an unsteady hand makes them cross several times, or not at all: the
/// one behind is moved there, so that what is left are crossings that were meant.
/// @param tubes_only other lines that cross stay as they are
/// @param lines     ends that pass behind something lie on it; moved where they nearly touch
VisibleCrossings order_visible_crossings(const Drawing& drawing, std::vector<CleanLine>& lines,
                                         const DrawingScale& scale, bool tubes_only, const Progress& progress);

/// The end of a line (the stem) that stops where another one (the bar) passes in front: a T-junction.
struct HiddenEnd {
  Index line = 0;
  bool at_start = false;
  Index bar = 0;
  double bar_parameter = 0;     ///< place on the bar's samples
  Vec2 at = Vec2::Zero();       ///< on the bar
  Vec2 tangent = Vec2::Zero();  ///< outward, unit: into the bar's surface
  int bar_side = 1;             ///< the bar's surface lies on its left (+1) or right (-1)
};

/// A piece of contour between two ends that is known though it is hidden.
struct GivenPiece {
  Index from = 0;  ///< positions in Junctions::ends
  Index to = 0;
  Points points;
  Index stroke = 0;
};

struct Junctions {
  std::vector<HiddenEnd> ends;  ///< by line, its start first
  std::vector<int> sides;       ///< per line: surface on its left (+1), right (-1), or not given by any stem (0)
  std::vector<GivenPiece> given;
  double jitter = 0;      ///< of the hand, see `jitter_of`
  LineFindings findings;  ///< E_NO_LABELLING, E_CROSS, E_TOUCH; E_HIDDEN_STROKE of those that join no two ends
};

/// Trims or extends the lines to what their ends pass behind; targets then lie where lines end.
void meet_bars(std::vector<CleanLine>& lines, const DrawingScale& scale);

/// What every open end passes behind, and where the surfaces of bars lie (Cordier, Seo, Cho 2006, section 3; the side
/// rule is Williams 1994).
/// @param lines  have met their bars and end on them; they are carried on a little past them
/// @param hidden strokes of kind "hidden" (stroke_data.h): each is the hidden contour between the two ends that are
/// nearest to its own, and is moved so that it begins and ends there
Junctions find_junctions(const Drawing& drawing, std::vector<CleanLine>& lines,
                         const std::vector<SampledStroke>& hidden, const VisibleCrossings& order,
                         const DrawingScale& scale, const Progress& progress);

}  // namespace croquis::silhouette
