// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "app/tools/tool.h"

namespace croquis::app {

/// The tools of a window, in the order of their menus and buttons; an event goes to the first that works in its view.
std::vector<std::unique_ptr<Tool>> all_tools(ToolHost& host);

}  // namespace croquis::app
