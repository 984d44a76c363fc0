// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "croquis/attribute_surface/curve_edit.h"

/// Finds the loops of curves that people mean: by naming the curves in any order, or by pointing into them.
namespace croquis {

/// Two ends that a loop joins though they are apart.
struct LoopGap {
  AttributeSide before;  ///< ends at the gap
  AttributeSide after;   ///< begins there
  double distance = 0;   ///< model units
};

struct SortedLoop {
  std::vector<AttributeSide> sides;  ///< in order, each ends where the next one begins; empty when there is no loop
  std::vector<LoopGap> snaps;        ///< gaps within the tolerance: other nodes at (almost) the same place
  Findings
      findings;  ///< why there is none: E_TOO_FEW, E_TOO_MANY, E_DUP_CURVE, E_OPEN_LOOP with both curves and the gap

  bool closed() const { return !sides.empty(); }
};

/// Puts curves into the order of a loop and turns them round where that is needed. Neither is unique: the loop begins
/// with the first curve, along it, unless neighbouring faces want the other direction. Any number from 2 to 64; one
/// that is closed in itself is a loop, too.
/// @param curves indices, any order
/// @param tolerance model units, >= 0: ends that are so near are one
SortedLoop sort_loop(const AttributeNetwork& network, const std::vector<Index>& curves, double tolerance);

/// The face of a loop: nodes of its gaps are merged, ends without nodes get one, and the face is added.
/// @pre loop.closed()
AddedElement close_loop(AttributeNetwork network, const SortedLoop& loop);

/// A curve as a view shows it: at least 2 places, or none when it isn't seen. Its ends are those of the curve.
struct ViewedCurve {
  std::vector<Vec2> places;    ///< px
  std::vector<double> depths;  ///< distance along the view, any unit, nearer is less; one for each place

  bool seen() const { return places.size() >= 2; }
};

struct LoopSearchOptions {
  double tolerance = 0;         ///< model units, >= 0: ends that are so near are one
  std::size_t most_sides = 12;  ///< at least 2
};

struct LoopAround {
  SortedLoop loop;            ///< closed, as sort_loop gives it, but counter-clockwise in the view unless faces beside
                              ///< it want the other direction
  std::optional<Index> face;  ///< that has this loop already
};

/// The shortest closed walk along curves around a place of a view. Candidates are the shortest walk through each curve
/// that a ray from the place crosses (Dijkstra over nodes and the parity of crossings); of those hardly longer than the
/// shortest the one whose surface is nearest to the eye at the place. Loops that are no face yet are preferred.
/// Crossings of curves in the view alone join nothing. O(#crossed × #curves × log #curves).
/// @param views by curve
std::optional<LoopAround> find_loop_around(const AttributeNetwork& network, const std::vector<ViewedCurve>& views,
                                           const Vec2& place, const LoopSearchOptions& options = {});

/// The loop that lacks its face, so that hosts can offer it by itself: of the curves along fewer than two faces the one
/// drawn last that fewest other curves lead back from, as long as that loop is no face yet. Curves inside faces are no
/// borders. Breadth first, O(#curves²) at worst.
/// @return closed, or empty where there is none
SortedLoop open_loop(const AttributeNetwork& network, const LoopSearchOptions& options = {});

}  // namespace croquis
