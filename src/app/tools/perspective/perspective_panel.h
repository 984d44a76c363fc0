// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "app/panels/panel.h"
#include "app/tools/perspective/sheet_interaction.h"

namespace croquis::app {

/// What the panel needs of its tool, beside the sheet.
struct PerspectivePanelHost {
  std::function<QAction*(const QString&)> action;   ///< of the window, by its name: buttons do what menus and keys do
  std::function<void(const recorded::Step&)> take;  ///< by the sheet's tool, recorded
  std::function<void(const std::string& name, const ParameterValue&)> set_parameter;  ///< of the operation
  std::function<void(const std::string& stroke)> choose;                              ///< it is selected
  std::function<void(double opacity)> overlay;  ///< of the drawing over the solid, 0 to 1
};

/// The groups of strokes, the camera that was found, what is known, and which lines miss their vanishing point.
Panel* make_perspective_panel(SheetInteraction& sheet, const PerspectivePanelHost& host);

}  // namespace croquis::app
