// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>
#include <vector>

class QAction;
class QTreeWidget;
class QWidget;

namespace croquis::app {

class MainWindow;

/// Something that can be asked for by its name.
struct Command {
  QString text;   ///< "Extrude faces"
  QString place;  ///< where it also is: "Mesh", "Attributes ▸ Solid", "Examples"
  QString keys;   ///< empty for none
  bool enabled = true;
  std::function<void()> run;
  QString english = {};  ///< of its text: it is found by that, too
};

/// An empty list with columns for text, place and keys.
QTreeWidget* make_command_list(QWidget* parent);

/// An action's text as people read it: without key and underlined letter.
QString plain_text(const QAction& action);

/// The titles of the menus that lead to an action: "Mesh ▸ Subdivision".
QString menu_place(const QAction& action);

/// Every action that has a text, the parameters of the active object's steps, the files that were open lately, the
/// examples, and the pages of the help.
std::vector<Command> all_commands(MainWindow& window);

/// How well a text answers what was typed, greater is better; 0: not at all. Each typed word has to begin a word of the
/// text, to be in it, or to be made of the first letters of words in it ("exfa" finds "Extrude faces"). Case doesn't
/// count.
int match_of(const QString& typed, const QString& text);

/// Numbers of the commands that answer what was typed, best first; of equal ones those that can be done now, then the
/// shorter ones. All of them when nothing was typed.
std::vector<std::size_t> found_commands(const std::vector<Command>& commands, const QString& typed);

/// A field over the window with the list of what it finds; Enter does the chosen one, Escape leaves.
void show_palette(QWidget& parent, std::vector<Command> commands);

}  // namespace croquis::app
