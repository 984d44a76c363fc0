// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/chip_places.h"

#include <QLabel>
#include <QWidget>

namespace croquis::app {
namespace {

constexpr double legend_margin = 10;

}  // namespace

const ViewPane& ChipPlaces::scene_pane() const {
  return layout_.pane(layout_.alone() >= 0 ? layout_.alone() : PerspectiveView);
}

void ChipPlaces::put(QWidget& chip, const QPointF& at, const QRectF& bounds) {
  const auto place = space_.take(QRect(at.toPoint(), chip.size()), bounds.toAlignedRect());
  if (place) chip.move(place->topLeft());
  chip.setVisible(place.has_value());
}

void ChipPlaces::put(QWidget& chip, const QPointF& at) { put(chip, at, views_.rect()); }

void ChipPlaces::put_legend(QWidget& legend, bool shown) {
  const ViewPane& pane = scene_pane();
  if (!shown || !pane.visible()) return legend.hide();
  put(legend, QPointF(pane.rect.right() - legend.width(), pane.rect.bottom() - legend.height()) -
                  QPointF(legend_margin, legend_margin));
}

QLabel* make_chip_label(QWidget& views, const char* style) {
  auto* made = new QLabel(&views);
  made->setAttribute(Qt::WA_TransparentForMouseEvents);
  made->setStyleSheet(style);
  made->hide();
  return made;
}

}  // namespace croquis::app
