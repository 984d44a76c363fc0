// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/backdrop/backdrop_tool.h"
#include "app/tools/history/history_tool.h"
#include "app/tools/holes/hole_filling_tool.h"
#include "app/tools/measure/measuring_tool.h"
#include "app/tools/mesh/mesh_editing_tool.h"
#include "app/tools/perspective/perspective_drawing_tool.h"
#include "app/tools/silhouette/silhouette_tool.h"
#include "app/tools/subdivision/subdivision_tool.h"
#include "app/tools/surface/surface_drawing_tool.h"
#include "app/tools/tool.h"

namespace croquis::app {

std::vector<std::unique_ptr<Tool>> all_tools(ToolHost& host) {
  std::vector<std::unique_ptr<Tool>> tools;
  tools.push_back(std::make_unique<HistoryTool>(host));  // its panel is beside those of the window
  tools.push_back(std::make_unique<SilhouetteTool>(host));
  tools.push_back(std::make_unique<PerspectiveDrawingTool>(host));
  tools.push_back(std::make_unique<SurfaceDrawingTool>(host));
  tools.push_back(std::make_unique<MeshEditingTool>(host));
  tools.push_back(std::make_unique<SubdivisionTool>(host));
  tools.push_back(std::make_unique<HoleFillingTool>(host));
  tools.push_back(std::make_unique<MeasuringTool>(host));
  tools.push_back(std::make_unique<BackdropTool>(host));
  return tools;
}

}  // namespace croquis::app
