// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QWidget;

namespace croquis::app {

/// Below the tooltips of a window's tools a moving picture shows the tool at work in the real window, where there is
/// one (src/app/movies, made by scripts/movies). It never takes the pointer or the keyboard, and goes when the pointer
/// leaves the button. After all buttons have been made.
void add_tool_movies(QWidget& window);

}  // namespace croquis::app
