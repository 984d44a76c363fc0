// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "croquis/base/finding.h"
#include "croquis/base/progress.h"
#include "croquis/geometry/drawing.h"

/// Drawings from SVG files. https://www.w3.org/TR/SVG11/ (paths: chapter 8, transforms: 7.6, arcs: appendix F.6)
namespace croquis {

/// How far a flattened curve may lie from the true one, × the diagonal of the whole drawing's bounding box. A hundredth
/// of the unit in which sketch tolerances are given, so that no later step can see the difference.
inline constexpr double svg_flattening_tolerance = 1e-5;

struct DrawingReadResult {
  Drawing drawing;
  Findings warnings;
};

/// Reads every `path`, `polyline`, `polygon`, `line`, `rect`, `circle` and `ellipse` that would be shown.
///
/// One subpath is one stroke. It is named after its element's id ("stroke-N" for the N-th shape when it has none), the
/// further ones "id/2", "id/3" …; a subpath of a moveto alone is no stroke. Coordinates are in user units after the
/// element's and all groups' transforms, y turned to point up; width, height and viewBox scale nothing. Curves become
/// polylines within svg_flattening_tolerance, with exact ends. Fill, stroke and style sheets are not looked at; what is
/// display:none or visibility:hidden (as an attribute or in `style`) is left out. `data-*` attributes of a shape go
/// into Stroke::data. `data-object` on a shape or on its nearest such group goes into Stroke::object, that group's
/// other `data-*` into Drawing::object_data. `data-plane` of the root, nine numbers, is the origin, u and v of its
/// plane.
///
/// Warnings: W_DUPLICATE_ID (renamed), W_IGNORED (text, image, use and other elements without strokes of their own; the
/// viewBox of an inner svg), W_TINY (a closed subpath of a single point).
///
/// Linear in the size of the file plus the number of samples.
/// @param bytes     the whole file, UTF-8
/// @param file_name for findings
/// @throws Error Malformed: E_EMPTY, E_SYNTAX (XML, path data, numbers, transforms; with line and character),
///         E_NOT_FINITE, E_NO_STROKES; Limit: E_LIMIT (4 million samples, 256 levels of nesting, 64 MiB of attributes).
///         All findings of the file together.
/// @throws Cancelled
DrawingReadResult read_svg_drawing(std::string_view bytes, const std::string& file_name, Progress& progress);

}  // namespace croquis
