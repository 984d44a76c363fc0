// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QPointF>
#include <QSize>
#include <QStringList>
#include <optional>

class QWidget;

namespace croquis::app {

/// How the window lay when it was closed, as the user's settings keep it.
struct WindowLayout {
  QByteArray geometry;        ///< QWidget::saveGeometry
  QByteArray panels;          ///< QMainWindow::saveState, of the views
  QStringList closed_panels;  ///< their names
  QPointF pane_shares;        ///< PaneLayout::shares
};

/// Nothing when none was kept.
std::optional<WindowLayout> kept_layout();
void keep_layout(const WindowLayout& layout);
void forget_layout();

/// Makes a window no larger than the free part of its screen, its frame included, and moves it in there.
void fit_to_screen(QWidget& window);

}  // namespace croquis::app
