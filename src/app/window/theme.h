// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QIcon>
#include <QList>
#include <QString>

#include "croquis/base/finding.h"

class QApplication;

/// The studio's colours, in one place: panels in the theme that people chose, around paper and clay.
namespace croquis::app {

/// What lies in the views, whose paper and clay are the same in each theme.
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
inline const QColor guide(136, 144, 156);
inline const QColor behind(126, 150, 186);  ///< ink of strokes that lie behind others
inline const QColor error(214, 60, 52);
inline const QColor warning(222, 164, 30);
}  // namespace colors

/// The colours of panels, menus and dialogs. Each text can be read on each ground (contrast 4.5, disabled ones 3).
struct ThemeColors {
  QColor window, base, raised, bar;  ///< grounds: of panels; of lists, fields and menus; of buttons; of panel titles
  QColor line;                       ///< borders
  QColor text, faint, disabled, link, good, warning, error;  ///< words; faint ones say less
  QColor accent, on_accent;                                  ///< ground of what is selected, and text there
  QColor hovered, checked;                                   ///< grounds of buttons: under the pointer, switched on
  bool outlined = false;                                     ///< every field and button has a border
};

/// Names of the themes with their titles; the first one is that of a new installation.
QList<std::pair<QString, QString>> themes();

/// The one that people chose, in the settings of the program.
QString kept_theme();
void keep_theme(const QString& name);

/// Every window, also one that is open, has the colours of that theme from now on. Lists show them when they are next
/// filled (MainWindow::refresh).
void use_theme(const QString& name);

/// Those of the theme in use.
const ThemeColors& theme_colors();

/// Style of every window and the kept theme; before the first one is made.
void apply_theme(QApplication& application);

/// Gives the text of a label the colour of what it says: "faint", "good", "warning" or "error"; empty for that of text.
void set_tone(QWidget& label, const QString& tone);

/// How large everything is, in per cent: one of the offered sizes. It is applied when the program starts.
QList<int> scales();
int kept_scale();
void keep_scale(int percent);

/// Hidden contours: the first colour lies behind one surface, the next behind two … distinct for any
/// colour vision, each readable on paper.
QColor depth_color(int depth);

/// Black or white, whichever can be read on the colour.
QColor text_color_on(const QColor& color);

/// A finding's sentence on a panel. Notes have the colour of text.
QColor sentence_color(Severity severity);

/// The drawn icon of an action in the colours of the theme in use, or an empty one for actions that have none.
QIcon action_icon(const QString& action);

/// The same as it was drawn, for what lies on paper.
QIcon paper_icon(const QString& action);

/// The program's own.
QIcon program_icon();

}  // namespace croquis::app
