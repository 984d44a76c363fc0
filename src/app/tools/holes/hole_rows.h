// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <limits>
#include <set>
#include <vector>

#include "app/studio/studio.h"
#include "croquis/operators/fill_result.h"

/// The holes that the result of `fill` has, as lists and views show them.
namespace croquis::app {

/// Of a result of `fill`; empty for any other, and for null.
std::vector<HoleRow> hole_rows(const Evaluation* result);

/// Ids of those that a selection for all holes names. @param max_diameter as FillOptions has it
std::vector<Index> named_rows(const std::vector<HoleRow>& rows, hole_filling::Selection selection,
                              double max_diameter = std::numeric_limits<double>::infinity());

/// These, and the islands in them or the holes around them: one without the other leaves the island cut off, or its
/// patch in the way. Ascending.
std::vector<Index> with_islands(const std::vector<HoleRow>& rows, const std::vector<Index>& holes);

/// "island", "open edge" … in people's words.
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
