// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <vector>

#include "croquis/geometry/vector.h"

namespace croquis::silhouette {

/// One of the two ends of an open stroke.
struct StrokeEnd {
  Index stroke = 0;  ///< index into Drawing::strokes
  bool at_start = false;

  friend auto operator<=>(const StrokeEnd&, const StrokeEnd&) = default;
};

/// Two ends that are, or may be, one place of one line.
struct EndPair {
  StrokeEnd a;
  StrokeEnd b;  ///< a < b
  double distance = 0;

  bool has(const StrokeEnd& end) const { return a == end || b == end; }
  bool same_ends(const EndPair& other) const { return a == other.a && b == other.b; }
};

/// An end of a line and a stroke that it doesn't pass behind, however near that is.
struct EndElsewhere {
  StrokeEnd end;  ///< the stroke in which the line begins or ends
  Index bar = 0;  ///< index into Drawing::strokes

  friend auto operator<=>(const EndElsewhere&, const EndElsewhere&) = default;
};

/// What a drawing's strokes are taken to mean where the plain rules led to a contradiction.
struct StrokeReading {
  std::vector<char> included;     ///< per stroke; empty: all are read
  std::vector<EndPair> together;  ///< joined, though the rules would not
  std::vector<EndPair> apart;     ///< not joined, though the rules would
  std::vector<Index> farther;     ///< strokes whose ends may miss the line they pass behind by more than usual
  std::vector<EndElsewhere> elsewhere;

  bool steady = false;  ///< directions of ends are taken as drawn, however much the hand trembled

  std::size_t changes() const { return together.size() + apart.size() + farther.size() + elsewhere.size(); }
  bool includes(Index stroke) const { return included.empty() || included[stroke] != 0; }
};

}  // namespace croquis::silhouette
