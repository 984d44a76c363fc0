// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/action_list.h"

#include <QAction>
#include <QActionGroup>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QToolBar>
#include <algorithm>
#include <utility>
#include <vector>

#include "app/window/theme.h"

namespace croquis::app {
namespace {

constexpr QSize bar_icon(26, 26);

std::vector<std::pair<MenuId, QString>> menu_titles() {
  return {{MenuId::File, QObject::tr("File")},       {MenuId::Edit, QObject::tr("Edit")},
          {MenuId::Create, QObject::tr("Create")},   {MenuId::Select, QObject::tr("Select")},
          {MenuId::Modify, QObject::tr("Modify")},   {MenuId::Mesh, QObject::tr("Mesh")},
          {MenuId::Sketch, QObject::tr("Sketch")},   {MenuId::Perspective, QObject::tr("Perspective")},
          {MenuId::Surface, QObject::tr("Surface")}, {MenuId::Holes, QObject::tr("Holes")},
          {MenuId::View, QObject::tr("View")},       {MenuId::Window, QObject::tr("Window")},
          {MenuId::Help, QObject::tr("Help")}};
}

/// Every entry gets a letter of its own: the first of a word where it is free. Texts don't have to care.
void underline_letters(const QList<QAction*>& entries) {
  QString used;
  for (QAction* action : entries) {
    if (action->menu() != nullptr) underline_letters(action->menu()->actions());
    if (!action->isVisible() || action->text().isEmpty()) continue;
    QString text = without_marks(action->text());
    static const QRegularExpression first(QStringLiteral("\\b[A-Za-z]")), any(QStringLiteral("[A-Za-z]"));
    for (const QRegularExpression* letters : {&first, &any}) {
      auto found = letters->globalMatch(text.section('\t', 0, 0));
      qsizetype at = -1;
      while (at < 0 && found.hasNext()) {
        const auto letter = found.next();
        if (!used.contains(letter.captured(), Qt::CaseInsensitive)) at = letter.capturedStart();
      }
      if (at < 0) continue;
      used += text[at];
      text.insert(at, '&');
      break;
    }
    action->setText(text);
  }
}

bool can_do_anything(const QMenu& menu) {
  return std::ranges::any_of(menu.actions(), [](const QAction* action) {
    if (action->menu() != nullptr) return can_do_anything(*action->menu());
    return !action->isSeparator() && action->isEnabled();
  });
}

}  // namespace

QString without_marks(QString text) {
  return text.replace("&&", QStringLiteral("\x01")).remove('&').replace('\x01', "&&");
}

ActionList::ActionList(QMainWindow& window, std::function<void(const QString&, Recorded)> triggered)
    : window_(window), triggered_(std::move(triggered)), mode_group_(new QActionGroup(&window)) {
  for (const auto& [id, title] : menu_titles()) {
    QMenu* menu = menus_[id] = window.menuBar()->addMenu(title);
    QObject::connect(menu, &QMenu::aboutToShow, [menu] { underline_letters(menu->actions()); });
  }
  underline_letters(window.menuBar()->actions());
}

void ActionList::show_menus() {
  for (const MenuId id : {MenuId::Perspective, MenuId::Surface, MenuId::Holes})
    menu(id)->menuAction()->setVisible(can_do_anything(*menu(id)));
}

QToolBar* ActionList::bar(const QString& name, const QString& title) {
  if (auto* made = window_.findChild<QToolBar*>(name)) return made;
  auto* bar = new QToolBar(title, &window_);
  bar->setObjectName(name);
  bar->setMovable(false);
  bar->setIconSize(bar_icon * std::min(1.0, kept_scale() / 100.0));
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
  action->setToolTip(action->text() + " (" + key + ")");
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
