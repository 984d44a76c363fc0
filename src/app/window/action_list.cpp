// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/action_list.h"

#include <QAction>
#include <QActionGroup>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <utility>

#include "app/window/theme.h"

namespace croquis::app {
namespace {

constexpr QSize bar_icon(26, 26);

}  // namespace

ActionList::ActionList(QMainWindow& window, std::function<void(const QString&, Recorded)> triggered)
    : window_(window), triggered_(std::move(triggered)), mode_group_(new QActionGroup(&window)) {}

QMenu* ActionList::menu(const QString& title) {
  QMenu*& menu = menus_[title];
  if (menu == nullptr) menu = window_.menuBar()->addMenu(title);
  return menu;
}

QToolBar* ActionList::bar(const QString& name, const QString& title) {
  if (auto* made = window_.findChild<QToolBar*>(name)) return made;
  auto* bar = new QToolBar(title, &window_);
  bar->setObjectName(name);
  bar->setMovable(false);
  bar->setIconSize(bar_icon);
  window_.addToolBar(Qt::LeftToolBarArea, bar);
  return bar;
}

QAction* ActionList::add(QMenu* menu, const QString& name, const QString& text, const QList<QKeySequence>& keys,
                         std::function<void()> work, Recorded recorded) {
  auto* action = new QAction(text, &window_);
  action->setObjectName(name);
  action->setShortcuts(keys);
  action->setIcon(action_icon(name));
  QObject::connect(action, &QAction::triggered, &window_, [this, name, recorded, work = std::move(work)] {
    triggered_(name, recorded);
    work();
  });
  menu->addAction(action);
  window_.addAction(action);
  return action;
}

QAction* ActionList::add_mode(QMenu* menu, const QString& mode, const QString& text, const QString& key,
                              std::function<void()> work) {
  const QList<QKeySequence> keys = key.isEmpty() ? QList<QKeySequence>() : QList<QKeySequence>{QKeySequence(key)};
  QAction* action = add(menu, mode, text, keys, std::move(work));
  action->setCheckable(true);
  action->setToolTip(action->text().remove('&') + " (" + key + ")");
  mode_group_->addAction(action);
  bar("tools", QObject::tr("Tools"))->addAction(action);
  modes_[mode] = action;
  return action;
}

void ActionList::show_mode(const QString& mode) {
  if (QAction* action = modes_.value(mode)) action->setChecked(true);
}

QAction* ActionList::find(const QString& name) const { return window_.findChild<QAction*>(name); }

}  // namespace croquis::app
