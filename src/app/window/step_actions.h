// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/tools/tool.h"
#include "app/window/action_list.h"

namespace croquis::app {

// What people do to objects and to the steps of their chains. All of it is about the object or step that is selected.

/// Steps in the menu Modify; objects in Edit and View.
void add_step_actions(ToolHost& host, ActionList& actions);
void add_object_actions(ToolHost& host, ActionList& actions, QMenu* menu);
void add_visibility_actions(ToolHost& host, ActionList& actions, QMenu* menu);

/// What can be done with what is selected now.
void enable_step_actions(ToolHost& host);

/// What can be done about a finding, once the step that it is about is selected.
std::vector<QAction*> fixes_of(const ToolHost& host, const NodeFinding& found);

/// The menu of a row of the list. @param step of a step of a chain
void show_step_menu(ToolHost& host, bool step, const QPoint& at);

}  // namespace croquis::app
