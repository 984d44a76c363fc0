// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/silhouette/strokes/polyline.h"
#include "croquis/base/finding.h"
#include "croquis/geometry/drawing.h"
#include "croquis/silhouette/options.h"
#include "croquis/silhouette/stroke_data.h"

namespace croquis::silhouette {

/// The lengths of the drawing stage in sketch units.
struct DrawingScale {
  double unit = 1;  ///< u
  double step = 6;
  double close = 8;
  double gap = 18;
  double snap = 10;
  double close_share = 0;  ///< of a stroke's length
  double aside_share = 0;  ///< of a stroke's length
  double reach_share = 0;  ///< of a line's size
  double jitter = 0;       ///< see `jitter_of`; 0 where tolerances don't go by size

  /// How far an end may miss a line when the larger of the two has this size.
  double reach(double size) const { return std::max(snap, reach_share * size); }

  /// How far two lines, the smaller of this size, may come beyond one another without being meant to cross: some u, and
  /// a share of the size where the hand was as unsteady as can be.
  double shallow(double size) const { return std::max(2 * unit, 0.05 * jitter * size); }
};

/// A stroke sampled evenly.
struct SampledStroke {
  Points points;
  Index stroke = 0;    ///< index into Drawing::strokes
  std::string object;  ///< strokes of two named objects are never joined
  StrokeKind given_kind = StrokeKind::Visible;
  bool closed = false;
  double length = 0;
  double size = 0;  ///< see `size_of`
};

/// The centre line of a tube, smoothed and sampled evenly.
struct CentreLine {
  Points points;
  std::vector<double> radius;  ///< per point
  Index stroke = 0;            ///< index into Drawing::strokes
  std::string object;          ///< name of the object it was forced into, empty for none
  bool closed = false;
  TubeEnds ends = TubeEnds::Round;
};

/// A place of a tube.
struct TubePlace {
  Index tube = no_index;  ///< which centre line
  double along = 0;       ///< length from its first point
};

/// One stroke in a chain of joined strokes.
struct ChainLink {
  Index index = 0;  ///< into the sampled strokes
  bool reversed = false;
};

/// Strokes that together are one line.
struct StrokeChain {
  std::vector<ChainLink> links;  ///< in order along the line; the stroke drawn first keeps its direction
  bool closed = false;
};

/// Where the end of a line is to meet another one.
struct EndTarget {
  Index bar = 0;  ///< line
  Vec2 at = Vec2::Zero();
  double miss = 0;  ///< how far the end is from it
  int side = 1;     ///< the bar's surface lies on its left (+1) or right (-1)
};

/// One drawn line: a stroke, or several whose gaps were joined. A cleaned copy; the strokes stay as they are.
struct CleanLine {
  Points points;               ///< smoothed samples, about a step apart
  std::vector<Index> stroke;   ///< per point: index into Drawing::strokes
  std::vector<Index> strokes;  ///< in the order along the line
  Points raw;                  ///< per point: where it was before it was smoothed
  std::string object;          ///< name of the object it was forced into, empty for none
  bool closed = false;
  bool bridged = false;                             ///< closed over a gap that is more than what hands miss by
  bool tube = false;                                ///< the outline of limbs that were drawn as one line
  bool led = false;                                 ///< into a line that it lay beside
  Index centre_line = no_index;                     ///< of the outline of a tube with one
  std::vector<double> along;                        ///< of that: per point the place on the centre line
  int side = 0;                                     ///< of that: the surface lies left (+1) or right (-1)
  double size = 0;                                  ///< see `size_of`
  std::array<std::optional<EndTarget>, 2> targets;  ///< of its start and its end

  /// Out of what it crosses.
  bool grows() const { return tube || led; }
  TubePlace tube_place(Index point) const {
    return centre_line == no_index ? TubePlace() : TubePlace{centre_line, along[point]};
  }
  Index segment_count() const { return static_cast<Index>(closed ? points.size() : points.size() - 1); }
  const Vec2& end(bool at_start) const { return end_of(points, at_start); }
  Index end_stroke(bool at_start) const { return at_start ? stroke.front() : stroke.back(); }

  /// Calls change(list) for each list that has a value per point.
  template <typename Change>
  void change_samples(Change change) {
    change(points);
    change(stroke);
    if (!raw.empty()) change(raw);
  }
};

/// Something wrong with certain lines: their part of the drawing can't be labelled, others can.
struct LineFinding {
  Finding finding;
  std::vector<Index> lines;
};

using LineFindings = std::vector<LineFinding>;

/// The line that a chain of strokes makes, not smoothed yet. What runs on beyond the place where the next stroke (or
/// the first one again) goes on is cut off; ends that lie aside of one another are bent to meet when the drawing's
/// scale has an aside_share.
CleanLine join_chain(const StrokeChain& chain, const std::vector<SampledStroke>& strokes, const DrawingScale& scale);

/// How unsteady the hand was that drew some lines, from 0 (not more than bends explain) to 1 (the direction of a short
/// piece means nothing). Judged by the fourth differences of places a twelfth of a line's size apart, which cubic
/// curves don't have: the median over a line, as a share of its size, and the lower quartile of the lines by length.
double jitter_of(const std::vector<CleanLine>& lines, double step);

/// Outward unit direction in which an open line ends. Of lines drawn by an unsteady hand a longer piece is taken, and
/// the straight line through it: there a short piece follows the jitter. The same for both directions of drawing.
Vec2 end_direction(const CleanLine& line, bool at_start, const DrawingScale& scale);

/// Leads a line drawn by hand apart where it crosses itself. Where the two sides of something thin crossed it is led on
/// beside itself, each side back where it came from; of a curl, which goes round in the same sense as the whole line,
/// the smaller loop is cut off. What crosses itself next to one of its ends is left as it is: that end passes behind
/// it.
/// @returns the places where it crossed itself
std::vector<Vec2> uncross(CleanLine& line, const DrawingScale& scale);

/// Things of a typical size measure at least so many u: a sheet of many small things is read as one of them is.
inline constexpr double least_typical_size = 150;

/// The strokes of a drawing that can be read.
struct SampledDrawing {
  DrawingScale scale;
  int smoothing_passes = 0;
  std::vector<SampledStroke> strokes;  ///< samples half a step apart
  std::vector<SampledStroke> hidden;   ///< those of kind "hidden"
  std::vector<CentreLine> tubes;       ///< not among the strokes
  std::vector<Index> dots;             ///< indices into Drawing::strokes: too short to be a line of anything
  Findings findings;
};

/// Step 1, stroke cleaning (Cordier, Seo, Cho 2006, section 3): strokes too short to be lines are set apart, the rest
/// sampled evenly. What open strokes draw once more of other ones, or of their own beginning, before they go on alone
/// is cut off: a pen often goes back a bit before a line goes on. Of two strokes the one drawn later is cut. No stroke
/// of the drawing is changed or deleted; the samples are copies. O(n) for evenly spread samples.
/// @param typical size of the things on the sheet (see `size_of`), which makes u finer where they are small; 0: not
/// known
/// @throws Error when nothing usable is left or the drawing is too long to sample
SampledDrawing sample_strokes(const Drawing& drawing, const StrokeOptions& options, double typical = 0);

/// Per stroke the longer one that it was drawn over: both run beside one another closely, over most of the shorter
/// one's length. no_index for all others. Strokes that keep to one side of one another at a steady distance are two
/// outlines, such as the sides of a thin tube. O(n) for evenly spread samples.
std::vector<Index> doubled_strokes(const std::vector<SampledStroke>& strokes, const DrawingScale& scale);

}  // namespace croquis::silhouette
