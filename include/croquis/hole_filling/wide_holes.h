// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/hole_filling/hole_analysis.h"

namespace croquis::hole_filling {

/// Of a diameter above a fifth of its piece's size: the place to begin from decides what a patch becomes.
inline bool is_wide(const HoleAnalysis& analysis, Index hole) {
  return analysis.holes[hole].diameter > 0.2 * analysis.component_size[analysis.holes[hole].component];
}

}  // namespace croquis::hole_filling
