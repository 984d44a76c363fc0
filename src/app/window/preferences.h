// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace croquis::app {

class MainWindow;

/// Gives a new window the keys and the way to navigate that people chose.
void apply_preferences(MainWindow& window);

/// The window where they are chosen. Changes work at once, and are kept.
void show_preferences(MainWindow& window);

}  // namespace croquis::app
