// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/window_layout.h"

#include <QScreen>
#include <QSettings>
#include <QWidget>
#include <algorithm>

namespace croquis::app {
namespace {

constexpr int usual_title_bar = 40;  // logical pixels

const QString geometry_key = QStringLiteral("window/geometry");
const QString panels_key = QStringLiteral("window/panels");
const QString closed_key = QStringLiteral("window/closed-panels");
const QString shares_key = QStringLiteral("window/pane-shares");

}  // namespace

std::optional<WindowLayout> kept_layout() {
  const QSettings settings;
  if (!settings.contains(geometry_key)) return std::nullopt;
  return WindowLayout{settings.value(geometry_key).toByteArray(), settings.value(panels_key).toByteArray(),
                      settings.value(closed_key).toStringList(), settings.value(shares_key).toPointF()};
}

void keep_layout(const WindowLayout& layout) {
  QSettings settings;
  settings.setValue(geometry_key, layout.geometry);
  settings.setValue(panels_key, layout.panels);
  settings.setValue(closed_key, layout.closed_panels);
  settings.setValue(shares_key, layout.pane_shares);
}

void forget_layout() { QSettings().remove(QStringLiteral("window")); }

void fit_to_screen(QWidget& window) {
  if (window.isMaximized() || window.isFullScreen()) return;
  const QScreen* screen = window.screen();
  if (screen == nullptr) return;
  const QRect free = screen->availableGeometry();
  // Nothing before it is shown, and with some desktops for a while after: then a title bar's height is left free.
  const QSize known = window.frameGeometry().size() - window.size();
  const QSize frame = known.height() > 0 ? known : QSize(0, usual_title_bar);
  const QSize size = window.size().boundedTo(free.size() - frame);
  if (size != window.size()) window.resize(size);
  const QRect outer(window.pos(), size + known);
  if (free.contains(outer)) return;
  window.move(std::clamp(outer.left(), free.left(), std::max(free.left(), free.right() + 1 - outer.width())),
              std::clamp(outer.top(), free.top(), std::max(free.top(), free.bottom() + 1 - outer.height())));
}

}  // namespace croquis::app
