// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "croquis/base/progress.h"
#include "croquis/geometry/drawing.h"
#include "croquis/io/png.h"

/// Line drawings from pictures of them: photos and scans of paper, screenshots of drawing programs.
namespace croquis {

/// The longer side of a traced picture in units of the drawing, however many pixels it has.
inline constexpr double traced_side = 1000;

struct TraceOptions {
  int longest_side = 1600;         ///< pixels, ≥ 16: larger pictures are scaled down to it first
  double widest_line = 0.05;       ///< × longer side: what is darker than its surroundings and narrower may be a line
  double shortest_stroke = 3;      ///< line widths; shorter strokes are specks
  std::size_t most_strokes = 500;  ///< a picture with more isn't a line drawing
};

/// The lines of a picture, dark ones on light ground or light ones on dark ground, as strokes along their middle.
///
/// Uneven light, shadows, wide dark areas such as a desk around a sheet, faint textures and specks give no stroke.
/// Strokes run straight through crossings, and are closed where their line is. A small filled shape, such as an eye,
/// becomes a closed stroke along its border. Strokes are "stroke-1" …, the longest first. The picture's top left corner
/// is at (0, 0), y points up. Transparent places count as light behind dark lines, and as dark behind light ones.
///
/// About linear in the pixels. Sources: Borgefors 1986, "Distance transformations in digital images" (3-4 distances);
/// Pudney 1998, "Distance-ordered homotopic thinning"; Schneider 1990 for the curves (bezier_fit.h).
/// @param file_name for findings, and the drawing's file
/// @throws Error E_NO_STROKES (Malformed) without any line; E_NO_LINE_DRAWING (Geometry) for photos of other things
/// @throws Cancelled
Drawing trace_picture(const Picture& picture, const std::string& file_name, Progress& progress,
                      const TraceOptions& options = {});

/// Whether these are the bytes of a picture's file rather than of a drawing: PNG, JPEG, HEIF, GIF, WebP, BMP or TIFF.
bool is_picture(std::string_view bytes);

/// Reads a PNG file and traces it.
/// @throws Error like decode_png and trace_picture; E_PICTURE_FILE for pictures of other formats
/// @throws Cancelled
Drawing read_picture_drawing(std::string_view bytes, const std::string& file_name, Progress& progress);

}  // namespace croquis
