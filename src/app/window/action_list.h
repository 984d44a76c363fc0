// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>
#include <QList>
#include <QMap>
#include <QString>
#include <functional>

class QAction;
class QActionGroup;
class QMainWindow;
class QMenu;
class QToolBar;

namespace croquis::app {

/// Who writes an action into recordings.
enum class Recorded {
  AsAction,  ///< by its name
  ByItself   ///< by the code that acts: with a file's name, with elements
};

/// A text without the marks of underlined letters; "&&" stays.
QString without_marks(QString text);

/// The menu bar, from left to right.
enum class MenuId { File, Edit, Create, Select, Modify, Mesh, Sketch, Perspective, Surface, Holes, View, Window, Help };

/// The window's actions: what menus, keys, buttons and replays share.
class ActionList {
 public:
  /// @param triggered called before an action runs
  ActionList(QMainWindow& window, std::function<void(const QString& name, Recorded recorded)> triggered);

  /// Of the menu bar.
  QMenu* menu(MenuId id) const { return menus_[id]; }

  /// Shows the menus that belong to one kind of object while something in them can be done, and all others.
  void show_menus();

  /// Of the left side, made when it is first asked for; the first one is "tools".
  QToolBar* bar(const QString& name, const QString& title);

  QAction* add(QMenu* menu, const QString& name, const QString& text, const QList<QKeySequence>& keys,
               std::function<void()> work, Recorded recorded = Recorded::AsAction);

  /// What the pointer does: one of the tools' buttons, of which one is checked. @param work makes it the mode
  /// @param key empty: none of the window
  QAction* add_mode(QMenu* menu, const QString& mode, const QString& text, const QString& key,
                    std::function<void()> work);

  /// Checks the button of a mode.
  void show_mode(const QString& mode);

  /// The action of that name, or null.
  QAction* find(const QString& name) const;

 private:
  QMainWindow& window_;
  std::function<void(const QString&, Recorded)> triggered_;
  QMap<MenuId, QMenu*> menus_;
  QMap<QString, QAction*> modes_;
  QActionGroup* mode_group_;
};

}  // namespace croquis::app
