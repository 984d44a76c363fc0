// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "croquis/base/finding.h"
#include "croquis/operators/perspective_result.h"

namespace croquis::app {

/// How far a drawing is a solid, in one sentence.
struct SolidState {
  QString sentence;                  ///< "2 faces, 5 edges lack a face", "Solid closed"; empty without edges
  bool sound = false;                ///< closed, and nothing that was drawn is doubtful or left out
  std::vector<std::string> strokes;  ///< to look at: those that the sentence is about
};

/// @param drawing that the result was found in, or a newer one
SolidState solid_state(const PerspectiveDrawing& drawing, const PerspectiveResult& result, const Findings& findings);

/// What any unfinished drawing has: ends that lead nowhere, edges without a face, parts that nothing ties together.
/// Worth a small mark while somebody draws, but no warning sign.
bool is_of_unfinished(const Finding& finding);

}  // namespace croquis::app
