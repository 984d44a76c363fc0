// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/studio/studio.h"

/// What the result of `fill` reports of every hole, as lists and views show it.
namespace croquis::app {

enum class HoleState { Open, Filled, Failed };

struct HoleRow {
  Index id = 0;
  std::string kind;  ///< as reports have it: "small", "simple", "OUTER" …
  std::size_t edges = 0;
  double diameter = 0;  ///< model units
  double area = 0;
  double perimeter = 0;
  HoleState state = HoleState::Open;
  std::string method;                 ///< of the patch taken, empty without one
  std::string reason;                 ///< why it was left, failed, or not filled by the first method
  std::optional<double> normal_jump;  ///< degrees
  std::optional<double> confidence;   ///< 0..1
  std::optional<Index> patch;         ///< number of its patch
  Vec3 at = Vec3::Zero();             ///< the middle of its rim
  Vec3 normal = Vec3::UnitZ();
  std::vector<Index> companions;

  bool is_border() const { return kind == "OUTER"; }
};

/// Of an object whose last operation is `fill`; empty for any other, and before its first result.
std::vector<HoleRow> hole_rows(const StudioObject* object);

/// These, and the islands in them or the holes around them: one without the other leaves the island cut off, or its
/// patch in the way. Ascending.
std::vector<Index> with_islands(const std::vector<HoleRow>& rows, const std::vector<Index>& holes);

/// "island", "border, keep?" … in people's words.
QString words_for(const HoleRow& hole);

/// "filled", "open" or "failed".
QString words_for(HoleState state);

/// "27 holes: 25 filled, 1 border left open, 1 failed".
QString summary_of(const std::vector<HoleRow>& holes);

/// "3", "3–5, 9" …: at most a few, then how many more.
QString numbers_of(const std::set<Index>& holes);

/// A length or area of the model with as many figures as are worth reading.
QString measure(double value);

}  // namespace croquis::app
