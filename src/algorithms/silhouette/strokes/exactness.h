// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/silhouette/strokes/clean_line.h"
#include "algorithms/silhouette/strokes/stroke_chains.h"

/// What a drawing says about how exact it is: a program puts ends on lines and draws curves, a hand does neither.
namespace croquis::silhouette {

/// Whether nearly all ends of open strokes lie on another line, or on a part of their own far from them. False where
/// there are none.
bool are_ends_exact(const std::vector<SampledStroke>& strokes, const DrawingScale& scale);

/// Whether most samples lie on smooth curves: smoothing would only take from them.
bool are_smooth(const std::vector<SampledStroke>& strokes, const DrawingScale& scale);

}  // namespace croquis::silhouette
