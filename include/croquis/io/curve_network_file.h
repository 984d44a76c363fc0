// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "croquis/geometry/curve_network.h"

namespace croquis {

/// Spans of a curve that isn't straight, on each of its pieces: 33 points on a curve of one piece.
inline constexpr int curve_file_spans = 32;

/// An OBJ file of the network: one `o ID` with a polyline for each curve, straight ones of two points, others of points
/// on the exact rational curve. Ends that meet have identical coordinates; numbers read back exactly. Linear.
std::string write_curve_network_obj(const CurveNetwork& network);

}  // namespace croquis
