// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/views/legend.h"

namespace croquis::app {

/// The colours of patches with their confidence.
class ConfidenceLegend : public Legend {
  Q_OBJECT

 public:
  explicit ConfidenceLegend(QWidget* views);

 protected:
  void draw_row(QPainter& painter, int row, int y) override;
};

}  // namespace croquis::app
