// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QWidget>

#include <catch2/catch.hpp>

#include "app/window/help_line.h"

namespace croquis::test {

/// Everything of these kinds that is seen has the room that it needs, inside of the window.
template <typename Widget>
void check_not_clipped(const QWidget& window) {
  for (const Widget* widget : window.findChildren<Widget*>()) {
    if (!widget->isVisible() || widget->visibleRegion().isEmpty()) continue;
    INFO(widget->objectName().toStdString() << " " << widget->metaObject()->className());
    CHECK(widget->width() >= widget->minimumSizeHint().width());
    const QRect there(widget->mapTo(&window, QPoint(0, 0)), widget->size());
    CHECK(there.left() >= 0);
    CHECK(there.right() < window.width());
  }
}

/// No label that is seen is narrower than its words; the lines that may end in dots don't count.
inline void check_labels_fit(const QWidget& window) {
  for (const QLabel* label : window.findChildren<QLabel*>()) {
    if (!label->isVisible() || qobject_cast<const app::ElidedLabel*>(label) != nullptr) continue;
    INFO(label->objectName().toStdString() << ": " << label->text().toStdString());
    CHECK(label->width() >= label->minimumSizeHint().width());
  }
}

}  // namespace croquis::test
