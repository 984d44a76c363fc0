// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QRectF>

#include "app/views/chip_space.h"
#include "app/views/pane_layout.h"

class QLabel;
class QWidget;

namespace croquis::app {

/// Where labels and buttons over the views go. None covers another; one that finds no place is hidden.
class ChipPlaces {
 public:
  ChipPlaces(const PaneLayout& layout, QWidget& views) : layout_(layout), views_(views) {}

  const PaneLayout& layout() const { return layout_; }

  /// The view that tells of the whole scene: the one alone, else the perspective view.
  const ViewPane& scene_pane() const;

  /// Shows the chip at the free place nearest to the wanted one, within bounds of the views' widget.
  void put(QWidget& chip, const QPointF& at, const QRectF& bounds);

  /// The same within the whole widget.
  void put(QWidget& chip, const QPointF& at);

  /// In the lower right corner of the scene's view, or hidden.
  void put_legend(QWidget& legend, bool shown);

 private:
  const PaneLayout& layout_;
  QWidget& views_;
  ChipSpace space_;
};

/// A label over the views that lets the pointer through. @param style a style sheet
QLabel* make_chip_label(QWidget& views, const char* style);

}  // namespace croquis::app
