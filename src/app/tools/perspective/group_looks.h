// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QString>
#include <vector>

#include "croquis/geometry/perspective_drawing.h"
#include "croquis/render/line_item.h"

/// How groups of strokes look: a colour, dashes and a letter, so that nobody needs to tell colours apart.
namespace croquis::app {

QColor group_color(StrokeGroup group);

/// Lines along an axis are solid, dashed or dash-dotted; those in planes are dotted with their axis' rhythm.
render::DashPattern group_dashes(StrokeGroup group);

/// "x", "y", "z", "⊥x", "⊥y", "⊥z", "?".
QString group_letter(StrokeGroup group);
QString group_words(StrokeGroup group);  ///< "x", "left" …: what stands on a button

/// "Parallel to x" … "In a plane across z".
QString group_title(StrokeGroup group);

/// The letter as polylines in a square of side 1 about (0, 0), y up; planes have a frame around theirs.
std::vector<std::vector<Vec2>> group_glyph(StrokeGroup group);

/// From pale yellow over orange to dark red, the worse the darker. @param px how far a line misses its vanishing point
QColor residual_color(double px);

}  // namespace croquis::app
