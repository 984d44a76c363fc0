// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/panel_docks.h"

#include <QDockWidget>
#include <QEvent>
#include <QMainWindow>
#include <QScreen>
#include <QSettings>
#include <QVBoxLayout>
#include <QWidget>
#include <algorithm>
#include <utility>

namespace croquis::app {
namespace {

constexpr int usual_title_bar = 40;  // logical pixels

const QString geometry_key = QStringLiteral("window/geometry");
const QString panels_key = QStringLiteral("window/panels");
const QString closed_key = QStringLiteral("window/closed-panels");
const QString layouts_key = QStringLiteral("window/layouts");
const QString shares_key = QStringLiteral("window/pane-shares");

}  // namespace

PanelDocks::PanelDocks(QMainWindow& window) : QObject(&window), window_(window) {}

QDockWidget* PanelDocks::add(const QString& title, QWidget* content, const QString& name) {
  auto* dock = new QDockWidget(title, &window_);
  dock->setObjectName(name + "-dock");
  dock->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetClosable);
  dock->setWidget(content);
  dock->installEventFilter(this);
  window_.addDockWidget(Qt::RightDockWidgetArea, dock);
  panels_ << Panel{dock};
  apply(panels_.back());
  return dock;
}

QDockWidget* PanelDocks::add_column(const QString& title, QWidget* content, const QString& name) {
  auto* parts = new QWidget(&window_);
  auto* column = new QVBoxLayout(parts);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  column->addWidget(content);
  return add(title, parts, name);
}

void PanelDocks::add_to_column(const QString& name, QWidget* more) {
  static_cast<QVBoxLayout*>(find(name)->widget()->layout())->addWidget(more, 1);
}

void PanelDocks::split_below(const QString& name, QDockWidget* dock) {
  window_.splitDockWidget(find(name), dock, Qt::Vertical);
}

void PanelDocks::tabify(const QString& name, QDockWidget* dock) { window_.tabifyDockWidget(find(name), dock); }

QDockWidget* PanelDocks::find(const QString& name) const {
  const auto found =
      std::ranges::find_if(panels_, [&](const Panel& panel) { return panel.dock->objectName() == name + "-dock"; });
  return found == panels_.end() ? nullptr : found->dock;
}

void PanelDocks::keep_in_front(QDockWidget* dock) {
  if (Panel* panel = panel_of(dock)) panel->in_front = true;
}

void PanelDocks::show_tool_panel(QDockWidget* dock, bool useful, int width) {
  Panel* panel = panel_of(dock);
  if (panel == nullptr) return;
  const bool was_shown = !dock->isHidden();
  panel->in_front = true;
  set_useful(dock, useful);
  if (dock->isHidden()) return;
  if (!was_shown) dock->raise();
  if (room_given_ || roomy_.contains(dock)) return;
  roomy_ << dock;
  constexpr int most = 600, least = 80;
  window_.resizeDocks({dock}, {width}, Qt::Horizontal);
  window_.resizeDocks({find("objects"), dock, find("findings")}, {least, most, least}, Qt::Vertical);
}

void PanelDocks::set_room_given(bool given) {
  room_given_ = given;
  roomy_.clear();
}

void PanelDocks::give_first_sizes() {
  const QList<QDockWidget*> own = all().mid(0, 3);
  window_.resizeDocks(own, {170, 480, 110}, Qt::Vertical);
  window_.resizeDocks(own, {310, 310, 310}, Qt::Horizontal);
}

QList<QDockWidget*> PanelDocks::all() const {
  QList<QDockWidget*> docks;
  for (const Panel& panel : panels_) docks << panel.dock;
  return docks;
}

PanelDocks::Panel* PanelDocks::panel_of(const QDockWidget* dock) {
  const auto found = std::ranges::find(panels_, dock, &Panel::dock);
  return found == panels_.end() ? nullptr : &*found;
}

void PanelDocks::apply(const Panel& panel) {
  const bool visible = shown_ && panel.useful && panel.wanted;
  if (panel.dock->isHidden() == visible) panel.dock->setVisible(visible);
}

void PanelDocks::set_useful(QDockWidget* dock, bool useful) {
  Panel* panel = panel_of(dock);
  if (panel == nullptr) return;
  if (panel->useful != useful) note_layout();
  panel->useful = useful;
  apply(*panel);
}

void PanelDocks::set_wanted(QDockWidget* dock, bool wanted) {
  Panel* panel = panel_of(dock);
  if (panel == nullptr) return;
  const bool changed = panel->wanted != wanted;
  panel->wanted = wanted;
  apply(*panel);
  if (changed) emit wanted_changed(dock, wanted);
}

QStringList PanelDocks::closed() const {
  QStringList names;
  for (const Panel& panel : panels_) {
    if (!panel.wanted) names << panel.dock->objectName();
  }
  return names;
}

void PanelDocks::set_closed(const QStringList& names) {
  for (QDockWidget* dock : all()) set_wanted(dock, !names.contains(dock->objectName()));
}

void PanelDocks::show_all(bool shown) {
  shown_ = shown;
  for (const Panel& panel : panels_) apply(panel);
  for (const Panel& panel : panels_) {
    if (panel.in_front && !room_given_ && !panel.dock->isHidden()) panel.dock->raise();
  }
}

QString PanelDocks::useful() const {
  QStringList names{"panels"};
  for (const Panel& panel : panels_) {
    if (panel.useful && panel.in_front) names << panel.dock->objectName();
  }
  return names.join(' ');
}

void PanelDocks::note_layout() {
  if (shown_ && useful() == noted_) layouts_[noted_] = window_.saveState();
}

void PanelDocks::follow_layout() {
  const QString now = useful();
  if (!shown_ || now == std::exchange(noted_, now) || !layouts_.contains(now)) return;
  window_.restoreState(layouts_[now].toByteArray());
  for (const Panel& panel : panels_) apply(panel);
}

/// Docks are closed by people alone: the window hides them.
bool PanelDocks::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Close) {
    if (auto* dock = qobject_cast<QDockWidget*>(watched)) set_wanted(dock, false);
  }
  return QObject::eventFilter(watched, event);
}

std::optional<WindowLayout> kept_layout() {
  const QSettings settings;
  if (!settings.contains(geometry_key)) return std::nullopt;
  return WindowLayout{settings.value(geometry_key).toByteArray(), settings.value(panels_key).toByteArray(),
                      settings.value(closed_key).toStringList(), settings.value(layouts_key).toMap(),
                      settings.value(shares_key).toPointF()};
}

void keep_layout(const WindowLayout& layout) {
  QSettings settings;
  settings.setValue(geometry_key, layout.geometry);
  settings.setValue(panels_key, layout.panels);
  settings.setValue(closed_key, layout.closed_panels);
  settings.setValue(layouts_key, layout.layouts);
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
