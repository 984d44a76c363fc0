// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/elided_label.h"

#include <QPainter>
#include <QStyle>

namespace croquis::app {

ElidedLabel::ElidedLabel(QWidget* parent) : QLabel(parent) {
  setTextFormat(Qt::PlainText);
  setMinimumWidth(1);  // else the whole text is the least width
}

void ElidedLabel::show_text(const QString& text, const QString& more) {
  more_ = more;
  setText(text);
  follow_width();
}

QString ElidedLabel::seen() const { return fontMetrics().elidedText(text(), Qt::ElideRight, contentsRect().width()); }

void ElidedLabel::follow_width() { setToolTip(more_.isEmpty() && seen() != text() ? text() : more_); }

void ElidedLabel::resizeEvent(QResizeEvent* event) {
  QLabel::resizeEvent(event);
  follow_width();
}

void ElidedLabel::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  style()->drawItemText(&painter, contentsRect(), static_cast<int>(alignment()), palette(), isEnabled(), seen(),
                        foregroundRole());
}

}  // namespace croquis::app
