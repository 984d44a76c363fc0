// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "croquis/base/finding.h"
#include "croquis/base/progress.h"
#include "croquis/base/report.h"
#include "croquis/geometry/perspective_drawing.h"

/// Perspective drawings as SVG files of the profile croquis-perspective/1, and as JSON with the same fields. What is
/// written in one of them and read again is the same drawing, whichever way it goes between the two.
///
/// SVG: cq:* are names of the namespace urn:croquis:perspective:1.
///
///     <svg cq:profile="croquis-perspective/1" viewBox="X Y WIDTH HEIGHT">
///      <metadata>
///       <cq:known at="U V" point="X Y Z"/> <cq:length stroke="ID" value="4"/> <cq:fov_x_deg value="50"/>
///       <cq:principal at="U V"/> <cq:unit value="mm"/> <cq:shells value="1"/>
///      </metadata>
///      <g cq:role="construction"> … </g>
///      <g cq:role="edge">
///       <path id="e00" cq:group="3" cq:from="v0" cq:to="v1" d="…"/>
///
/// Further attributes of strokes: cq:link="true", cq:hidden="true", cq:start-lock and cq:end-lock ("smooth", "corner"),
/// cq:weight; cq:group="unknown" for a colour that
/// says nothing. cq:role, cq:group and cq:hidden of a group count for what is in it. In metadata cq:f_px value="1070"
/// may stand for the field of view.
///
/// JSON: {"format": "croquis-perspective/1", "image": {"x", "y", "width", "height"},
///        "known_point": {"at": [u, v], "point": [x, y, z]}, "known_lengths": [{"stroke", "length"}], "fov_x_deg",
///        "principal_point": [u, v], "unit", "shells",
///        "strokes": [{"id", "role": "edge" or "construction", "group": 0..5,
///                     "points": [[u, v], [u, v]] of a straight one or "pieces": [[[u, v] × 4] …],
///                     "colour", "from", "to", "link", "start_lock", "end_lock", "hidden", "weight"}]}
/// All but format, image and each stroke's id and points or pieces may be absent. Coordinates of strokes that aren't
/// finite are the text "nan".
namespace croquis {

struct PerspectiveReadResult {
  PerspectiveDrawing drawing;
  Findings warnings;
};

/// The group that a colour stands for: "#rrggbb", "#rgb", "rgb(r, g, b)" or one of the usual names; by its hue where
/// the saturation is above 0.25. Unknown for others.
StrokeGroup group_of_colour(std::string_view colour);

/// "#F28C00" …; grey for Unknown.
std::string colour_of_group(StrokeGroup group);

/// Reads every path, line, polyline and other shape that would be shown, of the profile or of any program. Coordinates
/// are in user units after all transforms; the viewBox is the sheet, else width and height, else what the strokes take
/// (W_NO_SHEET).
///
/// Without cq:* the colour gives the group (attribute, style, or class of a style sheet, of the stroke or of groups
/// around it); construction lines are dashed or in a layer whose name (inkscape:label) begins with "construction", and
/// strokes in one that begins with "hidden" are hidden. One subpath is one stroke, named as in read_svg_drawing; of
/// closed ones every side is a stroke of its own, since the ends of one stroke never meet. Arcs become cubics of at
/// most a quarter turn (error below 3e-4 of the radius).
///
/// Nothing drawn is dropped: strokes of unknown group, of no length and with coordinates that aren't finite are
/// strokes. Strokes parallel to an axis are straight: where all their points are nearly on the line between the ends,
/// they are one straight piece.
///
/// Warnings: W_DUPLICATE_ID, W_IGNORED (as read_svg_drawing), W_NO_SHEET, W_VALUE (cq:* that isn't understood).
/// Info: GROUP_COLOUR (cq:group and colour disagree; cq:group counts).
/// @throws Error Malformed: E_EMPTY, E_SYNTAX (with line), E_NO_STROKES; Limit: E_LIMIT. All findings together.
/// @throws Cancelled
PerspectiveReadResult read_perspective_svg(std::string_view bytes, const std::string& file_name, Progress& progress);

/// @throws Error Malformed: E_EMPTY, E_SYNTAX with the line or the place (such as `strokes[3].group`), E_NO_STROKES;
///         at most 100 findings together
PerspectiveReadResult read_perspective_json(std::string_view bytes, const std::string& file_name);

/// Legible in any viewer: strokes have their groups' colours, construction lines are dashed. Numbers read back exactly.
std::string write_perspective_svg(const PerspectiveDrawing& drawing);

std::string write_perspective_json(const PerspectiveDrawing& drawing);

}  // namespace croquis
