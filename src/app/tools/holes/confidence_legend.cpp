// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/holes/confidence_legend.h"

#include "croquis/render/value_color.h"

namespace croquis::app {

ConfidenceLegend::ConfidenceLegend(QWidget* views)
    : Legend(views, "confidence-legend", tr("Confidence"), tr("Colours of patches by confidence"),
             static_cast<int>(render::value_legend().size())) {}

void ConfidenceLegend::draw_row(QPainter& painter, int row, int y) {
  const auto samples = render::value_legend();
  // As scales stand: much above.
  const render::ValueSample& sample = samples[samples.size() - 1 - static_cast<std::size_t>(row)];
  painter.fillRect(QRect(10, y, 22, row_height), QColor(sample.color.r, sample.color.g, sample.color.b));
  draw_label(painter, y, QString::fromStdString(sample.label));
}

}  // namespace croquis::app
