// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/perspective/pen_entry.h"

#include <QKeyEvent>
#include <algorithm>
#include <utility>

namespace croquis::app {
namespace {

constexpr int entry_width = 150;  // logical pixels
constexpr QPoint beside_pen(14, 12);
constexpr const char* entry_style =
    "QLineEdit { background: white; color: #1c1c1e; border: 2px solid %1; border-radius: 5px; padding: 3px 6px }";

}  // namespace

PenEntry::PenEntry(QWidget* views) : QLineEdit(views) {
  setObjectName("perspective-entry");
  setFixedWidth(entry_width);
  hide();
}

void PenEntry::ask(const QPointF& at, const QString& title, const QString& text, Take take) {
  take_ = std::move(take);
  setPlaceholderText(title);
  setToolTip(title);
  setAccessibleName(title);
  setText(text);
  show_wrong(false);
  adjustSize();
  const QRect room = parentWidget()->rect();
  const QPoint wanted = at.toPoint() + beside_pen;
  move(std::clamp(wanted.x(), 0, std::max(0, room.width() - width())),
       std::clamp(wanted.y(), 0, std::max(0, room.height() - height())));
  show();
  raise();
  setFocus(Qt::OtherFocusReason);
  selectAll();
}

void PenEntry::show_wrong(bool wrong) { setStyleSheet(QString(entry_style).arg(wrong ? "#d63c34" : "#f28c28")); }

/// No key is a menu's shortcut while something is typed.
bool PenEntry::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    event->accept();
    return true;
  }
  return QLineEdit::event(event);
}

void PenEntry::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) return close_entry();
  if (event->key() != Qt::Key_Return && event->key() != Qt::Key_Enter) {
    show_wrong(false);
    return QLineEdit::keyPressEvent(event);
  }
  if (take_ && !take_(text())) return show_wrong(true);
  close_entry();
}

void PenEntry::focusOutEvent(QFocusEvent* event) {
  QLineEdit::focusOutEvent(event);
  if (isVisible()) close_entry();
}

void PenEntry::close_entry() {
  take_ = nullptr;
  hide();
  parentWidget()->setFocus(Qt::OtherFocusReason);
  emit finished();
}

}  // namespace croquis::app
