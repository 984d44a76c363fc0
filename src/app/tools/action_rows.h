// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QKeySequence>
#include <QList>
#include <QMenu>
#include <functional>
#include <utility>
#include <vector>

#include "app/tools/tool.h"
#include "app/window/action_list.h"

namespace croquis::app {

/// A line of a menu. Without a name a separator.
struct ActionRow {
  const char* name = nullptr;
  QString text = {};
  QList<QKeySequence> keys = {};
  std::function<void()> work = {};
  QString icon_text = {};  ///< on buttons; empty: as the text
  Recorded recorded = Recorded::ByItself;
};

/// @return the actions, without separators
inline QList<QAction*> add_rows(ActionList& actions, QMenu* menu, const std::vector<ActionRow>& rows) {
  QList<QAction*> added;
  for (const ActionRow& row : rows) {
    if (row.name == nullptr) {
      menu->addSeparator();
      continue;
    }
    added << actions.add(menu, row.name, row.text, row.keys, row.work, row.recorded);
    if (!row.icon_text.isEmpty()) added.back()->setIconText(row.icon_text);
  }
  return added;
}

/// An action that is on or off. @param take gets which
inline QAction* add_toggle(ActionList& actions, QMenu* menu, const QString& name, const QString& text,
                           const QList<QKeySequence>& keys, std::function<void(bool on)> take,
                           Recorded recorded = Recorded::AsAction) {
  const auto toggle = [&actions, name, take = std::move(take)] { take(actions.find(name)->isChecked()); };
  QAction* action = actions.add(menu, name, text, keys, toggle, recorded);
  action->setCheckable(true);
  return action;
}

/// What the pointer does from then on.
inline QAction* add_mode(ToolHost& host, ActionList& actions, MenuId menu, const QString& mode, const QString& text,
                         const QString& key = {}) {
  return actions.add_mode(actions.menu(menu), mode, text, key, [&host, mode] { host.set_mode(mode); });
}

}  // namespace croquis::app
