// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/tracing/line_joining.h"

namespace croquis::tracing {

/// The smooth curve along the pixels of a line, with its corners, as points at even distances.
/// @param half_width pixels, the usual one of a line: corners are found over about two widths
TracedLine smooth_curve(const TracedLine& line, double half_width);

}  // namespace croquis::tracing
