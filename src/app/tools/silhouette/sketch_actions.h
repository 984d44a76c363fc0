// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/tools/silhouette/sketch_chips.h"
#include "app/tools/tool.h"
#include "croquis/tools/silhouette/sketch_tool.h"

namespace croquis::app {

class ReadingStrip;

/// What menus and keys do with a sketch.
/// @param tube_share that a choice is written to, of the view's diagonal
void add_sketch_actions(ToolHost& host, SketchTool& tool, SketchChips& chips, ReadingStrip& readings,
                        double& tube_share, ActionList& actions);

/// @param has_view the sketch is the one worked on in its view
void enable_sketch_actions(ToolHost& host, const SketchTool& tool, bool has_view);

}  // namespace croquis::app
