// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "app/panels/panel.h"
#include "app/tools/surface/network_interaction.h"

namespace croquis::app {

/// What is selected of a network, in numbers: patches, curves with their slopes, points; and how well the surfaces keep
/// to it all.
/// @param action finds the window's actions by name: buttons do what menus and keys do
Panel* make_surface_panel(NetworkInteraction& network, const std::function<QAction*(const QString&)>& action);

}  // namespace croquis::app
