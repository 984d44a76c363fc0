// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QIcon>

#include "croquis/base/finding.h"

class QApplication;

/// The studio's colours, in one place: dark panels around paper and clay.
namespace croquis::app {

namespace colors {
inline const QColor paper(250, 249, 246);
inline const QColor ink(38, 40, 46);
inline const QColor accent(242, 140, 40);         ///< selection and whatever the pen is about to do
inline const QColor selected_face(96, 14, 0);     ///< in the surface's light: dark beside clay; its edges are bright
inline const QColor selected_casing(30, 20, 12);  ///< around selected edges, so that they differ from any surface
inline const QColor hover(96, 156, 230);
inline const QColor cage(52, 74, 110);
inline const QColor vertex(62, 50, 110);
inline const QColor infinite_edge(186, 18, 140);  ///< as render::sharpness_color has it
inline const QColor guide(150, 158, 170);
inline const QColor behind(126, 150, 186);  ///< ink of strokes that lie behind others
inline const QColor error(214, 60, 52);
inline const QColor warning(222, 164, 30);
}  // namespace colors

/// Palette, style sheet and font of every window; before the first one is made.
void apply_theme(QApplication& application);

/// Hidden contours: the first colour lies behind one surface, the next behind two … distinct for any
/// colour vision, each readable on paper.
QColor depth_color(int depth);

/// A finding's sentence on a dark panel. Notes have the colour of text.
QColor sentence_color(Severity severity);

/// The drawn icon of an action, or an empty one for actions that have none.
QIcon action_icon(const QString& action);

/// The program's own.
QIcon program_icon();

}  // namespace croquis::app
