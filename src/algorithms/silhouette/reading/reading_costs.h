// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

/// What each thing that a reading supposes costs. A cost of 1 is about what a careful hand gets wrong once in three
/// times: costs stand for minus the logarithm of how often it happens. docs/algorithms/reading_costs.md derives them.
namespace croquis::silhouette::costs {

/// Of a distance in parts of what hands miss by: squared for small ones, in proportion for large ones.
inline double miss(double share) { return share < 1 ? share * share : 2 * share - 1; }

/// The same of the gap that an outline left open: beyond what hands miss by, its width says less and less.
inline double opening(double share) { return share < 1 ? share * share : 1 + 2 * std::log(share); }

/// How the cost of a long hidden piece grows: distance alone seldom says whether two ends belong together.
inline double flattened(double cost) { return cost < 1 ? cost : 1 + 0.5 * std::log(cost); }

// Ends that meet.
inline constexpr double gap = 0.7;             ///< times miss()
inline constexpr double turn = 1.9;            ///< times 1 - cosine of the turn
inline constexpr double line_between = 1.5;    ///< another line crosses the gap
inline constexpr double line_at_gap = 1.5;     ///< each end that lies on a line, times the gap in what hands miss by
inline constexpr double opening_within = 1;    ///< a gap that hands don't leave, of what lies within everything
inline constexpr double chance_meeting = 0.7;  ///< an end lies on a line when passing behind it would cost less
inline constexpr double overshoot = 0.3;       ///< both run on beyond the place where they meet

// Ends that pass behind a line.
inline constexpr double junction = 0.15;      ///< each
inline constexpr double junction_miss = 0.6;  ///< times miss()
inline constexpr double beside = 0.3;         ///< the end points elsewhere: it only lies near the line
inline constexpr double against_heading = 4;  ///< times the sine at which it heads out of the bar's surface
inline constexpr double own_line = 0.2;       ///< a line that passes behind itself
inline constexpr double end_of_bar = 1;       ///< times how near to the bar's own end it is met
inline constexpr double bar_crossed = 1;      ///< the line runs across its bar before it ends there
inline constexpr double line_before_bar = 1;  ///< another line lies between the end and the bar

// Hidden pieces.
inline constexpr double hidden = 0.25;               ///< times completion_cost, flattened
inline constexpr double hidden_of_one_stroke = 1.6;  ///< completion_cost of a limb's cap, at most

// Candidates for hidden contours: what CompletionCandidate::cost combines. The unit is that of completion_cost, in
// which a straight piece as long as hidden ends are apart from one another costs 1.
inline constexpr double bent_away = 5;        ///< times the bending away from the surface: ends of limbs are caps
inline constexpr double opposite_sides = 15;  ///< times how surely both lines bend round something, on opposite sides
inline constexpr double limb_cap = 2.7;       ///< at most, where line and cap turn round once, however wide it is
inline constexpr double strip = 0.15;         ///< factor of both sides of a strip that goes straight on: it is one part
inline constexpr double strip_side = 0.6;     ///< at most, of each of them however long it is: less than two caps
inline constexpr double crossed_strip = 1.5;  ///< factor of strips that are more likely petals or arms all round
inline constexpr double in_the_open = 3;      ///< each surface that is missing in front of a piece

// Lines that cross in full view.
inline constexpr double crossing = 0.5;      ///< each, of two contours
inline constexpr int most_crossings = 4;     ///< of two contours; more don't count
inline constexpr double own_crossing = 0.8;  ///< each, of a contour with itself
inline constexpr int most_own_crossings = 20;

// Kinds of strokes.
inline constexpr double contour = 0.05;
inline constexpr double thin_outline = 8;   ///< a closed line that encloses hardly anything, times how little
inline constexpr double thin_width = 0.01;  ///< in parts of the drawing's size: what isn't thin any more
inline constexpr double one_of_many = 5;    ///< times how much it is a part of a pattern
inline constexpr double detail = 3.5;
inline constexpr double closed_detail = 2;   ///< more: a closed line is nearly always an outline, but in a pattern
inline constexpr double detail_outside = 6;  ///< times the share of it that lies outside everything
inline constexpr double size = 3;            ///< times twice its size in parts of the drawing's, at most
inline constexpr double tube = 3;
inline constexpr double tube_size = 4;    ///< times its size in parts of the drawing's
inline constexpr double tube_apart = 4;   ///< it hangs on nothing
inline constexpr double tube_inside = 5;  ///< times the share of it that doesn't lie outside
inline constexpr double ignored = 4.5;
inline constexpr double ignored_hanging = 1;    ///< it touches what touches an outline
inline constexpr double ignored_length = 20;    ///< times its share of all lines' length
inline constexpr double outline_left_out = 30;  ///< times the share of the drawing's outline that it makes
inline constexpr double outline_as_tube = 9;    ///< the same of tubes

// An outline that regions enclose.
inline constexpr double region = 12;
inline constexpr double stroke_of_region = 2;  ///< each stroke that it consists of
inline constexpr double rest_of_stroke = 2;    ///< times the share of the stroke that isn't on it
inline constexpr double lost_of_stroke = 16;   ///< times the share of it that lies outside everything: it would be lost

}  // namespace croquis::silhouette::costs
