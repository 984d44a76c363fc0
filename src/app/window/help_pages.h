// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QString>

class QAction;
class QWidget;

namespace croquis::app {

class MainWindow;

/// Opens the manual of the studio in a window of its own, at the heading of that name.
/// @param heading in English or the language in use; empty, or one that the manual lacks: at its beginning
void show_manual(QWidget& parent, const QString& heading);

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
