// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QKeySequence>
#include <QList>
#include <QMenu>
#include <functional>
#include <vector>

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

}  // namespace croquis::app
