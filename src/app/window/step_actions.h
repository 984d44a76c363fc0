// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMenu>
#include <map>
#include <string>
#include <vector>

#include "app/tools/tool.h"
#include "app/window/action_list.h"

namespace croquis::app {

/// What people do to objects and to the steps of their chains: the menu Object, and the menus of the list's rows. All
/// of it is about the object or step that is selected.
class StepActions {
 public:
  StepActions(ToolHost& host, ActionList& actions);

  /// What can be done with what is selected now.
  void refresh();

  /// What can be done about a finding, once the step that it is about is selected.
  std::vector<QAction*> fixes_of(const NodeFinding& found) const;

  /// The menu of a row. @param step of a step of a chain
  void show_menu(bool step, const QPoint& at);

 private:
  void add(ActionList& actions, QMenu* menu, const QString& name, const QString& text, const QString& key,
           std::function<void(Studio&, NodeId)> work);
  void add_operations(ActionList& actions, QMenu* menu);
  void enable(const QString& name, bool enabled);

  ToolHost& host_;
  QMenu* added_ = nullptr;  ///< the operations that can be added
  std::map<std::string, QAction*> operations_;
};

}  // namespace croquis::app
