// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QString>

class QAction;
class QWidget;

namespace croquis::app {

class MainWindow;

/// A place of the manual.
struct HelpPlace {
  QString heading;     ///< of a section, in English or the language in use; empty: the beginning
  QString words = {};  ///< where they stand first in the section, in the language in use; empty: at the heading
};

/// Opens the manual of the studio in a window of its own.
void show_manual(QWidget& parent, const HelpPlace& place);

/// Where the manual names an action, else its menu: in the section about its tool, else in that about the menus.
HelpPlace help_place_of(const QAction& action);

/// The headings of the manual's sections, in the language in use.
QStringList manual_headings();

/// What an action's key is: its shortcuts, or what its text names behind a tab or its tooltip in brackets at the end;
/// empty for none.
QString keys_of(const QAction& action);

/// Opens a list of the actions that can be done now and have a key.
void show_keys(QWidget& parent, const QList<QAction*>& actions);

/// Program, version and licence.
void show_about(QWidget& parent);

void add_help_menu(MainWindow& window);

}  // namespace croquis::app
