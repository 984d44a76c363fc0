// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/base/parameter.h"
#include "croquis/silhouette/drawing_readings.h"

namespace croquis {

/// The readings of a drawing with parameters of the operation `inflate`.
/// @param parameters those that differ from the defaults, or all
/// @throws Error (E_PARAMETER) for values that can't be read, and for swaps: overlaps have other numbers in each
/// reading
silhouette::DrawingReadings readings_of(const Drawing& drawing, const ParameterValues& parameters);

}  // namespace croquis
