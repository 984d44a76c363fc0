// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "algorithms/silhouette/reading/connections.h"
#include "algorithms/silhouette/reading/envelope.h"
#include "algorithms/silhouette/strokes/clean_line.h"
#include "croquis/base/progress.h"
#include "croquis/solver/integer_program.h"

namespace croquis::silhouette {

/// What a stroke is taken for.
enum class LineKind : std::uint8_t {
  Contour,  ///< a visible contour of a part
  Region,   ///< it lies on the outline of a region that is taken as a whole
  Detail,   ///< a line on the surface
  Tube,     ///< a limb of one line
  Ignored
};

/// What a drawing's strokes mean together. Joins, meetings and regions are ascending positions among the candidates.
struct Reading {
  std::vector<LineKind> kinds;  ///< per sampled stroke
  std::vector<Index> joins;     ///< of contours: each end is in one of these,
  std::vector<Index> meetings;  ///< or in one of those
  std::vector<Index> regions;
  double cost = 0;
};

/// What the program's variables stand for.
struct ReadingVariables {
  static constexpr std::size_t kind_count = 5;
  /// With the surface on the left, and on the right; twice the same of what doesn't bound a surface on one side.
  using Sides = std::array<Index, 2>;

  std::vector<std::array<Sides, kind_count>> kind{};         ///< per stroke
  Index kinds_end = 0;                                       ///< the first variable after those of kinds
  std::vector<Sides> join{}, meeting{}, hidden{}, region{};  ///< per candidate
  std::vector<Index> open{};  ///< per stroke: its line has hidden ends; empty until it matters

  const Sides& of(Index stroke, LineKind line) const { return kind[stroke][static_cast<std::size_t>(line)]; }
};

/// Kinds and connections of all strokes, chosen together by an integer program. With x(s,k,o) = stroke s has kind k and
/// the surface on its side o (left or right, of what bounds one), r = region taken, j(o) = join, m(o) = meeting,
/// h(o) = hidden pair taken, with the surface on side o of the first end's stroke and so on one side of the other's:
///   Σ x(s,k,o) = 1; Σ_o x(s,Region,o) <= Σ r of regions that s lies on; Σ_o x(s,Contour,o) + r <= 1 for these
///   Σ j(o) + Σ m(o) = x(s,Contour,o) at each end for each side; Σ h(o) = Σ m(o) likewise
///   Σ_o m(o) <= x(bar,Contour,p) + x(bar,Region,p) for the side p of the bar that the meeting says
/// at the least sum of costs (reading_costs.h). Readings come best first: what turns out to be impossible is excluded.
/// Variables for each side take the place of rows that compare sides: relaxations of those are weak.
class ReadingProgram {
 public:
  /// Strokes and connections must outlive the program.
  ReadingProgram(const std::vector<SampledStroke>& strokes, const Connections& connections, const Envelope& envelope);

  /// Two ends are one line, in full view or behind something, or aren't. Positions among the connections' ends.
  void pin(Index a, Index b, bool joined);

  /// The best reading that isn't excluded; none when there is no other, or the search for it is bounded.
  std::optional<Reading> best();

  /// Of what a reading says of these strokes something must change.
  /// @param strokes     positions; all when empty
  /// @param connections may change, else one of the strokes must get another kind
  void exclude(const Reading& reading, const std::vector<Index>& strokes, bool connections);

  /// Two lines with hidden ends, or one, cross in full view as that reading has it: nothing says which is in front.
  /// @param a, b positions, of the same stroke where one crosses itself
  /// @return false when one of them is closed in that reading, and nothing was excluded
  bool exclude_crossing(const Reading& reading, Index a, Index b, const Vec2& at);

  /// Only the outlines of regions may be contours.
  void allow_regions_only();

  /// The stroke is no detail, and not left out where it could be a limb.
  void forbid_loss(Index stroke);

  /// No stroke has that kind.
  void forbid(LineKind kind);

  /// Where no reading is left from the first: strokes whose given kind can't be beside the kinds given to
  /// others, ascending.
  std::vector<Index> contradictions() const;

 private:
  Index stroke_of(Index end) const { return connections_.ends[end].stroke; }
  void set_most(IntegerProgram& program, Index stroke, LineKind kind, double most) const;

  const std::vector<SampledStroke>& strokes_;
  const Connections& connections_;
  std::vector<char> can_be_limb_;  ///< per stroke
  IntegerProgram program_;
  ReadingVariables variables_;
  int nodes_ = 0;  ///< looked at by all searches
};

/// The contours that a reading sees, as lines.
struct ContourLines {
  std::vector<CleanLine> lines;  ///< by the lowest stroke in them, then regions
  Findings findings;             ///< gaps closed
};

/// Joins the contours' strokes and the outlines of regions to lines, smooths them (Taubin 1995) and samples them
/// evenly.
/// @param passes of smoothing
ContourLines contour_lines(const Drawing& drawing, const SampledDrawing& sampled, const Connections& connections,
                           const Envelope& envelope, const Reading& reading, int passes, const Progress& progress);

/// The outlines of the limbs that were drawn as one line: everything within half a limb's width of them, where they
/// leave what the contours bound, and a bit of it within, so that they grow out of it. Limbs that touch are one.
/// @param contours of the drawing, any number of them open
/// @param diagonal of the drawing
/// @returns closed lines, counter-clockwise, samples a step apart
std::vector<CleanLine> tube_outlines(const SampledDrawing& sampled, const Reading& reading,
                                     const std::vector<CleanLine>& contours, double diagonal);

}  // namespace croquis::silhouette
